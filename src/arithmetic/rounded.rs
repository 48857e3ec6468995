//! A scalar's own arithmetic.

use core::cmp::Ordering;
use core::ops::{Add, Mul, Neg, Sub};

use super::number::Number;
use super::system::{Embeds, Factor, OneType, convert};

/// A scalar's own operations: they round, and wrap where a fixed-point type overflows.
pub(crate) trait RoundedOps: Copy + PartialOrd + 'static {
    /// Zero.
    const PLAIN_ZERO: Self;
    /// One, or the nearest number that the type holds.
    fn plain_one() -> Self;
    /// 1 − u − v, also where the type does not hold one.
    fn rest_of_one(u: Self, v: Self) -> Self;
    /// The sum.
    fn plain_add(self, other: Self) -> Self;
    /// The difference.
    fn plain_sub(self, other: Self) -> Self;
    /// The product.
    fn plain_mul(self, other: Self) -> Self;
    /// The quotient; a divisor of zero gives an infinity, or the end of a
    /// fixed-point type.
    fn plain_div(self, other: Self) -> Self;
    /// The magnitude.
    fn plain_abs(self) -> Self;
    /// This number, negated if `other` has a minus sign.
    fn flip_sign_by(self, other: Self) -> Self;
    /// One half.
    fn plain_half(self) -> Self;
}

/// A number of the rounded methods: every result is rounded as the scalar rounds, and fixed-point
/// overflow wraps around. Nothing here is exact.
#[derive(Clone, Copy, Debug, PartialEq, PartialOrd)]
pub struct Rounded<S>(pub S);

impl<S: RoundedOps> Add for Rounded<S> {
    type Output = Self;
    #[inline(always)]
    fn add(self, other: Self) -> Self {
        Self(self.0.plain_add(other.0))
    }
}

impl<S: RoundedOps> Sub for Rounded<S> {
    type Output = Self;
    #[inline(always)]
    fn sub(self, other: Self) -> Self {
        Self(self.0.plain_sub(other.0))
    }
}

impl<S: RoundedOps> Mul for Rounded<S> {
    type Output = Self;
    #[inline(always)]
    fn mul(self, other: Self) -> Self {
        Self(self.0.plain_mul(other.0))
    }
}

impl<S: RoundedOps> Neg for Rounded<S> {
    type Output = Self;
    #[inline(always)]
    fn neg(self) -> Self {
        Self(S::PLAIN_ZERO.plain_sub(self.0))
    }
}

impl<S: RoundedOps> Number for Rounded<S> {
    const ZERO: Self = Self(S::PLAIN_ZERO);
    #[inline(always)]
    fn magnitude(self) -> Self {
        Self(self.0.plain_abs())
    }
    #[inline(always)]
    fn half(self) -> Self {
        Self(self.0.plain_half())
    }
}

impl<S: RoundedOps> Factor for Rounded<S> {
    const CERTAIN: bool = true;
}

impl<S: RoundedOps> Embeds<S> for OneType<Rounded<S>> {
    type OfAreas = Self;

    #[inline(always)]
    fn holds<const K: usize>(_: &[[S; 3]; K]) -> bool {
        true
    }
    #[inline(always)]
    fn embed_held<const K: usize>(coordinates: &[[S; 3]; K]) -> [[Rounded<S>; 3]; K] {
        convert(coordinates, Rounded(S::PLAIN_ZERO), Rounded)
    }

    const DIVIDES: bool = true;

    #[inline(always)]
    fn quotients(num: [Rounded<S>; 3], den: Rounded<S>, _: [Rounded<S>; 2]) -> ([S; 3], bool) {
        let [Rounded(a), Rounded(b), Rounded(c)] = num;
        ([a.plain_div(den.0), b.plain_div(den.0), c.plain_div(den.0)], true)
    }
    #[inline(always)]
    fn quotient_of_lengths(num: Rounded<S>, den: Rounded<S>) -> S {
        num.0.plain_div(den.0)
    }
    #[inline(always)]
    fn coordinate(num: Rounded<S>, den: Rounded<S>, _: [Rounded<S>; 2]) -> Option<S> {
        Some(num.0.plain_div(den.0))
    }
    #[inline(always)]
    fn compare_quotient(
        num: Rounded<S>,
        den: Rounded<S>,
        _: [Rounded<S>; 2],
        t: S,
    ) -> Option<Ordering> {
        num.0.plain_div(den.0).partial_cmp(&t)
    }
}
