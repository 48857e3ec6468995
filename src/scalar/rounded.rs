//! A scalar's own arithmetic, taken at its word.

use core::cmp::Ordering;
use core::ops::{Add, Mul, Neg, Sub};

use super::Scalar;
use super::number::Number;
use super::numbers::{Holds, Numbers, Placed, convert};

/// The number system of the rounded methods: length, area and volume are all
/// the scalar itself, every result is rounded as the scalar rounds, and a
/// fixed-point overflow wraps. Nothing here is exact.
#[derive(Clone, Copy, Debug, PartialEq, PartialOrd)]
pub struct Rounded<S>(pub S);

impl<S: Scalar> Add for Rounded<S> {
    type Output = Self;
    #[inline(always)]
    fn add(self, other: Self) -> Self {
        Self(self.0.plain_add(other.0))
    }
}

impl<S: Scalar> Sub for Rounded<S> {
    type Output = Self;
    #[inline(always)]
    fn sub(self, other: Self) -> Self {
        Self(self.0.plain_sub(other.0))
    }
}

impl<S: Scalar> Mul for Rounded<S> {
    type Output = Self;
    #[inline(always)]
    fn mul(self, other: Self) -> Self {
        Self(self.0.plain_mul(other.0))
    }
}

impl<S: Scalar> Neg for Rounded<S> {
    type Output = Self;
    #[inline(always)]
    fn neg(self) -> Self {
        Self(S::ZERO.plain_sub(self.0))
    }
}

impl<S: Scalar> Number for Rounded<S> {
    const ZERO: Self = Self(S::ZERO);
    #[inline(always)]
    fn magnitude(self) -> Self {
        Self(self.0.plain_abs())
    }
}

impl<S: Scalar> Numbers for Rounded<S> {
    type Length = Self;
    type Area = Self;
    type Volume = Self;
    type Slim = Self;

    const FINAL: bool = true;
    const ONE_FORM: bool = false;

    #[inline(always)]
    fn area(a: Self, b: Self) -> Self {
        a * b
    }
    #[inline(always)]
    fn volume(a: Self, b: Self) -> Self {
        a * b
    }
    #[inline(always)]
    fn from_center(v: Self, center: Self) -> Self {
        v - center
    }
    #[inline(always)]
    fn from_corners(v: Self, min: Self, max: Self) -> Self {
        Self(((v - min) + (v - max)).0.plain_half())
    }
    #[inline(always)]
    fn half_extent(half: Self) -> Self {
        half
    }
    #[inline(always)]
    fn half_between(min: Self, max: Self) -> Self {
        Self((max - min).0.plain_half())
    }
    #[inline(always)]
    fn middle(n: Self) -> Self {
        Self(n.0.plain_half())
    }
    type Product = Self;
    #[inline(always)]
    fn operand(a: Self) -> Self {
        a
    }
    #[inline(always)]
    fn length_error(_: Self, _: u8) -> Self {
        Self::ZERO
    }
    #[inline(always)]
    fn area_error(_: Self, _: u8) -> Self {
        Self::ZERO
    }
    #[inline(always)]
    fn widened(slim: Self) -> Self {
        slim
    }
    #[inline(always)]
    fn volume_bound(_: Self, _: Self, _: Self, _: u8) -> Option<Self> {
        Some(Self::ZERO)
    }
    #[inline(always)]
    fn is_slim(_: Self) -> bool {
        false
    }
    #[inline(always)]
    fn bounds(_: Self, _: u8, _: u8) -> Option<(Self, Self)> {
        Some((Self::ZERO, Self::ZERO))
    }
}

impl<S: Scalar> Holds<S> for Rounded<S> {
    const DIVIDES: bool = true;

    #[inline(always)]
    fn fits<const K: usize>(_: &[[S; 3]; K]) -> bool {
        true
    }
    #[inline(always)]
    fn quotients([a, b, c]: [Self; 3], den: Self, _: [Self; 2]) -> ([S; 3], bool) {
        ([a.0.plain_div(den.0), b.0.plain_div(den.0), c.0.plain_div(den.0)], true)
    }
    #[inline(always)]
    fn quotient_of_lengths(num: Self, den: Self) -> S {
        num.0.plain_div(den.0)
    }
    #[inline(always)]
    fn compare_quotient(num: Self, den: Self, _: [Self; 2], t: S) -> Option<Ordering> {
        num.0.plain_div(den.0).partial_cmp(&t)
    }
    #[inline(always)]
    fn place<const P: usize, const E: usize>(
        points: &[[S; 3]; P],
        extents: &[[S; 3]; E],
    ) -> Placed<Self, P, E> {
        Placed {
            points: convert(points, Self::ZERO, |_, x| Self(x)),
            extents: convert(extents, Self::ZERO, |_, x| Self(x)),
        }
    }
}
