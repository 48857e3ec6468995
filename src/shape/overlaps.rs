//! The question of every pair of shapes.

/// Whether two shapes have a point in common.
///
/// There is an implementation for each pair that can be asked about, in both
/// orders of the arguments. The methods of the same names on the shapes call it,
/// and need no import; the trait is for generic code:
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
pub trait Overlaps<Other> {
    /// Whether the two shapes, as closed sets, have a point in common. Exact.
    #[must_use]
    #[doc(alias = "intersects")]
    fn overlaps(&self, other: &Other) -> bool;

    /// Whether the two shapes may have a point in common: never `false` for shapes
    /// that have one, and never dearer than [`overlaps`](Self::overlaps).
    ///
    /// A pair that has no cheaper test than the exact one answers by that.
    #[must_use]
    #[doc(alias = "intersects")]
    #[inline]
    fn may_overlap(&self, other: &Other) -> bool {
        self.overlaps(other)
    }
}

/// The two methods on a shape itself.
///
/// A macro, so that each shape's page has them in one form, right after its
/// constructors.
macro_rules! overlaps_methods {
    ($shape:ident $(<$life:lifetime>)?, $others:literal) => {
        impl<S> $shape<$($life,)? S> {
            #[doc = concat!("Whether the shape has a point in common with ", $others, ".")]
            ///
            /// Exact for every valid input; touching is overlap; never panics. The
            /// implementations of [`Overlaps`](crate::Overlaps) say for each pair what
            /// there is to know of numerics, range and cost.
            #[doc(alias = "intersects")]
            #[must_use]
            #[inline]
            pub fn overlaps<Other>(&self, other: &Other) -> bool
            where
                Self: $crate::shape::Overlaps<Other>,
            {
                $crate::shape::Overlaps::overlaps(self, other)
            }

            /// Whether the two may have a point in common: never `false` if they have.
            ///
            /// Never panics, and is never dearer than [`overlaps`](Self::overlaps). The
            /// implementations of [`Overlaps`](crate::Overlaps) say for each pair when it
            /// is `true` without need.
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
