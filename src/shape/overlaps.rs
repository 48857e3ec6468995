//! The trait `Overlaps`, and its methods on the shapes.

/// Whether two shapes have a point in common: the trait for generic code.
///
/// It is implemented for each supported pair, in both orders. The shapes have inherent methods of
/// the same names, which need no import.
///
/// ```
/// use septum::{Aabb, Overlaps, Segment, Triangle};
///
/// fn count<T: Overlaps<Aabb<f32>>>(shapes: &[T], cell: &Aabb<f32>) -> usize {
///     shapes.iter().filter(|shape| shape.overlaps(cell)).count()
/// }
/// # let cell = Aabb::from_min_max([0.0; 3], [1.0; 3])?;
/// # let t = Triangle::new([1.0; 3], [2.0; 3], [2.0, 3.0, 2.0])?;
/// # assert_eq!(count(&[t], &cell), 1);
/// # assert_eq!(count(&[Segment::new([2.0; 3], [3.0; 3])?], &cell), 0);
/// # Ok::<(), septum::ShapeError>(())
/// ```
#[diagnostic::on_unimplemented(
    message = "septum has no overlap test for `{Self}` and `{Other}`",
    label = "no such pair",
    note = "both shapes need the same scalar; the page of each shape lists its pairs"
)]
pub trait Overlaps<Other> {
    /// Do the two closed shapes have a point in common? Exact.
    #[must_use]
    #[doc(alias = "intersects")]
    fn overlaps(&self, other: &Other) -> bool;

    /// May the two shapes have a point in common? Never `false` if they have.
    ///
    /// It costs no more than [`overlaps`](Self::overlaps), but for oriented boxes where functions compute
    /// floats. A pair without a cheaper test answers by the exact one.
    #[must_use]
    #[doc(alias = "intersects")]
    #[inline]
    fn may_overlap(&self, other: &Other) -> bool {
        self.overlaps(other)
    }
}

/// Inherent `overlaps` and `may_overlap` for a shape.
///
/// A macro, so that every shape's page shows them in the same form, right after the constructors.
macro_rules! overlaps_methods {
    ($shape:ident $(<$life:lifetime>)?, $others:literal) => {
        impl<S> $shape<$($life,)? S> {
            #[doc = concat!("Does the shape have a point in common with ", $others, "?")]
            ///
            /// Exact for every valid input; touching is overlap; never panics. Each implementation
            /// of [`Overlaps`](crate::Overlaps) documents numerics, range and cost of its pair.
            #[doc(alias = "intersects")]
            #[must_use]
            #[inline]
            pub fn overlaps<Other>(&self, other: &Other) -> bool
            where
                Self: $crate::shape::Overlaps<Other>,
            {
                $crate::shape::Overlaps::overlaps(self, other)
            }

            /// May the two shapes have a point in common? Never `false` if they have.
            ///
            /// It never panics, and costs no more than [`overlaps`](Self::overlaps), but for oriented
            /// boxes where functions compute floats. Each implementation of
            /// [`Overlaps`](crate::Overlaps) says when its pair answers `true` for disjoint shapes.
            #[doc(alias = "intersects")]
            #[must_use]
            #[inline]
            pub fn may_overlap<Other>(&self, other: &Other) -> bool
            where
                Self: $crate::shape::Overlaps<Other>,
            {
                $crate::shape::Overlaps::may_overlap(self, other)
            }
        }
    };
}
pub(super) use overlaps_methods;
