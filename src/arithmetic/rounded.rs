//! A scalar's own arithmetic.

use core::cmp::Ordering;
use core::ops::{Add, Mul, Neg, Sub};

use super::number::Number;
use super::system::{Arithmetic, Embeds, convert};

/// A scalar's own operations: they round, and wrap where a fixed-point type overflows.
pub(crate) trait RoundedOps: Copy + PartialOrd + 'static {
    /// Zero.
    const PLAIN_ZERO: Self;
    /// One, or the nearest number that the type holds.
    fn plain_one() -> Self;
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

/// The number system of the rounded methods. Length, area and volume are the scalar itself, every
/// result is rounded as the scalar rounds, and fixed-point overflow wraps around. Nothing here is
/// exact.
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

impl<S: RoundedOps> Arithmetic for Rounded<S> {
    type Length = Self;
    type Area = Self;
    type Volume = Self;
    type Quartic = Self;
    type Sextic = Self;
    type Product = Self;
    type Narrow = Self;

    const CERTAIN: bool = true;
    const DOUBLED: bool = false;
    const CORNER_FORM_ONLY: bool = false;

    #[inline(always)]
    fn area(a: Self, b: Self) -> Self {
        a * b
    }
    #[inline(always)]
    fn volume(a: Self, b: Self) -> Self {
        a * b
    }
    #[inline(always)]
    fn quartic(a: Self, b: Self) -> Self {
        a * b
    }
    #[inline(always)]
    fn sextic(a: Self, b: Self) -> Self {
        a * b
    }
    #[inline(always)]
    fn sextic_of_areas(a: Self, b: Self) -> Self {
        a * b
    }
    #[inline(always)]
    fn operand(a: Self) -> Self {
        a
    }
    #[inline(always)]
    fn widened(narrow: Self) -> Self {
        narrow
    }
    #[inline(always)]
    fn is_narrow(_: Self) -> bool {
        false
    }
}

impl<S: RoundedOps> Embeds<S> for Rounded<S> {
    #[inline(always)]
    fn holds<const K: usize>(_: &[[S; 3]; K]) -> bool {
        true
    }
    #[inline(always)]
    fn embed_held<const K: usize>(coordinates: &[[S; 3]; K]) -> [[Self; 3]; K] {
        convert(coordinates, Self(S::PLAIN_ZERO), Self)
    }

    const DIVIDES: bool = true;

    #[inline(always)]
    fn quotients([a, b, c]: [Self; 3], den: Self, _: [Self; 2]) -> ([S; 3], bool) {
        ([a.0.plain_div(den.0), b.0.plain_div(den.0), c.0.plain_div(den.0)], true)
    }
    #[inline(always)]
    fn quotient_of_lengths(num: Self, den: Self) -> S {
        num.0.plain_div(den.0)
    }
    #[inline(always)]
    fn coordinate(num: Self, den: Self, _: [Self; 2]) -> Option<S> {
        Some(num.0.plain_div(den.0))
    }
    #[inline(always)]
    fn compare_quotient(num: Self, den: Self, _: [Self; 2], t: S) -> Option<Ordering> {
        num.0.plain_div(den.0).partial_cmp(&t)
    }
}
