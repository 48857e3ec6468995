//! A number for each of several directions, in one word or side by side.

use core::ops::{Add, Div, Mul, Sub};

use super::filter::Measure;
use crate::arithmetic::{Quad, greatest, least};

/// A number for each of several directions: a float, or four as hosts have them. Comparisons with NaN
/// are false.
pub(super) trait Lanes:
    Copy + Add<Output = Self> + Sub<Output = Self> + Mul<Output = Self> + Div<Output = Self>
{
    type Lane: Measure;
    /// Numbers of 16 directions or more, against them and along them.
    type All: AsRef<[[Self; 2]]> + AsMut<[[Self; 2]]>;
    /// How many.
    const COUNT: usize;

    fn all(all: [Self; 2]) -> Self::All;
    fn of(lane: impl Fn(usize) -> Self::Lane) -> Self;
    fn lane(self, n: usize) -> Self::Lane;
    fn size(self) -> Self;
    fn most(self, other: Self) -> Self;
    fn least(self, other: Self) -> Self;
    /// The lanes in which this is the greater, as bits.
    fn is_above(self, other: Self) -> u32;
    /// The lanes in which this is at most `other`.
    fn is_within(self, other: Self) -> u32;

    #[inline(always)]
    fn same(x: Self::Lane) -> Self {
        Self::of(|_| x)
    }
}

impl Lanes for f64 {
    type Lane = Self;
    type All = [[Self; 2]; 16];
    const COUNT: usize = 1;

    fn all(all: [Self; 2]) -> Self::All {
        [all; 16]
    }
    #[inline(always)]
    fn of(lane: impl Fn(usize) -> Self) -> Self {
        lane(0)
    }
    #[inline(always)]
    fn lane(self, _: usize) -> Self {
        self
    }
    #[inline(always)]
    fn size(self) -> Self {
        self.abs()
    }
    #[inline(always)]
    fn most(self, other: Self) -> Self {
        greatest(self, other)
    }
    #[inline(always)]
    fn least(self, other: Self) -> Self {
        least(self, other)
    }
    #[inline(always)]
    fn is_above(self, other: Self) -> u32 {
        (self > other).into()
    }
    #[inline(always)]
    fn is_within(self, other: Self) -> u32 {
        (self <= other).into()
    }
}

impl<Q: Quad<Lane: Measure>> Lanes for Q {
    type Lane = Q::Lane;
    type All = [[Self; 2]; 4];
    const COUNT: usize = 4;

    #[inline(always)]
    fn all(all: [Self; 2]) -> Self::All {
        [all; 4]
    }
    #[inline(always)]
    fn of(lane: impl Fn(usize) -> Q::Lane) -> Self {
        Q::new([lane(0), lane(1), lane(2), lane(3)])
    }
    #[inline(always)]
    fn lane(self, n: usize) -> Q::Lane {
        self.to_array()[n % 4]
    }
    #[inline(always)]
    fn size(self) -> Self {
        self.magnitude()
    }
    #[inline(always)]
    fn most(self, other: Self) -> Self {
        self.greatest(other)
    }
    #[inline(always)]
    fn least(self, other: Self) -> Self {
        Quad::least(self, other)
    }
    #[inline(always)]
    fn is_above(self, other: Self) -> u32 {
        self.exceeds(other)
    }
    #[inline(always)]
    fn is_within(self, other: Self) -> u32 {
        self.is_at_most(other)
    }
}
