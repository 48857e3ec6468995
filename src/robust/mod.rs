//! How a doubtful sign is decided, and how a nearly zero normal is treated.
//!
//! A question is a [`Predicate`]: it can be evaluated in every number system that can hold its
//! coordinates. A scalar lists the systems to ask, the cheapest first, as its cascade
//! ([`cascade`]). Each stage returns an answer only if it is certain. Integers are certain if they
//! hold the input. Floats compute each axis with a bound on its error, and gather two flags over
//! all axes ([`Uncertain`]): some axis certainly separates, and some axis may separate. If the
//! flags agree, they are the answer; if they differ, the question escalates.
//!
//! The last stage is right for every finite input. It runs the same kernel in exact integers: in
//! [`Window`] if that holds the coordinates, and otherwise in the scalar's `Full` numbers. For some
//! pairs it adds signed products of the given coordinates in one long accumulator ([`ExactSum`]).
//!
//! [`Window`]: crate::arithmetic::Window
//!
//! Each answer is the exact one, so the order and the number of the stages change its time and
//! never its value. Unit tests count how often questions escalate.
//!
//! # The nearly zero normal
//!
//! ## What goes wrong
//!
//! The normal of a triangle is n = e0 × e1, and each component is a difference of two products. In
//! a sliver the two are nearly equal, and their difference is mostly rounding error: the normal has
//! a random direction. The plane test of the 2001 paper then asks whether the box lies to one side
//! of an unrelated plane, and often it does. The triangle is dropped although it pierces the box.
//! In `f32` this happens to 3 slivers in 100 (`docs/experiments/accuracy.txt`).
//!
//! ## The meaning of a normal of zero
//!
//! The three vertices lie on one line: the triangle is a segment or a point. Everything projects to
//! zero on a zero normal, so that axis never separates; the remaining twelve suffice. For a segment
//! the axes are the box's face normals and their cross products with the segment; for a point they
//! are the face normals.
//!
//! ## Why no epsilon
//!
//! A threshold on |n| would have to be an area, and there is no area below which a triangle is a
//! segment: the same mesh must get the same answers in millimetres and in kilometres. A threshold
//! relative to the edges fails too. A sliver with almost parallel sides still has one plane, and a
//! box can lie just off it on either side. Skipping the plane test there finds overlaps that do not
//! exist, and keeping it loses overlaps that do.
//!
//! ## The remedy
//!
//! The plane test counts only if its value exceeds the error that its operands allow
//! (`query/triangle_aabb/error_bound.rs`). That error does not shrink with n, so a noisy normal
//! never decides. A doubtful sign escalates ([`cascade`]) to wider numbers and at last to
//! exact integers, in which n is exact, zero included. There is no third case.

mod cascade;
mod determinant;
mod exact_sum;
mod uncertain;

use crate::arithmetic::{
    Embeds, Filtered, Float, InFloat, InWholeWord, InWord, REGISTERS_ARE_WIDE, WholeWord, Word,
};
use crate::scalar::{Backend, FixedBackend};

#[cfg(all(test, feature = "fixed"))]
pub(crate) use cascade::escalations;
pub(crate) use cascade::{
    Stage, exact_stage, in_floats, in_quads, integer_stage, note, noted, numeric_stage,
    refined_stage,
};
#[cfg(feature = "fixed")]
pub(crate) use cascade::{only_stage, stage};
pub(crate) use determinant::{
    Linear, Vector, add_area, add_determinant, add_minor, along_axis, difference, differences,
    minor_sign, side, sign, single, singles,
};
pub use exact_sum::ExactSum;
pub(crate) use exact_sum::Sum;
pub(crate) use uncertain::{Uncertain, certain_sign};

/// A question about coordinates of the scalar `S`.
///
/// It can be evaluated in any number system; the scalar chooses the systems, the cheapest first.
/// Before them come the special kernels of a pair of shapes: `in_quads`, then `in_words`.
pub trait Predicate<S> {
    /// Yes or no, or the result.
    type Answer: Default;

    /// Properties that the choice of number systems depends on.
    const PROFILE: Profile = Profile::VOLUMES;

    /// The answer, if `N` is certain of it.
    fn filter<N: Embeds<S>>(&self) -> Option<Self::Answer>;

    /// The answer from floats, four at once, if they are certain of it.
    #[inline(always)]
    fn in_quads<F: Float>(&self) -> Option<Self::Answer>
    where
        S: InFloat<F>,
    {
        None
    }

    /// The answer of the pair's own kernels for fixed point, which come before all other integers.
    /// If `is_bounded`, a conservative answer will do.
    #[inline(always)]
    fn in_words(&self, is_bounded: bool) -> Option<Self::Answer>
    where
        S: FixedBackend,
    {
        let _ = is_bounded;
        None
    }

    /// The answer for every input.
    fn exact(&self) -> Self::Answer
    where
        S: Backend,
        Self: Sized,
    {
        in_exact_numbers(self)
    }
}

/// Properties that the choice of number systems depends on.
#[derive(Clone, Copy)]
pub struct Profile {
    /// Whether the question takes products of three lengths. If not, integers for 28 bits cost no
    /// more than those for 18.
    pub has_volumes: bool,
    /// Whether it has a kernel for floats, four at once, which then replaces the filter in floats.
    pub has_quads: bool,
    /// Whether it has a kernel for fixed point cut to words of 32 bits, with an error bound.
    pub is_cut: bool,
}

impl Profile {
    pub(crate) const VOLUMES: Self = Self { has_volumes: true, has_quads: false, is_cut: false };
    pub(crate) const AREAS: Self = Self { has_volumes: false, ..Self::VOLUMES };
    pub(crate) const QUADS: Self = Self { has_quads: true, ..Self::VOLUMES };
    pub(crate) const CUT: Self = Self { is_cut: true, ..Self::VOLUMES };
    pub(crate) const QUADS_AND_CUT: Self = Self { is_cut: true, ..Self::QUADS };
}

/// A question whose pair has a kernel in words, for cores with registers of 32 bits.
pub trait WordKernel<S>: Predicate<S> {
    /// The answer in words of `W` without volumes, if the shapes are close enough to each other.
    #[inline(always)]
    fn narrow<W: Word>(&self) -> Option<Self::Answer>
    where
        S: InWord<W>,
    {
        None
    }

    /// The answer in words of `W` and their volumes, likewise.
    #[inline(always)]
    fn narrow_volumes<W: WholeWord>(&self) -> Option<Self::Answer>
    where
        S: InWholeWord<W>,
    {
        None
    }
}

/// The reason why a fast path has no answer.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Clue {
    /// It does not serve this question.
    Unasked,
    /// The answer is in doubt.
    Doubt,
    /// The answer is certainly yes, but the numbers are not accurate enough.
    NoNumbers,
}

/// A question whose answer is a number, for scalars with fast `f64`.
pub trait Numeric<S>: Predicate<S> {
    /// The answer in `f64`, in a single pass without branches.
    #[inline(always)]
    fn fast_path(&self) -> Result<Self::Answer, Clue>
    where
        Filtered<f64>: Embeds<S>,
    {
        self.filter::<Filtered<f64>>().ok_or(Clue::Doubt)
    }

    /// The answer from more than the precision of `f64`, if that is certain; `None` if the question
    /// has no such stage.
    #[inline(always)]
    fn refined(&self, clue: Clue) -> Option<Self::Answer>
    where
        Filtered<f64>: Embeds<S>,
    {
        let _ = clue;
        None
    }
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
