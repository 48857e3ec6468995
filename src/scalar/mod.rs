//! The scalar trait, and the number systems that a scalar's questions are
//! answered in.

mod area;
mod bounded;
#[cfg(all(test, feature = "fixed"))]
mod climbs;
#[cfg(feature = "fixed")]
mod coarse;
mod float;
mod integer;
mod ladder;
mod multiples;
mod number;
mod numbers;
mod padding;
mod quotient;
#[cfg(feature = "fixed")]
mod root;
mod rounded;
mod sum;
mod tally;
mod wide;
mod word;

#[cfg(feature = "fixed")]
mod fixed;

pub use area::Area;
#[cfg(test)]
pub(crate) use area::Pair;
pub use ladder::Predicate;
pub use number::Number;
pub(crate) use number::{greatest, least};
pub use numbers::{Holds, Numbers};
pub use padding::Padding;
#[cfg(feature = "fixed")]
pub use root::FixedPoint;
pub use rounded::Rounded;
pub use sum::{ExactSum, Parts};
pub use word::{InWord, Word};
pub(crate) use word::{out_of_line, out_of_line_if_wide};

mod sealed {
    pub trait Sealed {}
}

/// A coordinate: `f32`, `f64`, or any signed type of the `fixed` crate.
///
/// The trait is sealed: exactness rests on what is known of each of its types.
/// Generic code needs no other bound than `S: Scalar`:
///
/// ```
/// use septum::{Aabb, Scalar, Triangle};
///
/// fn count<S: Scalar>(mesh: &[Triangle<S>], cell: &Aabb<S>) -> usize {
///     mesh.iter().filter(|t| t.overlaps(cell)).count()
/// }
/// ```
pub trait Scalar:
    sealed::Sealed
    + crate::interop::Logged
    + Copy
    + PartialOrd
    + Default
    + core::fmt::Debug
    + Send
    + Sync
    + 'static
{
    /// Nought.
    const ZERO: Self;

    /// Whether this is a number: not NaN, not infinite. Always true of
    /// fixed-point numbers.
    fn is_finite(self) -> bool;

    /// One, for checks of unit length. Some fixed-point types cannot hold it.
    #[doc(hidden)]
    const ONE: Parts;

    /// What rounding costs a conservative method; nothing where there is an exact one
    /// at the same price.
    #[doc(hidden)]
    const PADDING: Option<Padding<Self>> = None;

    /// The system of [`may_overlap`](crate::Triangle::may_overlap): its
    /// "disjoint" can be trusted, and its arithmetic is the same everywhere.
    #[doc(hidden)]
    type Quick: Holds<Self>;

    /// The same for boxes with axes of their own.
    #[doc(hidden)]
    type Products: Holds<Self>;

    /// An accumulator wide enough for products of four scalars.
    #[doc(hidden)]
    type Sum: ExactSum;

    /// Sign, magnitude and exponent.
    #[doc(hidden)]
    fn parts(self) -> Parts;

    /// The answer to `p`, by the cheapest number system that can vouch for it.
    #[doc(hidden)]
    fn decide<P: Predicate<Self>>(p: &P) -> P::Answer;

    /// The same for a `p` whose answer is more often than not a number: no system
    /// is tried whose numbers would not do.
    #[doc(hidden)]
    fn measure<P: Predicate<Self>>(p: &P) -> P::Answer {
        Self::decide(p)
    }

    /// The quotient of two sums, to the nearest; the divisor is not nought.
    #[doc(hidden)]
    fn quotient(num: &Self::Sum, den: &Self::Sum) -> Self;

    // The scalar's own arithmetic: rounds, and wraps where a fixed-point type
    // overflows. Only the rounded methods use it.
    #[doc(hidden)]
    fn plain_add(self, other: Self) -> Self;
    #[doc(hidden)]
    fn plain_sub(self, other: Self) -> Self;
    #[doc(hidden)]
    fn plain_mul(self, other: Self) -> Self;
    /// The quotient; a divisor of nought gives an infinity, or the end of a
    /// fixed-point type.
    #[doc(hidden)]
    fn plain_div(self, other: Self) -> Self;
    /// One, or what of it the type holds.
    #[doc(hidden)]
    fn plain_one() -> Self;
    #[doc(hidden)]
    fn plain_abs(self) -> Self;
    /// This, negated where `other` bears a minus.
    #[doc(hidden)]
    fn plain_turned_by(self, other: Self) -> Self;
    #[doc(hidden)]
    fn plain_half(self) -> Self;
}
