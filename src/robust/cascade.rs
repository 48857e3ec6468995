//! The stages of a scalar's cascade. Each stage asks one number system and escalates to the next if
//! that system is not certain.
//!
//! Only the first stage is inlined, so that the common path stays small. Unit tests count how often
//! a cascade escalates.

use super::predicate::{Backend, Clue, Numeric, Predicate};
use crate::arithmetic::{Embeds, Filtered, Float, InFloat, REGISTERS_ARE_WIDE, cuts_floats};

/// The first stage for questions whose answer is a number.
#[inline(always)]
pub(crate) fn numeric_stage<S, P: Numeric<S>>(p: &P, next: fn(&P, Clue) -> P::Answer) -> P::Answer
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
pub(crate) fn refined_stage<S, P: Numeric<S>>(
    p: &P,
    clue: Clue,
    next: fn(&P) -> P::Answer,
) -> P::Answer
where
    Filtered<f64>: Embeds<S>,
{
    if clue == Clue::Unasked {
        if let Some(answer) = noted(p.filter::<Filtered<f64>>()) {
            return answer;
        }
    }
    match noted(p.refined(clue)) {
        Some(answer) => answer,
        None => next(p),
    }
}

/// The answer in `N`, or else the result of `next`.
#[inline(always)]
pub(crate) fn stage<S, N: Embeds<S>, P: Predicate<S>>(
    p: &P,
    next: fn(&P) -> P::Answer,
) -> P::Answer {
    match noted(p.filter::<N>()) {
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
    if P::PROFILE.has_quads && REGISTERS_ARE_WIDE {
        return in_quads(p);
    }
    noted(p.filter::<Filtered<F>>())
}

/// The answer by cut numbers, of floats that functions compute.
#[inline(always)]
pub(crate) fn in_cut_floats<S: Backend, T>(answer: impl FnOnce() -> Option<T>) -> Option<T> {
    if S::FLOAT.is_some() && cuts_floats::<S>() { noted(answer()) } else { None }
}

/// The answer in `F`, four at once, if the question has a kernel for that.
#[inline(always)]
pub(crate) fn in_quads<S: InFloat<F>, F: Float, P: Predicate<S>>(p: &P) -> Option<P::Answer> {
    if P::PROFILE.has_quads { noted(p.in_quads::<F>()) } else { None }
}

/// The only stage, for a scalar for which `N` can answer every question.
#[cfg(feature = "fixed")]
#[inline(always)]
pub(crate) fn only_stage<S, N: Embeds<S>, P: Predicate<S>>(p: &P) -> P::Answer {
    let answer = p.filter::<N>();
    debug_assert!(answer.is_some());
    answer.unwrap_or_default()
}

/// The integers `N` if the input fits them, else the last stage.
#[cold]
#[inline(never)]
pub(crate) fn integer_stage<S: Backend, N: Embeds<S>, P: Predicate<S>>(p: &P) -> P::Answer {
    stage::<S, N, P>(p, exact_stage::<S, P>)
}

/// The last stage.
#[cold]
#[inline(never)]
pub(crate) fn exact_stage<S: Backend, P: Predicate<S>>(p: &P) -> P::Answer {
    note(Stage::Exact);
    p.exact()
}

/// A step of a question: an escalation, or the arrival at the last stage.
#[derive(Clone, Copy)]
pub(crate) enum Stage {
    /// Past the first look: past the first stage for numbers, the slabs of a prepared ray, or a
    /// kernel that leaves its doubts to another.
    Look,
    /// Past a number system.
    Filter,
    /// Past a stage for narrow registers.
    #[cfg(feature = "fixed")]
    Narrow,
    /// Arrived at the last stage.
    Exact,
}

/// Records a step, in unit tests.
#[inline(always)]
pub(crate) fn note(stage: Stage) {
    #[cfg(all(test, feature = "fixed"))]
    counter::add(stage);
    #[cfg(not(all(test, feature = "fixed")))]
    let _ = stage;
}

/// The answer of a number system. Without one, the question goes past it.
#[inline(always)]
pub(crate) fn noted<T>(answer: Option<T>) -> Option<T> {
    if answer.is_none() {
        note(Stage::Filter);
    }
    answer
}

#[cfg(all(test, feature = "fixed"))]
mod counter {
    extern crate std;

    use core::cell::Cell;

    use super::Stage;

    std::thread_local! {
        static COUNTS: Cell<[u32; 4]> = const { Cell::new([0; 4]) };
    }

    pub(super) fn add(stage: Stage) {
        let mut counts = COUNTS.get();
        counts[stage as usize] += 1;
        COUNTS.set(counts);
    }

    /// How often the question takes each step.
    pub(crate) fn escalations(question: impl FnOnce()) -> [u32; 4] {
        COUNTS.set([0; 4]);
        question();
        COUNTS.get()
    }
}

#[cfg(all(test, feature = "fixed"))]
pub(crate) use counter::escalations;
