//! Exact sums of products: the last resort, for any input whatever.

use core::cmp::Ordering;

#[cfg(feature = "fixed")]
use crate::arithmetic::{Dividend, I256, quotient_of_limbs};
use crate::arithmetic::{Limbs, Parts, Soft, divided_limbs};

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
    fn portion(&self, den: &Self) -> Soft;
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
        // Two and two: most magnitudes are so short that their products need no more than a word.
        let mut pairs = [1_u128; 2];
        let (mut shift, mut negative) = (0, false);
        for (k, f) in factors.iter().enumerate() {
            if f.magnitude == 0 {
                return;
            }
            // The first factor of a pair meets one.
            pairs[k / 2 % 2] *= u128::from(f.magnitude);
            shift += usize::from(f.shift);
            negative ^= f.negative;
        }
        match pairs.map(u64::try_from) {
            [Ok(a), Ok(b)] => {
                let product = u128::from(a) * u128::from(b);
                self.accumulate(&[product as u64, (product >> 64) as u64], shift, negative);
            }
            _ => self.accumulate(&product(pairs), shift, negative),
        }
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

    fn portion(&self, den: &Self) -> Soft {
        divided_limbs(Limbs(self.0), &Limbs(den.0))
    }
}

impl<const LIMBS: usize> Sum<LIMBS> {
    /// Whether the sum is below zero, and its magnitude in limbs, least first.
    pub(crate) fn magnitude(&self) -> (bool, [u64; LIMBS]) {
        let (is_negative, Limbs(magnitude)) = Limbs::magnitude(self.0);
        (is_negative, magnitude)
    }

    /// num·2^shift / den to the nearest, of two the even one, no farther out than `i64` goes; the
    /// divisor is not zero.
    #[cfg(feature = "fixed")]
    pub(crate) fn quotient(&self, den: &Self, shift: u32) -> i64 {
        match (self.as_i256(), den.as_i256()) {
            (Some(num), Some(den)) => num.quotient(den, shift),
            _ => quotient_of_limbs(&self.0, &den.0, shift),
        }
    }

    /// The sum in 256 bits, if these leave a few to spare: always but for products of four
    /// numbers of 64 bits.
    #[cfg(feature = "fixed")]
    fn as_i256(&self) -> Option<I256> {
        let fill = if self.sign() == Ordering::Less { u64::MAX } else { 0 };
        let mut limbs = [fill; 4];
        for (to, &limb) in limbs.iter_mut().zip(&self.0) {
            *to = limb;
        }
        let is_spare = self.0.iter().skip(4).all(|&limb| limb == fill);
        let has_room = self.0.get(4).is_none() || (limbs[3] ^ fill) >> 58 == 0;
        (is_spare && has_room).then_some(I256::from_limbs(limbs))
    }

    /// Adds or subtracts `product` shifted up by `shift` bits.
    #[inline(always)]
    fn accumulate(&mut self, product: &[u64], shift: usize, negative: bool) {
        let bit = (shift % 64) as u32;
        let mut words = product.iter();
        let mut below = 0_u64;
        let mut carry = negative; // subtracting is adding the complement, and one
        for limb in self.0.iter_mut().skip(shift / 64) {
            let next = words.next();
            // All has arrived, and what is left would be added nothing, or taken nothing.
            if next.is_none() && (bit == 0 || below == 0) && carry == negative {
                break;
            }
            let word = next.copied().unwrap_or(0);
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

/// The product of two numbers, in limbs, least first.
fn product([a, b]: [u128; 2]) -> [u64; 4] {
    let halves = |x: u128| [u128::from(x as u64), x >> 64];
    let ([a, c], [b, d]) = (halves(a), halves(b));
    let (low, high) = (a * b, c * d);
    let [first, carry] = halves(low);
    // Below 3·2^64.
    let middle = carry + u128::from((a * d) as u64) + u128::from((c * b) as u64);
    let [second, carry] = halves(middle);
    let high = high + ((a * d) >> 64) + ((c * b) >> 64) + carry;
    [first as u64, second as u64, high as u64, (high >> 64) as u64]
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
