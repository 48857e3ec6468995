//! Whether a triangle has a normal at all.

use core::cmp::Ordering;

use crate::query::exact_triangle::ExactTriangle;
use crate::scalar::Scalar;
use crate::shape::Triangle;

impl<S: Scalar> Triangle<S> {
    /// Do the three vertices lie on one line, or in one point?
    ///
    /// *Numerics*: exact for every input. The thinnest sliver is not degenerate.
    ///
    /// *Range*: all finite floats and all fixed-point values.
    ///
    /// *Contact*: no query requires this check. To every query a degenerate triangle is a segment
    /// or a point, and its answer is exact too.
    ///
    /// *Panics*: never. *Cost*: three sums of eight products, by long
    /// accumulation; meant for checking a mesh, not for an inner loop.
    ///
    /// ```
    /// use septum::Triangle;
    ///
    /// // In f32 the cross product of these edges rounds to zero.
    /// let (b, c) = ([1.000122, 1.0, 0.0], [2.000122, 1.999878, 0.0]);
    /// let sliver = Triangle::new([0.0_f32; 3], b, c)?;
    /// assert!(!sliver.is_degenerate());
    /// let segment = Triangle::new([0.0_f32; 3], [1.0, 1.0, 1.0], [3.0, 3.0, 3.0])?;
    /// assert!(segment.is_degenerate());
    /// # Ok::<(), septum::ShapeError>(())
    /// ```
    #[must_use]
    pub fn is_degenerate(&self) -> bool {
        let exact = ExactTriangle::new(&self.points());
        (0..3).all(|i| exact.normal_sign::<S>(i) == Ordering::Equal)
    }
}
