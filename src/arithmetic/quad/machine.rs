//! Quads for machines without vectors, or builds without the feature. The compiler leaves out the
//! fourth lane if nothing uses it.

use core::fmt::Debug;
use core::ops::{Add, Div, Mul, Sub};

use super::{OfFour, Quad};
use crate::arithmetic::{Number, greatest, least};

pub(crate) use crate::arithmetic::root as root_of_machine;

/// Four numbers, each on its own.
#[derive(Clone, Copy, Debug)]
pub struct Four<F>([F; 4]);

/// Lane by lane. Written out, because a loop that is not unrolled goes through memory.
#[inline(always)]
fn each<F: Copy>(Four(a): Four<F>, Four(b): Four<F>, f: impl Fn(F, F) -> F) -> Four<F> {
    Four([f(a[0], b[0]), f(a[1], b[1]), f(a[2], b[2]), f(a[3], b[3])])
}

impl<F: Number> Add for Four<F> {
    type Output = Self;
    #[inline(always)]
    fn add(self, other: Self) -> Self {
        each(self, other, F::add)
    }
}

impl<F: Number> Sub for Four<F> {
    type Output = Self;
    #[inline(always)]
    fn sub(self, other: Self) -> Self {
        each(self, other, F::sub)
    }
}

impl<F: Number + Mul<Output = F>> Mul for Four<F> {
    type Output = Self;
    #[inline(always)]
    fn mul(self, other: Self) -> Self {
        each(self, other, F::mul)
    }
}

impl<F: Number + Div<Output = F>> Div for Four<F> {
    type Output = Self;
    #[inline(always)]
    fn div(self, other: Self) -> Self {
        each(self, other, F::div)
    }
}

impl OfFour for f32 {
    type Quad = Four<f32>;
}

impl OfFour for f64 {
    type Quad = Four<f64>;
}

impl<F: Number + Debug + Mul<Output = F> + Div<Output = F>> Quad for Four<F> {
    type Lane = F;
    const IS_VECTOR: bool = false;

    #[inline(always)]
    fn new(lanes: [F; 4]) -> Self {
        Self(lanes)
    }
    #[inline(always)]
    fn to_array(self) -> [F; 4] {
        self.0
    }
    #[inline(always)]
    fn magnitude(self) -> Self {
        each(self, self, |x, _| x.magnitude())
    }
    #[inline(always)]
    fn least(self, other: Self) -> Self {
        each(self, other, least)
    }
    #[inline(always)]
    fn greatest(self, other: Self) -> Self {
        each(self, other, greatest)
    }
    #[inline(always)]
    fn exceeds(self, other: Self) -> u32 {
        let bit = |k: usize| u32::from(self.0[k] > other.0[k]) << k;
        bit(0) | bit(1) | bit(2) | bit(3)
    }
    #[inline(always)]
    fn is_at_most(self, other: Self) -> u32 {
        let bit = |k: usize| u32::from(self.0[k] <= other.0[k]) << k;
        bit(0) | bit(1) | bit(2) | bit(3)
    }
}
