//! When do the shapes meet? First the bounds from floats, then the time.

use super::{FirstContact, Passing, in_doubles, rows, words};
use crate::arithmetic::{
    Each, Embeds, Filtered, Float, InFloat, InWholeWord, Number, REGISTERS_ARE_WIDE, WholeWord,
};
use crate::query::Axis;
use crate::robust::{Clue, Numeric, Predicate, Profile, Uncertain, WordKernel, in_exact_numbers};
use crate::scalar::{FixedBackend, Scalar};

/// A relative bound, above the relative loss of a scalar's number in `f64`.
const NEAR: f64 = 64.0 * f64::EPSILON;

/// The bounds from floats on a motion.
#[derive(Clone, Copy, Debug, Default)]
pub(super) enum Instant {
    /// Nothing.
    #[default]
    Unknown,
    /// The shapes miss each other.
    Misses,
    /// They meet at the start.
    AtStart,
    /// They meet; the axis that closes last, if floats know it.
    Meets(Option<Last>),
}

/// The axis that closes last.
#[derive(Clone, Copy, Debug)]
pub(super) struct Last {
    pub(super) axis: Axis,
    /// A time at which all other axes have closed, and this one has not.
    pub(super) after: f64,
}

/// What do floats know of the motion?
pub(super) struct When<'a, 'b, S>(pub(super) &'b Passing<'a, S>);

impl<S: Scalar> Predicate<S> for When<'_, '_, S> {
    type Answer = Instant;

    fn filter<N: Embeds<S>>(&self) -> Option<Instant> {
        None
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

impl Last {
    /// The answer, if all other axes have closed before it also in the scalar's rounding. Otherwise
    /// an axis that comes first in the order may close at the same number.
    pub(super) fn at<S: Scalar>(self, t: S) -> Option<FirstContact<S>> {
        let is_after = t.in_double() > self.after * (1.0 + NEAR);
        is_after.then_some(FirstContact { t, axis: Some(self.axis) })
    }
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
        let on_axis = |last: Last| course.first_contact(Some(last.axis)).and_then(|x| last.at(x.t));
        self.last.and_then(on_axis).or_else(|| course.first_contact(None))
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

impl<S: Scalar> WordKernel<S> for Meets<'_, S> {
    #[inline(always)]
    fn narrow_volumes<W: WholeWord>(&self) -> Option<FirstContact<S>>
    where
        S: InWholeWord<W>,
    {
        if S::ALWAYS_NEAR {
            Some(self.passing.contact_in_any_words())
        } else {
            self.passing.contact_in_near_words()
        }
    }
}

impl<S: Scalar> Numeric<S> for Meets<'_, S> {
    #[inline(always)]
    fn fast_path(&self) -> Result<FirstContact<S>, Clue>
    where
        Filtered<f64>: Embeds<S>,
    {
        if !<Filtered<f64> as Embeds<S>>::HAS_QUOTIENTS {
            return Err(Clue::NoNumbers);
        }
        in_doubles::first_contact(&self.passing, self.last).ok_or(Clue::Doubt)
    }

    fn refined(&self, _: Clue) -> Option<FirstContact<S>>
    where
        Filtered<f64>: Embeds<S>,
    {
        let is_long = !<Filtered<f64> as Embeds<S>>::HAS_QUOTIENTS;
        if is_long { in_doubles::first_contact_of_long(&self.passing, self.last) } else { None }
    }
}

/// A gap at the start and the speed that closes it, each with its error.
pub(super) type Closing<T> = [[T; 2]; 2];

/// The latest of the times at which axes stop separating, with errors.
///
/// Each time is rounded down to the scalar by itself. Rounding keeps the order, so the latest
/// rounded time is the latest true time, rounded; fractions need not be compared.
pub(super) struct Latest<S> {
    /// `None` until an axis is known to separate.
    found: Option<FirstContact<S>>,
    /// The latest possible time of the axes whose own time is unknown.
    in_doubt: Option<S>,
}

impl<S: Scalar> Latest<S> {
    pub(super) const NONE: Self = Self { found: None, in_doubt: None };

    /// Adds an axis, if it has a gap. Call it in the order of [`Axis::ALL`].
    #[inline(always)]
    pub(super) fn add<T: Number>(&mut self, axis: Axis, closing: Option<Closing<T>>) {
        let Some([[gap, error], speed]) = closing else { return };
        let is_gap = Uncertain::above(gap, error);
        if !is_gap.possible {
            return;
        }
        let [low, high] = gap.portion(speed[0], [error, speed[1]]).each(S::at_most);
        if low == high && is_gap.certain {
            self.set(axis, low);
        } else if self.in_doubt.is_none_or(|t| high > t) {
            self.in_doubt = Some(high);
        }
    }

    /// Adds an axis that separates until then.
    pub(super) fn set(&mut self, axis: Axis, t: S) {
        if self.found.is_none_or(|found| t > found.t) {
            self.found = Some(FirstContact { t, axis: Some(axis) });
        }
    }

    /// The first contact; `None` while it is in doubt.
    pub(super) fn known(self) -> Option<FirstContact<S>> {
        let found = self.found.unwrap_or(FirstContact { t: S::ZERO, axis: None });
        // A time in doubt may be equal and belong to an axis that comes before.
        let is_later = |t: S| if self.found.is_some() { found.t > t } else { false };
        self.in_doubt.is_none_or(is_later).then_some(found)
    }
}
