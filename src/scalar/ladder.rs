//! A predicate, and the ladder of number systems that a scalar climbs for it.

use super::numbers::Holds;
use super::Scalar;

/// A yes-or-no question about coordinates of the scalar `S`.
///
/// It knows how to answer itself in any number system; the scalar knows which
/// systems to try, the cheapest first ([`Scalar::decide`]).
pub trait Predicate<S: Scalar> {
    /// The answer, if `N` can vouch for it.
    fn attempt<N: Holds<S>>(&self) -> Option<bool>;

    /// The answer for every input, by exact sums of products.
    fn exact(&self) -> bool;
}

/// The last two rungs: exact integers if the input fits them, else exact sums.
/// Out of line, so that the common path stays small.
#[cold]
#[inline(never)]
pub(super) fn integers_then_exact<S: Scalar, N: Holds<S>, P: Predicate<S>>(p: &P) -> bool {
    match p.attempt::<N>() {
        Some(answer) => answer,
        None => p.exact(),
    }
}

/// The last rung alone, out of line.
#[cold]
#[inline(never)]
pub(super) fn exactly<S: Scalar, P: Predicate<S>>(p: &P) -> bool {
    p.exact()
}
