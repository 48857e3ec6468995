//! Whether a triangle and an oriented box touch or overlap: the same axes, evaluated twice.

use super::Disjoint;
use crate::arithmetic::Embeds;
#[cfg(feature = "fixed")]
use crate::arithmetic::{InRaw, InWholeWord, WholeWord};
use crate::query::relation::{Nearness, Relate, Relation};
use crate::robust::Predicate;
use crate::scalar::Scalar;
use crate::shape::{Obb, Triangle};

/// How do the two lie to each other?
struct Lie<'a, S>(Disjoint<'a, S>);

impl<S: Scalar> Predicate<S> for Lie<'_, S> {
    type Answer = Relation;

    #[inline(never)]
    fn filter<N: Embeds<S>>(&self) -> Option<Relation> {
        self.0.by_axes::<N, Nearness>()
    }

    #[cfg(feature = "fixed")]
    const IN_SHORT: bool = true;

    /// If the triangle meets the shrunk box, it has a point in the interior of the true box,
    /// because the bound exceeds the error. The triangle's interior has points arbitrarily near
    /// that point, so some of them are in the interior of the box too.
    #[cfg(feature = "fixed")]
    #[inline(always)]
    fn in_short(&self) -> Option<Relation>
    where
        S: InRaw,
    {
        let is_disjoint = self.0.in_short()?;
        Some(if is_disjoint { Relation::Disjoint } else { Relation::Overlapping })
    }

    #[cfg(feature = "fixed")]
    #[inline(always)]
    fn narrow_volumes<W: WholeWord>(&self) -> Option<Relation>
    where
        S: InWholeWord<W>,
    {
        self.0.in_narrow_words::<W, true>()
    }

    fn exact(&self) -> Relation {
        self.0.in_exact_sums::<true>()
    }
}

impl<S: Scalar> Relate<Obb<S>> for Triangle<S> {
    fn relation(&self, obb: &Obb<S>) -> Relation {
        S::evaluate(&Lie(Disjoint { triangle: self, obb }))
    }
}
