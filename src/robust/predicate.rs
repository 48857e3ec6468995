//! A question that can be asked in any number system, and what it requires of a scalar.

use super::exact_sum::ExactSum;
use crate::arithmetic::{
    Embeds, Enclosed, Filtered, FirstFloat, Float, InFloat, InRaw, Limbed, Offset, Parts,
    REGISTERS_ARE_WIDE, RoundedOps, ShortFloat, Soft, Spanned, WholeWord, Word,
};

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
pub trait WordKernel<S: InRaw>: Predicate<S> {
    /// The answer in words of `W` without volumes, if the shapes are close enough to each other.
    #[inline(always)]
    fn narrow<W: Word>(&self) -> Option<Self::Answer> {
        None
    }

    /// The answer in words of `W` and their volumes, likewise.
    #[inline(always)]
    fn narrow_volumes<W: WholeWord>(&self) -> Option<Self::Answer> {
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

/// The constants and the cascade that queries require of a scalar.
///
/// Sealed, because exactness depends on properties of each type.
///
/// Generic code of other crates does not see the constants and functions of a private supertrait.
/// It does see the names of associated types: a type of the same name in a user's trait would be
/// ambiguous. Hence the prefix of all associated types that are reached through `S: Scalar`.
pub(crate) trait Backend: RoundedOps + Spanned + FirstFloat + Offset + ShortFloat {
    /// One, for offsets and axes. Not every fixed-point type can represent it.
    const ONE: Parts;

    /// The unit of coordinates: one in floats, the last place in fixed point.
    const UNIT_LENGTH: Self;

    /// Two numbers whose product, in units of both, is the unit of a squared length.
    const UNIT_OF_SQUARES: [Self; 2];

    /// The float format, if the scalar is a float.
    const FLOAT: Option<FloatFormat<Self>> = None;

    /// Exact numbers for nearly every input.
    type SeptumWindow: Embeds<Self, Area: Enclosed, Volume: Limbed, Quartic: Enclosed, Sextic: Enclosed + Limbed>;

    /// Exact numbers for every input: the numbers of the last stage.
    type SeptumFull: Embeds<Self, Area: Enclosed, Volume: Limbed, Quartic: Enclosed, Sextic: Enclosed + Limbed>;

    /// An accumulator wide enough for products of four scalars.
    type SeptumSum: ExactSum;

    /// Sign, magnitude and exponent.
    fn parts(self) -> Parts;

    /// The quotient of two sums, to the nearest; the divisor is not zero.
    fn quotient(num: &Self::SeptumSum, den: &Self::SeptumSum) -> Self;

    /// The number rounded down. If it lies beyond the type, the greatest number of fixed point, or infinity.
    fn at_most(x: Soft) -> Self;

    /// The answer to `p`, from the cheapest number system that can decide it.
    fn evaluate<P: Predicate<Self>>(p: &P) -> P::Answer;

    /// Whether the kernel for four floats at once is the first stage, for questions that have one.
    const IN_QUADS: bool;

    /// The answer of the kernel for four floats at once, if it is the first stage and can decide
    /// `p`. Split from [`without_quads`](Self::without_quads) so that the caller need not spill the
    /// shape to memory.
    fn in_quads<P: Predicate<Self>>(p: &P) -> Option<P::Answer>;

    /// The answer to `p`, from the stages after [`in_quads`](Self::in_quads).
    fn without_quads<P: Predicate<Self>>(p: &P) -> P::Answer;

    /// The answer to `p`, for questions that usually return numbers, such as a hit. It skips number
    /// systems that can give only a verdict.
    fn evaluate_numeric<P: Numeric<Self>>(p: &P) -> P::Answer {
        Self::evaluate(p)
    }

    /// The answer to `p` in bounded time, from the same number systems on every machine; `None` if
    /// it is still in doubt.
    fn evaluate_bounded<P: Predicate<Self>>(p: &P) -> Option<P::Answer>;
}

/// A fixed-point scalar, whose raw bits fit machine words.
pub(crate) trait FixedBackend: Backend + InRaw {
    /// On machines with narrow registers, the answer of the pair's kernel in words, in the
    /// narrowest that hold the shapes.
    fn in_machine_words<K: WordKernel<Self>>(kernel: &K) -> Option<K::Answer>;
}

/// A floating-point format.
#[derive(Clone, Copy, Debug)]
pub struct FloatFormat<S> {
    /// The unit roundoff: half the distance from 1 to the next number.
    pub roundoff: S,
    /// The least normal number.
    pub least_normal: S,
    /// The range in which the reciprocal of a number is a normal number, with a wide margin.
    pub invertible: (S, S),
}
