//! Point against oriented box.

mod kernel;

use kernel::Outside;

use crate::scalar::Scalar;
use crate::shape::{Obb, Vec3};

impl<S: Scalar> Obb<S> {
    /// Does the box contain the point?
    ///
    /// *Geometry*: a closed box, namely the parallelepiped that its numbers describe, also if
    /// rounding left its axes slightly short or skewed. No box contains a point with a coordinate
    /// that is NaN or infinite.
    ///
    /// *Contact*: a point on a face is in the box.
    ///
    /// *Numerics*: exact for every valid input, in every scalar.
    ///
    /// *Range*: all finite floats and all fixed-point values. The fast stage serves the same range
    /// as that of a triangle and an oriented box. Outside, and for floats within rounding of a
    /// face, exact sums decide, a hundred times slower.
    ///
    /// *Panics*: never. *Cost*: about 36 multiplications; fixed point in 128 bits.
    ///
    /// *Source*: Cramer's rule, without its division.
    ///
    /// ```
    /// use septum::Obb;
    ///
    /// let axes = [[0.8, 0.6, 0.0], [-0.6, 0.8, 0.0], [0.0, 0.0, 1.0]];
    /// let tool = Obb::new([10.0, 0.0, 0.0], axes, [2.0, 1.0, 0.5])?;
    /// assert!(tool.contains([11.0, 1.0, 0.5]));
    /// assert!(!tool.contains([11.0, -1.0, 0.0]));
    /// # Ok::<(), septum::ShapeError>(())
    /// ```
    #[inline]
    #[must_use]
    pub fn contains(&self, point: impl Into<Vec3<S>>) -> bool {
        let p = point.into();
        p.is_finite() && !S::evaluate(&Outside { point: p.to_array(), obb: self })
    }
}
