use crate::arithmetic::{FirstFloat, Offset, Parts, Portion, RoundedOps, Spanned};
use crate::robust::{ExactSum, Predicate};

/// What queries need of a scalar: a few constants, and its cascade.
///
/// Sealed: exactness rests on what is known of each type.
pub trait Backend: RoundedOps + Spanned + FirstFloat + Offset {
    /// One, for offsets and axes. Some fixed-point types cannot hold it.
    const ONE: Parts;

    /// What is known of rounding, if the scalar is a float.
    const FLOAT: Option<FloatFormat<Self>> = None;

    /// An accumulator wide enough for products of four scalars.
    type Sum: ExactSum;

    /// Sign, magnitude and exponent.
    fn parts(self) -> Parts;

    /// The quotient of two sums, to the nearest; the divisor is not zero.
    fn quotient(num: &Self::Sum, den: &Self::Sum) -> Self;

    /// The greatest number that is not above this one; the end of the type where that is below.
    fn at_most(portion: Portion) -> Self;

    /// The answer to `p`, by the cheapest number system that can vouch for it.
    fn evaluate<P: Predicate<Self>>(p: &P) -> P::Answer;

    /// Whether a kernel for floats, four at once, is the first stage where a question has one.
    const IN_QUADS: bool;

    /// The answer to `p` by the kernel for floats, four at once, where that is the first
    /// stage of this scalar and can vouch for it. For who keeps a shape in registers until
    /// [`without_quads`](Self::without_quads) needs it in memory.
    fn in_quads<P: Predicate<Self>>(p: &P) -> Option<P::Answer>;

    /// The answer to `p` by the stages that come after those floats.
    fn without_quads<P: Predicate<Self>>(p: &P) -> P::Answer;

    /// The same for a `p` whose answer is more often than not a number: no system
    /// is tried whose numbers would not do.
    fn evaluate_numeric<P: Predicate<Self>>(p: &P) -> P::Answer {
        Self::evaluate(p)
    }

    /// The answer to `p` in bounded time, by the same number systems on every machine;
    /// `None` in doubt.
    fn evaluate_bounded<P: Predicate<Self>>(p: &P) -> Option<P::Answer>;
}

/// A floating-point format.
#[derive(Clone, Copy, Debug)]
pub struct FloatFormat<S> {
    /// The unit roundoff: half the distance from 1 to the next number.
    pub roundoff: S,
    /// The least normal number.
    pub least_normal: S,
    /// Between these a number has a reciprocal that is a normal number, with a wide
    /// margin.
    pub invertible: (S, S),
}
