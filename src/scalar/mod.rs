//! The public trait `Scalar`, its sealed back end, and for each type its constants and its cascade.

pub(crate) mod axes;
#[cfg(feature = "fixed")]
mod fixed;
#[cfg(feature = "fixed")]
mod fixed_point;
mod float;
mod grid;
mod in_double;
#[cfg(feature = "defmt")]
mod logged;
mod ordinal;
mod planes;
mod rotation;

use crate::arithmetic::{
    Embeds, Enclosed, FirstFloat, InRaw, Limbed, Offset, Parts, RoundedOps, ShortFloat, Soft,
    Spanned,
};
use crate::robust::{ExactSum, Numeric, Predicate, WordKernel};

#[cfg(feature = "fixed")]
pub use fixed_point::FixedPoint;
#[cfg(feature = "defmt")]
pub(crate) use logged::Logged;
pub(crate) use ordinal::Ordinal;
pub(crate) use planes::{Planes, PlanesError};

/// Logging support, required of every scalar if the feature `defmt` is on; empty otherwise.
#[cfg(not(feature = "defmt"))]
pub(crate) trait Logged {}

#[cfg(not(feature = "defmt"))]
impl<S> Logged for S {}

/// A coordinate: `f32`, `f64`, or a signed type of the `fixed` crate of up to 64 bits.
///
/// The fixed-point types are `FixedI8`, `FixedI16`, `FixedI32` and `FixedI64` with any number of
/// fraction bits. `FixedI128` is not supported.
///
/// The trait is sealed, because exactness depends on properties of each type. Generic code needs no
/// bound other than `S: Scalar`:
///
/// ```
/// use septum::{Aabb, Scalar, Triangle};
///
/// fn count<S: Scalar>(mesh: &[Triangle<S>], cell: &Aabb<S>) -> usize {
///     mesh.iter().filter(|t| t.overlaps(cell)).count()
/// }
/// ```
// Generic code of other crates, which may have traits of its own with items of the same names, does
// not see the items of these traits: see `Backend`.
#[allow(private_bounds)]
#[diagnostic::on_unimplemented(
    message = "`{Self}` is not a scalar of septum",
    label = "not `f32`, `f64` or a signed fixed-point type of up to 64 bits",
    note = "fixed-point types need the feature `fixed`, and the version of the crate `fixed` that septum uses"
)]
pub trait Scalar:
    Backend
    + axes::Axes
    + Planes
    + rotation::Rotation
    + grid::Gridded
    + ordinal::Ordinal
    + in_double::InDouble
    + Logged
    + Copy
    + PartialOrd
    + Default
    + core::fmt::Debug
    + Send
    + Sync
    + 'static
{
    /// Zero.
    const ZERO: Self;

    /// Whether the number is finite: not NaN and not infinite. Always `true` for fixed point.
    fn is_finite(self) -> bool;
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

    /// The number rounded down; the greatest number of the type if it lies beyond.
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
pub(crate) trait FixedBackend: Scalar + InRaw {
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
