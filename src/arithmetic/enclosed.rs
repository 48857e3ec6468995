//! Numbers that are enclosed: in an interval, or without any rounding.

use core::cmp::Ordering;

use super::big_int::BigInt;
use super::interval::Interval;
use super::number::{Limbed, Number};
use super::soft::Soft;

/// A number with a bound on its error, or an exact one.
pub trait Enclosed: Number {
    /// The magnitude; `None` if the bound is too wide, or the number is zero.
    fn soft(self) -> Option<Soft>;

    /// The number in two's complement, the least limb first, if it is exact.
    fn exact_limbs(&self) -> Option<&[u64]>;
}

impl Enclosed for Interval {
    fn soft(self) -> Option<Soft> {
        Self::soft(self)
    }
    fn exact_limbs(&self) -> Option<&[u64]> {
        None
    }
}

impl<const L: usize> Enclosed for BigInt<L> {
    fn soft(self) -> Option<Soft> {
        Soft::of_limbs(self.magnitude().limbs())
    }
    fn exact_limbs(&self) -> Option<&[u64]> {
        Some(self.limbs())
    }
}

/// The sign of a number; `None` in doubt.
#[inline(always)]
pub(crate) fn sign_of<T: Number>(x: T) -> Option<Ordering> {
    x.partial_cmp(&T::ZERO)
}

/// Adds x·factor·2^shift to a sum, or subtracts it; `None` if x is not exact.
pub(crate) fn sum_of<const R: usize, T: Enclosed>(
    sum: &mut BigInt<R>,
    x: T,
    factor: u128,
    shift: u32,
    is_minus: bool,
) -> Option<()> {
    let is_negative = x < T::ZERO;
    let x = x.magnitude();
    let limbs = x.exact_limbs()?;
    for (i, factor) in [factor as u64, (factor >> 64) as u64].into_iter().enumerate() {
        for (k, &limb) in limbs.iter().enumerate().filter(|(_, limb)| **limb != 0) {
            let product = u128::from(limb) * u128::from(factor);
            let words = [product as u64, (product >> 64) as u64];
            let place = 64 * (i + k) + shift as usize;
            sum.accumulate(words.into_iter(), place, is_negative != is_minus);
        }
    }
    Some(())
}
