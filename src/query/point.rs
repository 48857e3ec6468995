//! Points against boxes and triangles.
//!
//! An oriented box is bounded by three pairs of faces of a parallelepiped. u_i are the axes, d is the
//! vector from the centre, and w_i = u_j × u_k. By Cramer's rule d = Σ s_i·u_i with s_i =
//! (w_i·d)/(w_0·u_0). So |s_i| exceeds h_i exactly if |w_i·d| exceeds h_i·|w_0·u_0|.

use core::cmp::Ordering;

use super::aabb_aabb::Apart;
use super::orientation::{are_apart, from, in_doubt, sides, size};
use super::relation::{Asked, Relation};
use crate::arithmetic::{Each, Embeds, Number, cross3, dot3, greatest, largest, pick, turn};
use crate::query::triangle_obb::{error_bound, operands, way};
use crate::robust::{ExactSum, Predicate, Uncertain, add_determinant, differences, singles};
use crate::scalar::Scalar;
use crate::shape::{Aabb, AabbForm, Obb, Triangle, Vec3};

impl<S: Scalar> Aabb<S> {
    /// Does the box contain a point?
    ///
    /// *Geometry*: a closed box, in the form in which it was given. No box contains a point with a
    /// NaN or infinite coordinate.
    ///
    /// *Contact*: a point on a face is in the box.
    ///
    /// *Numerics*: exact for every valid input, in every scalar.
    ///
    /// *Range*: all finite floats, all fixed-point values, in the same stages as for two boxes.
    ///
    /// *Panics*: never. *Cost*: 6 comparisons for a box given by its corners; for a box given by
    /// its centre, as for two boxes.
    ///
    /// ```
    /// use septum::Aabb;
    ///
    /// let cell = Aabb::from_center_half_extents([0.5_f32; 3], [0.5; 3])?;
    /// assert!(cell.contains([1.0, 0.0, 0.5]));
    /// assert!(!cell.contains([1.0000001, 0.0, 0.5]));
    /// assert!(!cell.contains([f32::NAN, 0.5, 0.5]));
    /// # Ok::<(), septum::ShapeError>(())
    /// ```
    #[inline]
    #[must_use]
    pub fn contains(&self, point: impl Into<Vec3<S>>) -> bool {
        let p = point.into();
        match self.form() {
            // Comparisons with a NaN are false.
            AabbForm::Corners { min, max } => {
                let holds = |min: S, p: S, max: S| (min <= p) & (p <= max);
                holds(min.x, p.x, max.x) & holds(min.y, p.y, max.y) & holds(min.z, p.z, max.z)
            }
            form @ AabbForm::Center { .. } => {
                // A point is a box of no extent.
                p.is_finite()
                    && !S::evaluate(&Apart::new(form, &AabbForm::Corners { min: p, max: p }))
            }
        }
    }
}

/// The question for the relation of point and triangle.
struct Lies<'a, S> {
    point: [S; 3],
    triangle: &'a Triangle<S>,
}

impl<S: Scalar> Predicate<S> for Lies<'_, S> {
    type Answer = Relation;

    #[inline]
    fn filter<N: Embeds<S>>(&self) -> Option<Relation> {
        let [a, b, c] = self.triangle.points();
        let [a, b, c, point] = N::embed(&[a, b, c, self.point])?;
        let (e, f) = (from::<N>(&b, &a), from::<N>(&c, &a));
        let to_point = [from::<N>(&point, &a)];
        match sides::<N, 1>([&e, &f], &to_point, size::<N, 1>(&to_point))? {
            [0] => in_doubt::<N>(&[point; 3], &[a, b, c], Asked::Overlaps),
            _ => Some(Relation::Disjoint),
        }
    }
}

impl<S: Scalar> Triangle<S> {
    /// Does the triangle contain a point?
    ///
    /// *Geometry*: a closed set, which may be a segment or a point. No triangle contains a point
    /// with a NaN or infinite coordinate.
    ///
    /// *Contact*: a point on an edge is in the triangle.
    ///
    /// *Numerics*: exact for every valid input, in every scalar. Note that a point computed to lie
    /// in a triangle is rounded, and usually lies off its plane.
    ///
    /// *Range*: as for [two triangles](Triangle#impl-Overlaps<Triangle<S>>-for-Triangle<S>). In
    /// floats a point in the plane takes exact integers.
    ///
    /// *Panics*: never. *Cost*: 9 multiplications for a point off the plane.
    ///
    /// ```
    /// use septum::Triangle;
    ///
    /// let t = Triangle::new([0.0_f32, 0.0, 0.0], [4.0, 0.0, 2.0], [0.0, 4.0, 2.0])?;
    /// assert!(t.contains([1.0, 1.0, 1.0]));
    /// assert!(t.contains([2.0, 2.0, 2.0])); // on an edge
    /// assert!(!t.contains([1.0, 1.0, 1.0000001]));
    /// # Ok::<(), septum::ShapeError>(())
    /// ```
    #[inline]
    #[must_use]
    pub fn contains(&self, point: impl Into<Vec3<S>>) -> bool {
        let p = point.into();
        let point = p.to_array();
        p.is_finite()
            && !are_apart(&[point], &self.points())
            && S::evaluate(&Lies { point, triangle: self }) != Relation::Disjoint
    }
}

/// Does a point lie outside an oriented box?
struct Outside<'a, S> {
    point: [S; 3],
    obb: &'a Obb<S>,
}

impl<S: Scalar> Predicate<S> for Outside<'_, S> {
    type Answer = bool;

    #[inline]
    fn filter<N: Embeds<S>>(&self) -> Option<bool> {
        let [c, u, v, w, h] = self.obb.numbers();
        let ([p, c, u, v, w, h], one) = N::embed_with_one(&[self.point, c, u, v, w, h])?;
        let d = way::<N>(p, c);
        let [u, v, w, h] = [u, v, w, h].each(operands::<N>);

        let axes = greatest(greatest(largest(&u), largest(&v)), greatest(largest(&w), one));
        // The same terms as on the face axes of a triangle, with the same roundings.
        let bound = error_bound::<N>(one, axes, largest(&d), largest(&h))?.face;

        let vw = cross3(&v, &w);
        let volume = dot3(&vw, &u).magnitude();
        let faces = [(vw, h[0]), (cross3(&w, &u), h[1]), (cross3(&u, &v), h[2])];
        let mut so_far = Uncertain::NONE;
        for (w, h) in faces {
            let gap = (dot3(&w, &d) * one).magnitude() - h * volume;
            so_far = so_far.or(Uncertain::above(gap, bound));
        }
        so_far.verdict()
    }

    fn exact(&self) -> bool {
        let axes = self.obb.axes_as_arrays().each(singles);
        let half = self.obb.half_extents().to_array();
        let d = differences(&self.point, &self.obb.center().to_array());
        let volume = self.obb.hand();
        (0..3).any(|i| {
            let (i, j, k) = turn(i);
            let h = pick(&half, i).parts();
            [Ordering::Greater, Ordering::Less].into_iter().any(|side| {
                let mut gap = S::SeptumSum::new();
                add_determinant(&mut gap, [pick(&axes, j), pick(&axes, k), &d], Some(S::ONE));
                let h = if volume == side { h.negated() } else { h };
                add_determinant(&mut gap, axes.each_ref(), Some(h));
                gap.sign() == side
            })
        })
    }
}

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

#[cfg(test)]
mod tests {
    use super::*;

    /// Points in and around a corner of a parallelepiped: each stage agrees with exact sums, or has
    /// no answer.
    fn check<S: Scalar>(of: impl Fn(i8) -> S, one_up: impl Fn(S) -> S) {
        let row = |p: [i8; 3]| p.each(&of);
        let axes = [row([2, 1, 0]), row([-1, 2, 0]), row([0, 1, 2])];
        let obb = Obb::from_skewed_axes(row([1, 0, -1]), axes, row([1, 1, 0])).unwrap();
        let (mut settled, mut outside) = (0, 0);
        for n in 0..343_i16 {
            let p = [n % 7 - 3, n / 7 % 7 - 3, n / 49 - 3].each(|x| of(x as i8));
            for i in 0..3 {
                let mut point = p;
                point[i] = one_up(point[i]);
                for point in [p, point] {
                    let question = Outside { point, obb: &obb };
                    let exact = question.exact();
                    let first = S::evaluate_bounded(&question);
                    assert!(first.is_none_or(|answer| answer == exact), "{point:?}");
                    assert_eq!(S::evaluate(&question), exact, "{point:?}");
                    settled += u32::from(first.is_some());
                    outside += u32::from(exact);
                }
            }
        }
        // Some of the 49 points on the grid of its plane lie in the flat box.
        assert!(settled > 1_000 && outside < 3 * 2 * 343, "{settled} settled, {outside} outside");
    }

    #[test]
    fn stages_agree_in_floats() {
        check(f32::from, |x| x + 1e-6 * x.abs());
        check(f64::from, |x| x + 1e-15 * x.abs());
    }

    #[cfg(feature = "fixed")]
    #[test]
    fn stages_agree_in_fixed_point() {
        use fixed::types::{I4F4, I16F16};
        check(I4F4::from_num, |x| x + I4F4::DELTA);
        check(I16F16::from_num, |x| x + I16F16::DELTA);
    }
}
