//! The stages of a scalar's cascade. Each stage asks one number system and escalates to the next if
//! that system is not certain.
//!
//! Only the first stage is inlined, so that the common path stays small.

use super::predicate::{Clue, Predicate};
use super::stages::{Stage, note};
use crate::arithmetic::{Embeds, Filtered, Float, InFloat, Int64, REGISTERS_ARE_WIDE, ShortFloat};
#[cfg(feature = "fixed")]
use crate::arithmetic::{InRaw, InWholeWord, InWord, WholeWord, Word};
use crate::scalar::Backend;

/// The first stage for questions whose answer is a number.
#[inline(always)]
pub(crate) fn numeric_stage<S, P: Predicate<S>>(p: &P, next: fn(&P, Clue) -> P::Answer) -> P::Answer
where
    Filtered<f64>: Embeds<S>,
{
    match p.fast_path() {
        Ok(answer) => answer,
        Err(clue) => {
            note(Stage::Look);
            next(p, clue)
        }
    }
}

/// The stages for numbers after the first: `f64`, if it was not the first, and numbers beyond its
/// precision.
#[inline(always)]
pub(crate) fn refined_stage<S, P: Predicate<S>>(
    p: &P,
    clue: Clue,
    next: fn(&P) -> P::Answer,
) -> P::Answer
where
    Filtered<f64>: Embeds<S>,
{
    if clue == Clue::Unasked {
        if let Some(answer) = p.filter::<Filtered<f64>>() {
            return answer;
        }
        note(Stage::Filter);
    }
    match p.refined(clue) {
        Some(answer) => answer,
        None => {
            note(Stage::Filter);
            next(p)
        }
    }
}

/// The answer in `N`, or else the result of `next`.
#[inline(always)]
pub(crate) fn stage<S, N: Embeds<S>, P: Predicate<S>>(
    p: &P,
    next: fn(&P) -> P::Answer,
) -> P::Answer {
    match p.filter::<N>() {
        Some(answer) => answer,
        None => {
            note(Stage::Filter);
            next(p)
        }
    }
}

/// For machines with slow `f64`: the numbers by short multiples, or else the result of `next`.
#[inline(always)]
pub(crate) fn multiples_stage<S: ShortFloat, P: Predicate<S>>(
    p: &P,
    next: fn(&P) -> P::Answer,
) -> P::Answer {
    match p.in_short_multiples() {
        Some(answer) => answer,
        None => next(p),
    }
}

/// The answer in `F` with a bound on its error, if that is certain.
#[inline(always)]
pub(crate) fn in_floats<S: InFloat<F>, F: Float, P: Predicate<S>>(p: &P) -> Option<P::Answer>
where
    Filtered<F>: Embeds<S>,
{
    if P::IN_QUADS && REGISTERS_ARE_WIDE {
        return in_quads(p);
    }
    let answer = p.filter::<Filtered<F>>();
    if answer.is_none() {
        note(Stage::Filter);
    }
    answer
}

/// The answer in `F`, four at once, if the question has a kernel for that.
#[inline(always)]
pub(crate) fn in_quads<S: InFloat<F>, F: Float, P: Predicate<S>>(p: &P) -> Option<P::Answer> {
    let answer = p.in_quads::<F>();
    if P::IN_QUADS && answer.is_none() {
        note(Stage::Filter);
    }
    answer
}

/// For narrow registers: the answer in words of `W`, or else the result of `next`.
#[cfg(feature = "fixed")]
#[inline(always)]
pub(crate) fn narrow_stage<S: InWord<W>, W: Word, P: Predicate<S>>(
    p: &P,
    next: impl FnOnce(&P) -> P::Answer,
) -> P::Answer {
    if REGISTERS_ARE_WIDE {
        return next(p);
    }
    match p.narrow() {
        Some(answer) => answer,
        None => {
            note(Stage::Narrow);
            next(p)
        }
    }
}

/// For narrow registers: the answer to a question about volumes in words of `W`.
#[cfg(feature = "fixed")]
#[inline(always)]
pub(crate) fn volume_stage<S: InWholeWord<W>, W: WholeWord, P: Predicate<S>>(
    p: &P,
    next: impl FnOnce(&P) -> P::Answer,
) -> P::Answer {
    if REGISTERS_ARE_WIDE {
        return next(p);
    }
    match p.narrow_volumes() {
        Some(answer) => answer,
        None => next(p),
    }
}

/// The answer from cut coordinates, if the question has a kernel for that, or else the result of
/// `next`.
#[cfg(feature = "fixed")]
#[inline(always)]
pub(crate) fn short_stage<S: InRaw, P: Predicate<S>>(
    p: &P,
    next: impl FnOnce(&P) -> P::Answer,
) -> P::Answer {
    if !P::IN_SHORT {
        return next(p);
    }
    match p.in_short() {
        Some(answer) => answer,
        None => {
            note(Stage::Filter);
            next(p)
        }
    }
}

/// The only stage, for a scalar for which `N` can answer every question.
#[cfg(feature = "fixed")]
#[inline(always)]
pub(crate) fn only_stage<S, N: Embeds<S>, P: Predicate<S>>(p: &P) -> P::Answer {
    let answer = p.filter::<N>();
    debug_assert!(answer.is_some());
    answer.unwrap_or_default()
}

/// Exact integers if the input fits them, else the last stage.
#[cold]
#[inline(never)]
pub(crate) fn integer_stage<S: Backend, P: Predicate<S>>(p: &P) -> P::Answer
where
    Int64: Embeds<S>,
{
    stage::<S, Int64, P>(p, exact_stage::<S, P>)
}

/// The last stage.
#[cold]
#[inline(never)]
pub(crate) fn exact_stage<S: Backend, P: Predicate<S>>(p: &P) -> P::Answer {
    note(Stage::Exact);
    p.exact()
}

/// The answer in exact numbers: in a window if it holds the coordinates, or else at full width.
#[inline(always)]
pub(crate) fn in_exact_numbers<S: Backend, P: Predicate<S>>(p: &P) -> P::Answer {
    // On a small core one kernel is enough: the last stage is rare, and flash is short.
    let in_window = if REGISTERS_ARE_WIDE { p.filter::<S::SeptumWindow>() } else { None };
    match in_window {
        Some(answer) => answer,
        None => at_full_width(p),
    }
}

#[inline(never)]
fn at_full_width<S: Backend, P: Predicate<S>>(p: &P) -> P::Answer {
    let answer = p.filter::<S::SeptumFull>();
    debug_assert!(answer.is_some());
    answer.unwrap_or_default()
}
