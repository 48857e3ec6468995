//! A question, and the ladder of number systems that a scalar climbs for it.

use super::Scalar;
use super::integer::Int64;
#[cfg(feature = "fixed")]
use super::integer::REGISTERS_ARE_WIDE;
use super::numbers::Holds;
use super::tally::{Step, note};
use super::word::{InWord, Word};

/// A question about coordinates of the scalar `S`.
///
/// It knows how to answer itself in any number system; the scalar knows which
/// systems to try, the cheapest first ([`Scalar::decide`]).
pub trait Predicate<S: Scalar> {
    /// Yes or no, or what was found.
    type Answer: Default;

    /// The answer, if `N` can vouch for it.
    fn attempt<N: Holds<S>>(&self) -> Option<Self::Answer>;

    /// The same, where it takes but one pass without branches; `None` otherwise.
    #[inline(always)]
    fn quick<N: Holds<S>>(&self) -> Option<Self::Answer> {
        self.attempt::<N>()
    }

    /// The answer in words of `W`, for a question that has a kernel of its own for
    /// narrow registers, if the shapes are near enough to each other.
    #[inline(always)]
    fn in_words<W: Word>(&self) -> Option<Self::Answer>
    where
        S: InWord<W>,
    {
        None
    }

    /// The answer for every input, by exact sums of products.
    fn exact(&self) -> Self::Answer;
}

/// The first rung of a ladder for numbers: nothing else is inlined.
#[inline(always)]
pub(super) fn first<S: Scalar, N: Holds<S>, P: Predicate<S>>(
    p: &P,
    above: fn(&P) -> P::Answer,
) -> P::Answer {
    match p.quick::<N>() {
        Some(answer) => answer,
        None => {
            note(Step::First);
            above(p)
        }
    }
}

/// The whole ladder, out of line.
#[inline(never)]
pub(super) fn thorough<S: Scalar, P: Predicate<S>>(p: &P) -> P::Answer {
    S::decide(p)
}

/// One rung: the answer in `N`, or else what `above` says, which is out of line
/// so that the common path stays small.
#[inline(always)]
pub(super) fn rung<S: Scalar, N: Holds<S>, P: Predicate<S>>(
    p: &P,
    above: fn(&P) -> P::Answer,
) -> P::Answer {
    match p.attempt::<N>() {
        Some(answer) => answer,
        None => {
            note(Step::Rung);
            above(p)
        }
    }
}

/// A rung where registers are narrow: the answer in words of `W`, or else what
/// `above` says.
#[cfg(feature = "fixed")]
#[inline(always)]
pub(super) fn words<S: Scalar + InWord<W>, W: Word, P: Predicate<S>>(
    p: &P,
    above: impl FnOnce(&P) -> P::Answer,
) -> P::Answer {
    if REGISTERS_ARE_WIDE {
        return above(p);
    }
    match p.in_words() {
        Some(answer) => answer,
        None => {
            note(Step::Words);
            above(p)
        }
    }
}

/// The only rung, for a scalar all of whose questions `N` can answer.
#[cfg(feature = "fixed")]
#[inline(always)]
pub(super) fn only<S: Scalar, N: Holds<S>, P: Predicate<S>>(p: &P) -> P::Answer {
    let answer = p.attempt::<N>();
    debug_assert!(answer.is_some());
    answer.unwrap_or_default()
}

/// The last rung.
#[cold]
#[inline(never)]
pub(super) fn exactly<S: Scalar, P: Predicate<S>>(p: &P) -> P::Answer {
    note(Step::Exactly);
    p.exact()
}

/// Whether code is dearer than time, for those who asked for it: a ladder then has its
/// first rung and its last. It changes no answer.
pub(super) const FEW_RUNGS: bool = cfg!(feature = "small");

/// The last two rungs: exact integers if the input fits them, else exact sums.
#[cold]
#[inline(never)]
pub(super) fn wide_integers<S: Scalar, P: Predicate<S>>(p: &P) -> P::Answer
where
    Int64: Holds<S>,
{
    rung::<S, Int64, P>(p, exactly::<S, P>)
}
