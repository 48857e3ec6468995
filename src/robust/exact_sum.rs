//! Exact sums of products, and areas and determinants of differences as such sums.
//!
//! No difference is computed, because it might round. A difference is a list of signed coordinates,
//! and a product of differences is the sum of all products with one coordinate of each list. Only
//! the sum's sign is used.

use core::cmp::Ordering;

use crate::arithmetic::{BigInt, Each, Limbed, Number, Parts, pick, three, turn};
use crate::scalar::Backend;

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

/// A sum of up to three signed coordinates.
pub(crate) type Linear = [Parts; 3];

/// A vector of three such sums.
pub(crate) type Vector = [Linear; 3];

/// A coordinate alone.
pub(crate) fn single(a: Parts) -> Linear {
    [a, Parts::ZERO, Parts::ZERO]
}

/// a − b.
pub(crate) fn difference(a: Parts, b: Parts) -> Linear {
    [a, b.negated(), Parts::ZERO]
}

/// A point's coordinates.
pub(crate) fn singles<S: Backend>(x: [S; 3]) -> Vector {
    x.each(|x| single(x.parts()))
}

/// a − b.
#[inline(never)]
pub(crate) fn differences<S: Backend>(a: &[S; 3], b: &[S; 3]) -> Vector {
    three(|i| difference(a[i].parts(), b[i].parts()))
}

/// The vector along coordinate axis `i` of length `one`.
pub(crate) fn along_axis(i: usize, one: Parts) -> Vector {
    three(|k| single(if k == i { one } else { Parts::ZERO }))
}

const UNIT: Linear = [Parts::UNIT, Parts::ZERO, Parts::ZERO];

/// Adds a·b·c to the sum or subtracts it, times `factor` if there is one. Out of line, because rare
/// code should be small.
#[inline(never)]
fn add_product<T: ExactSum>(
    sum: &mut T,
    [a, b, c]: [&Linear; 3],
    factor: Option<Parts>,
    minus: bool,
) {
    let nonzero = |x: &&Parts| x.magnitude != 0;
    for &x in a.iter().filter(nonzero) {
        let x = if minus { x.negated() } else { x };
        for &y in b.iter().filter(nonzero) {
            for &z in c.iter().filter(nonzero) {
                match factor {
                    Some(factor) => sum.add(&[factor, x, y, z]),
                    None => sum.add(&[x, y, z]),
                }
            }
        }
    }
}

/// The sign of (a × b)·c. Out of line, as all that make a sum alone: it takes up to 1 KB.
#[inline(never)]
pub(crate) fn side<T: ExactSum>(vectors: [&Vector; 3]) -> Ordering {
    let mut sum = T::new();
    add_determinant(&mut sum, vectors, None);
    sum.sign()
}

/// The sign of component `i` of a × b.
#[inline(never)]
pub(crate) fn minor_sign<T: ExactSum>(a: &Vector, b: &Vector, i: usize) -> Ordering {
    let mut sum = T::new();
    add_minor(&mut sum, a, b, i, false);
    sum.sign()
}

/// The sign of a sum of coordinates.
#[inline(never)]
pub(crate) fn sign<T: ExactSum>(x: &Linear) -> Ordering {
    let mut sum = T::new();
    add_product(&mut sum, [x, &UNIT, &UNIT], None, false);
    sum.sign()
}

/// Adds a·b to the sum or subtracts it.
pub(crate) fn add_area<T: ExactSum>(sum: &mut T, a: &Linear, b: &Linear, minus: bool) {
    add_product(sum, [a, b, &UNIT], None, minus);
}

/// Adds component `i` of a × b to the sum or subtracts it.
pub(crate) fn add_minor<T: ExactSum>(sum: &mut T, a: &Vector, b: &Vector, i: usize, minus: bool) {
    let (_, j, k) = turn(i);
    add_area(sum, pick(a, j), pick(b, k), minus);
    add_area(sum, pick(a, k), pick(b, j), !minus);
}

/// Adds (a × b)·c to the sum, times `factor` if there is one.
pub(crate) fn add_determinant<T: ExactSum>(
    sum: &mut T,
    [a, b, c]: [&Vector; 3],
    factor: Option<Parts>,
) {
    for i in 0..3 {
        let (i, j, k) = turn(i);
        add_product(sum, [pick(a, j), pick(b, k), pick(c, i)], factor, false);
        add_product(sum, [pick(a, k), pick(b, j), pick(c, i)], factor, true);
    }
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
