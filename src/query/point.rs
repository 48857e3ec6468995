//! Points against boxes and triangles.
//!
//! An oriented box is bounded by three pairs of faces of a parallelepiped. u_i are the axes, d is the
//! vector from the centre, and w_i = u_j × u_k. By Cramer's rule d = Σ s_i·u_i with s_i =
//! (w_i·d)/(w_0·u_0). So |s_i| exceeds h_i exactly if |w_i·d| exceeds h_i·|w_0·u_0|.

use super::aabb_aabb::Apart;
use super::orientation::{are_apart, from, in_doubt, sides, size};
use super::relation::{Asked, Relation};
use crate::arithmetic::{
    Each, Embeds, Number, REGISTERS_ARE_WIDE, Word, cross3, dot3, greatest, largest,
};
use crate::query::triangle_obb::{Disjoint, error_bound, operands, way};
use crate::robust::{Predicate, Uncertain, in_cut_floats, in_exact_numbers};
use crate::scalar::{FixedBackend, Scalar};
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

impl<S: Scalar> Outside<'_, S> {
    fn triangle(&self) -> Triangle<S> {
        Triangle::unchecked([Vec3::from(self.point); 3])
    }
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

    /// As for a triangle, where integers of the machine do not hold the products of the coordinates.
    #[inline(always)]
    fn in_words(&self, _: bool) -> Option<bool>
    where
        S: FixedBackend,
    {
        let is_long = !REGISTERS_ARE_WIDE || S::Raw::BITS == 64;
        if is_long { Disjoint::new(&self.triangle(), self.obb).in_words(false) } else { None }
    }

    /// On 32-bit cores by the sums of a triangle, for the stack that whole numbers take.
    fn exact(&self) -> bool {
        if REGISTERS_ARE_WIDE {
            in_exact_numbers(self)
        } else {
            Disjoint::new(&self.triangle(), self.obb).is_beyond_a_face()
        }
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
    /// face, exact numbers decide, a hundred times slower.
    ///
    /// *Panics*: never. *Cost*: about 36 multiplications. Fixed point of 64 bits, and all scalars on 32-bit
    /// cores, begin as with a [triangle](Triangle#impl-Overlaps<Obb<S>>-for-Triangle<S>).
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
        let question = Outside { point: p.to_array(), obb: self };
        let in_words = || Disjoint::new(&question.triangle(), self).of_cut_floats();
        let is_outside =
            || in_cut_floats::<S, _>(in_words).unwrap_or_else(|| S::evaluate(&question));
        p.is_finite() && !is_outside()
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
                    let exact = Disjoint::new(&question.triangle(), &obb).exact();
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
