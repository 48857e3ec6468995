//! A box that moves past another. Each slab bounds the motion as it does a line, and the slab's
//! ends are sums of up to four numbers.

#[cfg(feature = "fixed")]
use super::Moving;
use super::latest::{Closings, Latest};
use super::{FirstContact, Motion, Sweep};
#[cfg(feature = "fixed")]
use crate::arithmetic::IntNear;
use crate::arithmetic::{Embeds, Number};
use crate::query::Axis;
use crate::query::aabb_aabb::{Apart, GAP};
use crate::query::line_aabb::Slabs;
use crate::query::relation::Relation;
#[cfg(feature = "fixed")]
use crate::robust::only_stage;
use crate::robust::{Numeric, Predicate, Profile};
use crate::scalar::Scalar;
use crate::shape::Aabb;

/// The box that stands, and the box that moves.
struct Passing<S> {
    boxes: Apart<S>,
    way: [[S; 3]; 2],
}

impl<S: Scalar> Passing<S> {
    #[inline(always)]
    fn new(moving: &Aabb<S>, motion: &Motion<S>, other: &Aabb<S>) -> Self {
        let way = [motion.from().to_array(), motion.to().to_array()];
        Self { boxes: Apart::new(other.form(), moving.form()), way }
    }

    /// The slabs within which the moving box meets the standing box.
    #[inline(always)]
    fn slabs<N: Embeds<S>>(&self) -> Option<Slabs<N>> {
        let Self { boxes: Apart { a, b }, way: [from, to] } = self;
        let all = [a.low, a.high, a.grown, b.low, b.high, b.grown, *from, *to];
        let [a_low, a_high, a_grown, b_low, b_high, b_grown, from, to] = N::embed(&all)?;
        Some(Slabs::of_intervals(|i| {
            let grown = a_grown[i] + b_grown[i];
            (a_low[i] - b_high[i], a_high[i] - b_low[i], grown, to[i] - from[i])
        }))
    }
}

/// Does the moving box miss the standing box?
struct Misses<S>(Passing<S>);

impl<S: Scalar> Predicate<S> for Misses<S> {
    type Answer = bool;
    const PROFILE: Profile = Profile::AREAS;

    fn filter<N: Embeds<S>>(&self) -> Option<bool> {
        let line = self.0.slabs::<N>()?;
        line.lies_before().or(line.lies_beyond_one()).or(line.line_misses()).verdict()
    }
}

/// When do these boxes meet, given that they do?
struct Meets<S>(Passing<S>);

impl<S: Scalar> Predicate<S> for Meets<S> {
    type Answer = FirstContact<S>;
    const PROFILE: Profile = Profile::AREAS;

    fn filter<N: Embeds<S>>(&self) -> Option<FirstContact<S>> {
        if !N::HAS_QUOTIENTS {
            return None;
        }
        let Slabs { near, m, spread, .. } = self.0.slabs::<N>()?;
        let mut latest = Latest::NONE;
        for i in 0..3 {
            let size = spread.map_or(near[i].magnitude(), |spread| spread[i]);
            let closing = [[near[i], size.error(GAP)], [m[i], m[i].error(2)]];
            latest.add(Axis::Face(i as u8), Some(closing));
        }
        latest.known()
    }
}

impl<S: Scalar> Numeric<S> for Meets<S> {}

/// How near does the moving box come to the standing box?
struct Nearest<'a, S>(&'a Passing<S>);

impl<S: Scalar> Predicate<S> for Nearest<'_, S> {
    type Answer = Relation;
    const PROFILE: Profile = Profile::AREAS;

    fn filter<N: Embeds<S>>(&self) -> Option<Relation> {
        self.0.slabs::<N>()?.relation()
    }
}

impl<S: Scalar> Sweep<Aabb<S>> for Aabb<S> {
    type Scalar = S;
    type Contact = FirstContact<S>;

    #[inline]
    fn meets_along(&self, motion: &Motion<S>, other: &Aabb<S>) -> bool {
        !S::evaluate(&Misses(Passing::new(self, motion, other)))
    }

    #[inline]
    fn first_contact(&self, motion: &Motion<S>, other: &Aabb<S>) -> Option<FirstContact<S>> {
        let meet = || S::evaluate_numeric(&Meets(Passing::new(self, motion, other)));
        self.meets_along(motion, other).then(meet)
    }

    fn relation_along(&self, motion: &Motion<S>, other: &Aabb<S>) -> Relation {
        S::evaluate(&Nearest(&Passing::new(self, motion, other)))
    }
}

// The faces of a tree's boxes lie within 2^20 of zero, those of the moving box within 2^17, and its way
// is shorter than 2^18. Products are below 2^40.
#[cfg(feature = "fixed")]
impl<S: Scalar> Moving<Aabb<S>, S>
where
    IntNear: Embeds<S>,
{
    /// When the box meets a box of a tree over a near mesh.
    pub(crate) fn meets_at(&self, other: &Aabb<S>) -> Option<S> {
        let passing = || Passing::new(self.shape().get(), self.motion(), other);
        let misses = only_stage::<_, IntNear, _>(&Misses(passing()));
        (!misses).then(|| only_stage::<_, IntNear, _>(&Meets(passing())).t)
    }
}
