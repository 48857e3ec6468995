//! `micromath`: unit normals by its reciprocal square root, a shift and a subtraction.

use micromath::F32Ext;

use crate::arithmetic::{cross3, dot3, minus3};
use crate::shape::{Triangle, Vec3};

impl Triangle<f32> {
    /// A normal of length about 1, by the reciprocal square root of `micromath`; `None` if the
    /// computed cross product is zero. Needs the feature `micromath`.
    ///
    /// *When to choose it*: on a core without an FPU, if a few percent of length do not matter, as
    /// in shading, sorting, or a push along the normal. `unit_normal` is accurate, and takes many
    /// times the instructions there.
    ///
    /// *Geometry*: seen from the side that the normal points to, the vertices go counterclockwise.
    /// [`Hit::oriented`](crate::Hit::oriented) turns it toward the ray.
    ///
    /// *Numerics*: rounded. The length is 0.965 to 1.035. The direction is that of the cross
    /// product in `f32`: accurate to 4e-6 rad if the angle at the first vertex has a sine above
    /// 0.1, and arbitrary for slivers whose cross product cancels.
    ///
    /// *Range*: |(b − a) × (c − a)| between 2^-62 and 2^63; `None` below a half of that, and from twice
    /// that on.
    ///
    /// *Panics*: never. *Cost*: twelve multiplications, eleven additions and subtractions; no
    /// square root, no division.
    ///
    /// ```
    /// use septum::Triangle;
    ///
    /// let ramp = Triangle::new([0.0_f32; 3], [4.0, 0.0, 3.0], [0.0, 1.0, 0.0])?;
    /// let n = ramp.unit_normal_fast().unwrap();
    /// assert!((n.x + 0.6).abs() < 0.03 && n.y == 0.0 && (n.z - 0.8).abs() < 0.03);
    /// # Ok::<(), septum::ShapeError>(())
    /// ```
    #[inline]
    #[must_use]
    pub fn unit_normal_fast(&self) -> Option<Vec3<f32>> {
        let [a, b, c] = self.points();
        let n = cross3(&minus3(&b, &a), &minus3(&c, &a));
        let square = dot3(&n, &n);
        if !(f32::MIN_POSITIVE..f32::INFINITY).contains(&square) {
            return None;
        }
        let scale = square.invsqrt();
        Some(Vec3::new(n[0] * scale, n[1] * scale, n[2] * scale))
    }
}
