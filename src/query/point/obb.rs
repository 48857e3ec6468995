//! Point against oriented box: the three pairs of faces of a parallelepiped.
//!
//! u_i are the axes, d is the vector from the centre, and w_i = u_j × u_k. By Cramer's rule d = Σ
//! s_i·u_i with s_i = (w_i·d)/(w_0·u_0). So |s_i| exceeds h_i exactly if |w_i·d| exceeds
//! h_i·|w_0·u_0|.

use core::cmp::Ordering;

use crate::arithmetic::{Each, Embeds, Number, cross3, dot3, greatest, largest, pick, turn};
use crate::query::triangle_obb::{error_bound, operands, way};
use crate::robust::{ExactSum, Predicate, Uncertain, add_determinant, differences, singles};
use crate::scalar::Scalar;
use crate::shape::{Obb, Vec3};

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
