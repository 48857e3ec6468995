//! When do the shapes meet? First the bounds from floats, then the time.

use super::latest::{Instant, Last};
use super::{FirstContact, Passing, in_doubles, rows, words};
use crate::arithmetic::{Embeds, Filtered, Float, InFloat, InRaw, REGISTERS_ARE_WIDE, WholeWord};
use crate::robust::{Clue, Numeric, Predicate, Profile, WordKernel, in_exact_numbers};
use crate::scalar::{FixedBackend, Scalar};

/// What do floats know of the motion?
pub(super) struct When<'a, 'b, S>(pub(super) &'b Passing<'a, S>);

impl<S: Scalar> Predicate<S> for When<'_, '_, S> {
    type Answer = Instant;

    /// Of shapes that meet.
    fn filter<N: Embeds<S>>(&self) -> Option<Instant> {
        Some(Instant::Meets(self.0.course::<N>()?.last()))
    }

    const PROFILE: Profile = Profile::QUADS;

    #[inline(always)]
    fn in_quads<F: Float>(&self) -> Option<Instant>
    where
        S: InFloat<F>,
    {
        rows::when::<S, F>(self.0)
    }

    fn exact(&self) -> Instant {
        Instant::Unknown
    }
}

/// When do these shapes meet, given that they do, and given the bounds from floats?
pub(super) struct Meets<'a, S> {
    pub(super) passing: Passing<'a, S>,
    pub(super) last: Option<Last>,
}

impl<S: Scalar> Predicate<S> for Meets<'_, S> {
    type Answer = FirstContact<S>;

    // Out of line, so that the exact stage does not run on top of its numbers on the stack.
    #[inline(never)]
    fn filter<N: Embeds<S>>(&self) -> Option<FirstContact<S>> {
        // The compiler does not see that words always answer, and would link this.
        if !N::HAS_QUOTIENTS || words::serve::<S>() {
            return None;
        }
        let course = self.passing.course::<N>()?;
        self.last.and_then(|last| course.at_last(last)).or_else(|| course.first_contact())
    }

    #[inline(always)]
    fn in_words(&self, _: bool) -> Option<FirstContact<S>>
    where
        S: FixedBackend,
    {
        if words::serve::<S>() { S::in_machine_words(self) } else { None }
    }

    fn exact(&self) -> FirstContact<S> {
        if REGISTERS_ARE_WIDE {
            return in_exact_numbers(self);
        }
        // Never reached: words always answer.
        if words::serve::<S>() {
            return FirstContact::default();
        }
        self.passing.exactly().first_contact()
    }
}

impl<S: Scalar + InRaw> WordKernel<S> for Meets<'_, S> {
    #[inline(always)]
    fn narrow_volumes<W: WholeWord>(&self) -> Option<FirstContact<S>> {
        if S::is_always_near::<W>() {
            Some(self.passing.contact_in_any_words::<W>())
        } else {
            self.passing.contact_in_near_words::<W>()
        }
    }
}

impl<S: Scalar> Numeric<S> for Meets<'_, S> {
    fn refined(&self, _: Clue) -> Option<FirstContact<S>>
    where
        Filtered<f64>: Embeds<S>,
    {
        let is_long = !<Filtered<f64> as Embeds<S>>::HAS_QUOTIENTS;
        if is_long { in_doubles::first_contact_of_long(&self.passing, self.last) } else { None }
    }
}
