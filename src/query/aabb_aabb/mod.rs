//! Axis-aligned box against axis-aligned box: the gap between them on each axis, and its sign.

use core::cmp::Ordering;

use crate::arithmetic::{Each, Embeds, Number, compare, greatest};
use crate::query::relation::{Nearness, Reading, Relate, Relation, of_gaps};
use crate::robust::{ExactSum, Predicate, Profile, Uncertain};
use crate::scalar::Scalar;
use crate::shape::{Aabb, AabbForm, Overlaps, Vec3};

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

/// The question for the relation of two boxes.
struct Lie<S>(Apart<S>);

impl<S: Scalar> Predicate<S> for Lie<S> {
    type Answer = Relation;
    const PROFILE: Profile = Profile::AREAS;

    fn filter<N: Embeds<S>>(&self) -> Option<Relation> {
        self.0.by_axes::<N, Nearness>()
    }

    fn exact(&self) -> Relation {
        (0..3).fold(Relation::Overlapping, |so_far, i| so_far.min(of_gaps(self.0.gaps(i))))
    }
}

impl<S: Scalar> Relate<Aabb<S>> for Aabb<S> {
    fn relation(&self, other: &Aabb<S>) -> Relation {
        let (Some((a, b)), Some((c, d))) = (self.given_corners(), other.given_corners()) else {
            return S::evaluate(&Lie(Apart::new(self.form(), other.form())));
        };
        let [a, b, c, d] = [a, b, c, d].each(|p| p.to_array());
        (0..3).fold(Relation::Overlapping, |so_far, i| {
            so_far.min(of_gaps([compare(a[i], d[i]), compare(c[i], b[i])]))
        })
    }
}

/// A box in either form: on each axis, the interval from `low` − `grown` to `high` + `grown`.
#[derive(Clone, Copy)]
pub(in crate::query) struct Grown<S> {
    pub(in crate::query) low: [S; 3],
    pub(in crate::query) high: [S; 3],
    pub(in crate::query) grown: [S; 3],
}

impl<S: Scalar> Grown<S> {
    #[inline(always)]
    fn new(form: &AabbForm<S>) -> Self {
        let (low, high, grown) = match *form {
            AabbForm::Center { center, half } => (center, center, half),
            AabbForm::Corners { min, max } => (min, max, Vec3::splat(S::ZERO)),
        };
        Self { low: low.to_array(), high: high.to_array(), grown: grown.to_array() }
    }
}

/// The question whether two boxes are disjoint.
pub(in crate::query) struct Apart<S> {
    pub(in crate::query) a: Grown<S>,
    pub(in crate::query) b: Grown<S>,
}

impl<S: Scalar> Apart<S> {
    #[inline(always)]
    pub(in crate::query) fn new(a: &AabbForm<S>, b: &AabbForm<S>) -> Self {
        Self { a: Grown::new(a), b: Grown::new(b) }
    }

    /// The signs of the gaps in front of the first box and behind it, on axis `i`.
    fn gaps(&self, i: usize) -> [Ordering; 2] {
        let Self { a, b } = self;
        let gap = |low: S, high: S| {
            let mut gap = S::SeptumSum::new();
            gap.add(&[low.parts()]);
            for x in [high, a.grown[i], b.grown[i]] {
                gap.add(&[x.parts().negated()]);
            }
            gap.sign()
        };
        [gap(a.low[i], b.high[i]), gap(b.low[i], a.high[i])]
    }
}

/// Roundoffs in a gap, per sum of the magnitudes of its two operands.
///
/// A gap is d − r, with d the greater of two differences and r the sum of two half-extents. d, r
/// and the gap each err by a relative u: two roundoffs of |d| + r. The third covers the roundings
/// of |d| + r and of the bound, and terms in u². Sums of floats do not underflow: below twice the
/// least normal number they are exact. Proved in `kernel.g`.
pub(crate) const GAP: u16 = 3;

impl<S: Scalar> Apart<S> {
    #[inline(always)]
    fn by_axes<N: Embeds<S>, R: Reading>(&self) -> Option<R::Answer> {
        let Self { a, b } = self;
        let all = [a.low, a.high, a.grown, b.low, b.high, b.grown];
        let [a_low, a_high, a_grown, b_low, b_high, b_grown] = N::embed(&all)?;
        let mut found = R::NONE;
        for i in 0..3 {
            let (before, after) = (a_low[i] - b_high[i], b_low[i] - a_high[i]);
            let (d, r) = (greatest(before, after), a_grown[i] + b_grown[i]);
            let extent = r + r - (before + after);
            found.add(d - r, extent, (d.magnitude() + r).error(GAP));
        }
        found.answer(N::CERTAIN)
    }
}

impl<S: Scalar> Predicate<S> for Apart<S> {
    type Answer = bool;
    const PROFILE: Profile = Profile::AREAS;

    #[inline(always)]
    fn filter<N: Embeds<S>>(&self) -> Option<bool> {
        self.by_axes::<N, Uncertain>()
    }

    fn exact(&self) -> bool {
        (0..3).any(|i| self.gaps(i).contains(&Ordering::Greater))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Compares all stages with the exact sums, on one axis and close to contact.
    fn check<S: Scalar>(numbers: &[S]) {
        let (mut settled, mut apart) = (0, 0);
        let negative = |x: &S| *x < S::ZERO;
        for &c in numbers {
            for &h in numbers.iter().filter(|x| !negative(x)) {
                for &d in numbers {
                    for &k in numbers.iter().filter(|x| !negative(x)) {
                        let center = |c: S, half: S| AabbForm::Center {
                            center: Vec3::new(c, S::ZERO, S::ZERO),
                            half: Vec3::new(half, S::ZERO, S::ZERO),
                        };
                        let question = Apart::new(&center(c, h), &center(d, k));
                        let exact = question.exact();
                        let first = S::evaluate_bounded(&question);
                        assert!(
                            first.is_none_or(|answer| answer == exact),
                            "{c:?} {h:?} {d:?} {k:?}"
                        );
                        assert_eq!(S::evaluate(&question), exact, "{c:?} {h:?} {d:?} {k:?}");
                        settled += u32::from(first.is_some());
                        apart += u32::from(exact);
                    }
                }
            }
        }
        assert!(settled > 0 && apart > 100, "{settled} settled, {apart} apart");
    }

    #[test]
    fn stages_agree_in_floats() {
        let ulp = f32::EPSILON;
        check(&[-3.0, -1.0, 0.0, 1e-30, 0.5, 1.0 - ulp / 2.0, 1.0, 1.0 + ulp, 2.0_f32]);
        check(&[f32::MIN, -1e38, 0.0, f32::from_bits(1), f32::MIN_POSITIVE, 1e38, f32::MAX]);
        check(&[f64::MIN, -2.0, 0.0, f64::from_bits(1), 1.0, 1.0 + f64::EPSILON, 3.0, f64::MAX]);
    }

    #[cfg(feature = "fixed")]
    #[test]
    fn stages_agree_in_fixed_point() {
        use fixed::types::{I4F4, I16F16, I32F32};
        check(&[-128_i8, -127, -1, 0, 1, 2, 64, 127].map(I4F4::from_bits));
        check(&[i32::MIN, -(1 << 28), -1, 0, 1, 1 << 28, i32::MAX].map(I16F16::from_bits));
        check(&[i64::MIN, -(1 << 60), -1, 0, 1, 1 << 60, i64::MAX].map(I32F32::from_bits));
    }
}
