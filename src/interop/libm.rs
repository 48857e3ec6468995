//! `libm`: unit normals by its correctly rounded root.

use crate::query::direction;
use crate::shape::{Triangle, Vec3};

/// n/|n|, each of the operations rounded once.
#[inline]
fn unit([x, y, z]: [f64; 3]) -> [f64; 3] {
    let length = libm::sqrt(x * x + y * y + z * z);
    [x / length, y / length, z / length]
}

impl Triangle<f32> {
    /// The unit normal (b − a) × (c − a) / |(b − a) × (c − a)| by the root of `libm`;
    /// `None` if the triangle is degenerate. With the feature `libm`.
    ///
    /// *When to choose it*: wherever there is an FPU for `f64`, and wherever a normal
    /// must be right. On a core without one, `unit_normal_fast` costs about a fifth.
    ///
    /// *Geometry*: the normal points to where the vertices go counterclockwise;
    /// [`Hit::oriented`](crate::Hit::oriented) turns it to the ray.
    ///
    /// *Numerics*: each component is within 0.51 units of its own last place of the
    /// truth, whatever the triangle: it is computed in `f64`, and where a cross
    /// product cancels, in pairs of `f64`, at last in exact sums. The same bits on
    /// every machine.
    ///
    /// *Range*: all finite coordinates. *Panics*: never. *Cost*: in `f64`, nine
    /// multiplications, a root and three divisions. Exact sums, for one sliver in many,
    /// take a hundred times as long and 7 KB of stack.
    ///
    /// ```
    /// use septum::{Triangle, Vec3};
    ///
    /// let ramp = Triangle::new([0.0_f32; 3], [4.0, 0.0, 3.0], [0.0, 1.0, 0.0])?;
    /// assert_eq!(ramp.unit_normal(), Some(Vec3::new(-0.6, 0.0, 0.8)));
    /// # Ok::<(), septum::ShapeError>(())
    /// ```
    #[must_use]
    pub fn unit_normal(&self) -> Option<Vec3<f32>> {
        let [a, b, c] = self.vertices();
        let wide = |p: &Vec3<f32>| Vec3::new(p.x.into(), p.y.into(), p.z.into());
        let wide = Triangle::unchecked([wide(a), wide(b), wide(c)]);
        // With up to 16 places cancelled, 5·2^16 roundoffs of an f64 are under a
        // thousandth of one of an f32.
        let [x, y, z] = unit(direction(&wide, 65536.0)?);
        Some(Vec3::new(x as f32, y as f32, z as f32))
    }
}

impl Triangle<f64> {
    /// The unit normal (b − a) × (c − a) / |(b − a) × (c − a)| by the root of `libm`;
    /// `None` if the triangle is degenerate. With the feature `libm`.
    ///
    /// *When to choose it*: there is no other in `f64`.
    ///
    /// *Geometry*: the normal points to where the vertices go counterclockwise;
    /// [`Hit::oriented`](crate::Hit::oriented) turns it to the ray.
    ///
    /// *Numerics*: each component is within 6 units of its own last place of the
    /// truth, whatever the triangle; the largest error seen is 2.8. The cross product
    /// is computed in pairs of floats, and where that does not do, in exact sums. The
    /// same bits on every machine.
    ///
    /// *Range*: all finite coordinates. *Panics*: never. *Cost*: about 250 additions
    /// and multiplications, a root and three divisions. Exact sums, for slivers that
    /// lose 40 places to cancellation and for coordinates beyond 2⁻⁴⁰⁰ or 2²⁵⁰, take
    /// eighty times as long and some 7 KB of stack.
    ///
    /// ```
    /// use septum::{Triangle, Vec3};
    ///
    /// let ramp = Triangle::new([0.0_f64; 3], [4.0, 0.0, 3.0], [0.0, 1.0, 0.0])?;
    /// assert_eq!(ramp.unit_normal(), Some(Vec3::new(-0.6, 0.0, 0.8)));
    /// # Ok::<(), septum::ShapeError>(())
    /// ```
    #[must_use]
    pub fn unit_normal(&self) -> Option<Vec3<f64>> {
        // Six roundoffs at most. Relative to each component: one in it; in the length
        // one from the components, one and a half from squares and sums, one from
        // the root; one from the division.
        Some(unit(direction(self, 0.0)?).into())
    }
}
