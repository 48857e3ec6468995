//! Exact sums of products.

use core::cmp::Ordering;

use crate::arithmetic::{BigInt, Each, Limbed, Number, Parts};

/// A sum of products of up to four numbers without loss.
pub trait ExactSum: Limbed + Number {
    /// The empty sum.
    fn new() -> Self;
    /// Adds the product of at most four `factors`, all of one type. All terms of a sum have the
    /// same number of factors, apart from integers with shift zero.
    fn add(&mut self, factors: &[Parts]);
    /// Adds the product of a sum and a number, with at most four factors in all.
    fn add_multiple(&mut self, sum: &Self, factor: Parts);
    /// How the sum compares with zero.
    fn sign(&self) -> Ordering;
}

/// A sum in two's complement: Kulisch's long accumulator, with a length that depends on the scalar.
pub(crate) type Sum<const LIMBS: usize> = BigInt<LIMBS>;

impl<const LIMBS: usize> ExactSum for Sum<LIMBS> {
    fn new() -> Self {
        BigInt([0; LIMBS])
    }

    fn add(&mut self, factors: &[Parts]) {
        debug_assert!(factors.len() <= 4);
        // In pairs: most magnitudes are so short that the product of two fits a word.
        let mut pairs = [1_u128; 2];
        let (mut shift, mut negative) = (0, false);
        for (k, f) in factors.iter().enumerate() {
            if f.magnitude == 0 {
                return;
            }
            // The first factor of a pair is multiplied by one.
            pairs[k / 2 % 2] *= u128::from(f.magnitude);
            shift += usize::from(f.shift);
            negative ^= f.negative;
        }
        match pairs.each(u64::try_from) {
            [Ok(a), Ok(b)] => {
                let product = u128::from(a) * u128::from(b);
                let words = [product as u64, (product >> 64) as u64];
                self.accumulate(words.iter().copied(), shift, negative);
            }
            _ => self.accumulate(product(pairs).iter().copied(), shift, negative),
        }
    }

    fn add_multiple(&mut self, sum: &Self, factor: Parts) {
        BigInt::add_multiple(self, sum, factor.magnitude, factor.shift.into(), factor.negative);
    }

    fn sign(&self) -> Ordering {
        BigInt::sign(self)
    }
}

/// The product of two numbers in limbs, least first.
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
