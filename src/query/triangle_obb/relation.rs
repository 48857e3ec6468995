//! Whether a triangle and an oriented box touch or overlap: the same axes, evaluated twice.

use super::Disjoint;
use crate::arithmetic::Embeds;
use crate::arithmetic::{InWholeWord, WholeWord};
use crate::query::relation::{Nearness, Relate, Relation};
use crate::robust::{Predicate, Profile, WordKernel, noted};
use crate::scalar::{FixedBackend, Scalar};
use crate::shape::{Obb, Triangle};

/// How do the two lie to each other?
struct Lie<'a, S>(Disjoint<'a, S>);

impl<S: Scalar> Predicate<S> for Lie<'_, S> {
    type Answer = Relation;

    #[inline(never)]
    fn filter<N: Embeds<S>>(&self) -> Option<Relation> {
        self.0.by_axes::<N, Nearness>()
    }

    const PROFILE: Profile = Profile::CUT;

    /// If the triangle meets the shrunk box, it has a point in the interior of the true box,
    /// because the bound exceeds the error. The triangle's interior has points arbitrarily near
    /// that point, so some of them are in the interior of the box too.
    #[inline(always)]
    fn in_words(&self, _: bool) -> Option<Relation>
    where
        S: FixedBackend,
    {
        match noted(self.0.in_short_words()) {
            Some(true) => Some(Relation::Disjoint),
            Some(false) => Some(Relation::Overlapping),
            None => S::in_machine_words(self),
        }
    }

    fn exact(&self) -> Relation {
        self.0.in_exact_sums::<Nearness>()
    }
}

impl<S: Scalar> WordKernel<S> for Lie<'_, S> {
    #[inline(always)]
    fn narrow_volumes<W: WholeWord>(&self) -> Option<Relation>
    where
        S: InWholeWord<W>,
    {
        self.0.in_narrow_words::<W, Nearness>()
    }
}

impl<S: Scalar> Relate<Obb<S>> for Triangle<S> {
    fn relation(&self, obb: &Obb<S>) -> Relation {
        let shapes = Disjoint { triangle: self, obb };
        match shapes.in_cut_floats() {
            Some(true) => Relation::Disjoint,
            Some(false) => Relation::Overlapping,
            None => S::evaluate(&Lie(shapes)),
        }
    }
}
