//! Axis-aligned box against axis-aligned box.

mod kernel;
mod relation;

pub(super) use kernel::{Apart, GAP};

use crate::scalar::Scalar;
use crate::shape::{Aabb, Overlaps};

impl<S: Scalar> Overlaps<Aabb<S>> for Aabb<S> {
    /// Do two axis-aligned boxes have a point in common?
    ///
    /// *Geometry*: closed sets in one frame and unit, each in the form in which it was given. The
    /// corners of a box given by its centre may lie between two numbers of the scalar. Either box
    /// may be flat, or a point.
    ///
    /// *Contact*: touching is overlap.
    ///
    /// *Numerics*: exact for every valid input, in every scalar.
    ///
    /// *Range*: all finite floats, all fixed-point values. Exact sums decide floats given by a
    /// centre if rounding leaves contact in doubt, and 64-bit fixed point beyond 2⁶⁰ units in the
    /// last place.
    ///
    /// *Panics*: never.
    ///
    /// *Cost*: 6 comparisons for two boxes given by their corners. Otherwise 12 additions and 9
    /// comparisons, and in floats 3 additions and 3 multiplications for the error bound.
    ///
    /// *Source*: the three face normals of Gottschalk, Lin and Manocha 1996; the
    /// exact stages are ours.
    ///
    /// ```
    /// use septum::Aabb;
    ///
    /// let cell = Aabb::from_min_max([0.0_f32; 3], [1.0; 3])?;
    /// let ball = Aabb::from_center_half_extents([1.5, 0.5, 0.5], [0.5, 9.0, 0.0])?;
    /// assert!(cell.overlaps(&ball)); // they touch where x = 1
    /// let ball = Aabb::from_center_half_extents([1.5, 0.5, 0.5], [0.49999997, 9.0, 0.0])?;
    /// assert!(!cell.overlaps(&ball)); // one unit in the last place apart
    /// # Ok::<(), septum::ShapeError>(())
    /// ```
    #[inline]
    fn overlaps(&self, other: &Aabb<S>) -> bool {
        match (self.given_corners(), other.given_corners()) {
            (Some((a, b)), Some((c, d))) => {
                let meet = |a: S, b: S, c: S, d: S| (a <= d) & (c <= b);
                meet(a.x, b.x, c.x, d.x) & meet(a.y, b.y, c.y, d.y) & meet(a.z, b.z, c.z, d.z)
            }
            _ => !S::evaluate(&Apart::new(self.form(), other.form())),
        }
    }
}
