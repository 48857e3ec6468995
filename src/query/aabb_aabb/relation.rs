//! Whether two boxes are disjoint, touch or overlap.

use super::kernel::{Apart, GAP};
use crate::arithmetic::{Embeds, Number, compare, greatest};
use crate::query::relation::{Nearness, Relate, Relation, of_gaps};
use crate::robust::{ExactSum, Predicate, Profile};
use crate::scalar::Scalar;
use crate::shape::Aabb;

/// The question for the relation of two boxes.
struct Lie<S>(Apart<S>);

impl<S: Scalar> Predicate<S> for Lie<S> {
    type Answer = Relation;
    const PROFILE: Profile = Profile::AREAS;

    fn filter<N: Embeds<S>>(&self) -> Option<Relation> {
        let Apart { a, b } = &self.0;
        let all = [a.low, a.high, a.grown, b.low, b.high, b.grown];
        let [a_low, a_high, a_grown, b_low, b_high, b_grown] = N::embed(&all)?;
        let mut found = Nearness::NONE;
        for i in 0..3 {
            let (before, after) = (a_low[i] - b_high[i], b_low[i] - a_high[i]);
            let (d, r) = (greatest(before, after), a_grown[i] + b_grown[i]);
            let extent = r + r - (before + after);
            found.add(d - r, extent, (d.magnitude() + r).error(GAP));
        }
        found.relation(N::CERTAIN)
    }

    fn exact(&self) -> Relation {
        let Apart { a, b } = &self.0;
        let gap = |low: S, high: S, r: S, s: S| {
            let mut gap = S::SeptumSum::new();
            gap.add(&[low.parts()]);
            for x in [high, r, s] {
                gap.add(&[x.parts().negated()]);
            }
            gap.sign()
        };
        (0..3).fold(Relation::Overlapping, |so_far, i| {
            let (r, s) = (a.grown[i], b.grown[i]);
            let gaps = [gap(a.low[i], b.high[i], r, s), gap(b.low[i], a.high[i], r, s)];
            so_far.min(of_gaps(gaps))
        })
    }
}

impl<S: Scalar> Relate<Aabb<S>> for Aabb<S> {
    fn relation(&self, other: &Aabb<S>) -> Relation {
        let (Some((a, b)), Some((c, d))) = (self.given_corners(), other.given_corners()) else {
            return S::evaluate(&Lie(Apart::new(self.form(), other.form())));
        };
        let [a, b, c, d] = [a, b, c, d].map(|p| p.to_array());
        (0..3).fold(Relation::Overlapping, |so_far, i| {
            so_far.min(of_gaps([compare(a[i], d[i]), compare(c[i], b[i])]))
        })
    }
}
