//! Exact sums of products: the last resort, for any input whatever.

use core::cmp::Ordering;

#[cfg(feature = "fixed")]
use crate::arithmetic::I256;
use crate::arithmetic::{Leading, Parts, Portion, divided_limbs};

/// A sum of products of up to four numbers that loses nothing.
pub trait ExactSum {
    /// The empty sum.
    fn new() -> Self;
    /// Adds the product of at most four `factors`, all of one type; all terms
    /// of a sum have equally many, besides whole ones of shift zero.
    fn add(&mut self, factors: &[Parts]);
    /// How the sum compares with zero.
    fn sign(&self) -> Ordering;
    /// The sum in two's complement, least limb first, in units of the product of as
    /// many least numbers as a term has factors.
    fn limbs(&self) -> &[u64];
    /// The quotient of two sums above zero, this not the greater, rounded down.
    fn portion(&self, den: &Self) -> Portion;
}

/// A sum in two's complement, least limb first. Kulisch's long accumulator,
/// as long as the scalar asks for.
#[derive(Clone, Copy, Debug)]
pub struct Sum<const LIMBS: usize>([u64; LIMBS]);

impl<const LIMBS: usize> ExactSum for Sum<LIMBS> {
    fn new() -> Self {
        Self([0; LIMBS])
    }

    fn add(&mut self, factors: &[Parts]) {
        debug_assert!(factors.len() <= 4);
        let mut product = [1, 0, 0, 0];
        let (mut shift, mut negative) = (0, false);
        for f in factors {
            if f.magnitude == 0 {
                return;
            }
            times(&mut product, f.magnitude);
            shift += usize::from(f.shift);
            negative ^= f.negative;
        }
        self.accumulate(product, shift, negative);
    }

    fn sign(&self) -> Ordering {
        if self.0.last().is_some_and(|top| top >> 63 != 0) {
            Ordering::Less
        } else if self.0.iter().any(|&limb| limb != 0) {
            Ordering::Greater
        } else {
            Ordering::Equal
        }
    }

    fn limbs(&self) -> &[u64] {
        &self.0
    }

    fn portion(&self, den: &Self) -> Portion {
        divided_limbs(self.0, &den.0)
    }
}

impl<const LIMBS: usize> Sum<LIMBS> {
    /// The leading bits.
    pub(crate) fn leading(&self) -> Leading {
        let negative = self.sign() == Ordering::Less;
        let (mut magnitude, mut carry) = (self.0, negative);
        if negative {
            for limb in &mut magnitude {
                (*limb, carry) = (!*limb).overflowing_add(carry.into());
            }
        }
        Leading::new(negative, &magnitude)
    }

    /// The sum, which must be one of products of three.
    #[cfg(feature = "fixed")]
    pub(crate) fn as_i256(&self) -> I256 {
        let fill = if self.sign() == Ordering::Less { u64::MAX } else { 0 };
        let mut limbs = [fill; 4];
        for (to, &limb) in limbs.iter_mut().zip(&self.0) {
            *to = limb;
        }
        I256::from_limbs(limbs)
    }

    /// Adds or subtracts `product` shifted up by `shift` bits.
    fn accumulate(&mut self, product: [u64; 4], shift: usize, negative: bool) {
        let bit = (shift % 64) as u32;
        let mut words = product.into_iter();
        let mut below = 0_u64;
        let mut carry = negative; // subtracting is adding the complement, and one
        for limb in self.0.iter_mut().skip(shift / 64) {
            let word = words.next().unwrap_or(0);
            let shifted = word.wrapping_shl(bit) | if bit == 0 { 0 } else { below >> (64 - bit) };
            below = word;
            let addend = if negative { !shifted } else { shifted };
            let (sum, over) = limb.overflowing_add(addend);
            let (sum, over_too) = sum.overflowing_add(carry.into());
            *limb = sum;
            carry = over | over_too;
        }
    }
}

/// Multiplies `product` by `factor`; four limbs hold four factors.
fn times(product: &mut [u64; 4], factor: u64) {
    let mut carry = 0;
    for limb in product {
        let wide = u128::from(*limb) * u128::from(factor) + u128::from(carry);
        *limb = wide as u64;
        carry = (wide >> 64) as u64;
    }
    debug_assert_eq!(carry, 0);
}

#[cfg(test)]
mod tests {
    use super::*;

    fn parts(x: i64, shift: u16) -> Parts {
        Parts { negative: x < 0, magnitude: x.unsigned_abs(), shift }
    }

    #[test]
    fn extremes_cancel_to_the_last_unit() {
        let mut sum = Sum::<5>::new();
        let m = parts(i64::MIN, 0);
        let below = parts(i64::MIN + 1, 0);
        let one = parts(1, 0);
        // m⁴ − m³·(m + 1) + m³ = 0
        sum.add(&[m, m, m, m]);
        sum.add(&[parts(-1, 0), m, m, m]);
        assert_eq!(sum.sign(), Ordering::Greater);
        let mut minus = below;
        minus.negative = false;
        sum.add(&[minus, m, m, m]);
        sum.add(&[one, m, m, m]);
        sum.add(&[one, m, m, m]);
        assert_eq!(sum.sign(), Ordering::Equal);
        sum.add(&[parts(-1, 0)]);
        assert_eq!(sum.sign(), Ordering::Less);
    }

    #[test]
    fn agrees_with_i128_at_every_shift() {
        for shift in 0..100 {
            for a in [-7, -1, 1, 3, i64::from(u32::MAX)] {
                for b in [-5, 1, 2, i64::from(i32::MIN)] {
                    let mut sum = Sum::<4>::new();
                    sum.add(&[parts(a, shift), parts(1, 0)]);
                    sum.add(&[parts(b, shift), parts(1, 0)]);
                    assert_eq!(sum.sign(), (a + b).cmp(&0), "({a} + {b}) << {shift}");
                }
            }
        }
    }
}
