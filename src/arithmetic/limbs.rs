//! Unsigned integers of any size, their long division, and products and quotients of one limb where
//! registers are narrow.

use core::cmp::Ordering;

use super::index::Each;
use super::platform::{HAS_LONG_PRODUCTS, REGISTERS_ARE_WIDE};

/// An unsigned integer for long division and roots.
pub trait Wide: Copy + Ord {
    /// Subtracts another number, which is not greater.
    fn subtract(&mut self, other: &Self);
    /// Twice the number, which fits.
    fn double(&mut self);
    /// How many binary places the number has.
    fn width(&self) -> u32;
    /// Times two to the power `places`, which fits.
    fn shift_up(&mut self, places: u32);
}

macro_rules! wide {
    ($($t:ty)*) => {$(
        impl Wide for $t {
            #[inline(always)]
            fn subtract(&mut self, other: &Self) {
                *self -= *other;
            }
            #[inline(always)]
            fn double(&mut self) {
                *self <<= 1;
            }
            #[inline(always)]
            fn width(&self) -> u32 {
                Self::BITS - self.leading_zeros()
            }
            #[inline(always)]
            fn shift_up(&mut self, places: u32) {
                *self <<= places;
            }
        }
    )*};
}
wide! { u128 }
#[cfg(feature = "fixed")]
wide! { u64 }

/// An unsigned integer of L limbs, the least first.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Limbs<const L: usize>(pub(crate) [u64; L]);

impl<const L: usize> Limbs<L> {
    /// The magnitude of a number in two's complement, and whether it is below zero.
    // Negated in place. If one of two branches negates a copy by value, optimized builds of rustc 1.95
    // to 1.97 read the sign from the negated number.
    #[inline(always)]
    pub(crate) fn magnitude(mut limbs: [u64; L]) -> (bool, Self) {
        let is_negative = limbs.last().is_some_and(|top| top >> 63 != 0);
        if is_negative {
            let mut carry = true;
            for limb in &mut limbs {
                (*limb, carry) = (!*limb).overflowing_add(carry.into());
            }
        }
        (is_negative, Self(limbs))
    }
}

impl<const L: usize> Ord for Limbs<L> {
    #[inline(always)]
    fn cmp(&self, other: &Self) -> Ordering {
        self.0.iter().rev().cmp(other.0.iter().rev())
    }
}

impl<const L: usize> PartialOrd for Limbs<L> {
    #[inline(always)]
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

// Loops over indices, and in place: iterators over two arrays, or limbs of `u128`, took three to
// six times as long, and new arrays of many limbs twice.
impl<const L: usize> Wide for Limbs<L> {
    #[inline(always)]
    fn subtract(&mut self, other: &Self) {
        let mut borrow = false;
        for k in 0..L {
            let (rest, under) = self.0[k].overflowing_sub(other.0[k]);
            let (rest, under_too) = rest.overflowing_sub(borrow.into());
            (self.0[k], borrow) = (rest, under | under_too);
        }
    }
    #[inline(always)]
    fn double(&mut self) {
        let mut carry = 0;
        for k in 0..L {
            (self.0[k], carry) = (self.0[k] << 1 | carry, self.0[k] >> 63);
        }
    }
    #[inline(always)]
    fn width(&self) -> u32 {
        let top = self.0.iter().rposition(|&limb| limb != 0).unwrap_or(0);
        64 * top as u32 + self.0.get(top).map_or(0, |limb| 64 - limb.leading_zeros())
    }
    #[inline(always)]
    fn shift_up(&mut self, places: u32) {
        for _ in 0..places / 64 {
            self.0.rotate_right(1);
        }
        (0..places % 64).for_each(|_| self.double());
    }
}

/// The first `count` binary places of num/den, beginning with the ones, by long division; and the
/// doubled remainder in units of the last place. `num` is below twice `den`, which can be doubled.
#[inline(always)]
pub(super) fn divided_by_places<W: Wide>(num: W, den: &W, count: u32) -> (u64, W) {
    let (mut quotient, mut rest) = (0, num);
    for _ in 0..count {
        quotient <<= 1;
        if rest >= *den {
            rest.subtract(den);
            quotient |= 1;
        }
        rest.double();
    }
    (quotient, rest)
}

/// The product of two limbs.
#[inline(always)]
pub(super) fn limb_product(a: u64, b: u64) -> u128 {
    if REGISTERS_ARE_WIDE { u128::from(a) * u128::from(b) } else { full_product(a, b) }
}

/// The product of a limb and a word.
#[inline(always)]
pub(super) fn limb_by_word(a: u64, b: u32) -> u128 {
    let (low, high) = (word_product(a as u32, b), word_product((a >> 32) as u32, b));
    u128::from(low) + (u128::from(high) << 32)
}

/// The number times the power of two that makes its top bit one, and the exponent.
#[inline(always)]
pub(super) fn normal(x: u128) -> (u128, u32) {
    if REGISTERS_ARE_WIDE {
        let up = x.leading_zeros();
        return (x.wrapping_shl(up), up);
    }
    // By words first: zeros are counted in one, and all words are shifted alike.
    let [mut a, mut b, mut c, mut d] = [96, 64, 32, 0].each(|down| (x >> down) as u32);
    let mut up = 0;
    if a | b == 0 {
        (a, b, c, d, up) = (c, d, 0, 0, 64);
    }
    if a == 0 {
        (a, b, c, d, up) = (b, c, d, 0, up + 32);
    }
    let n = a.leading_zeros() & 31;
    let word = |high: u32, low: u32| high << n | low >> 1 >> (31 - n);
    let words = [word(a, b), word(b, c), word(c, d), d << n];
    (words.iter().fold(0, |x, &word| x << 32 | u128::from(word)), up + n)
}

/// The product of two limbs, from products of words.
#[inline(always)]
pub(super) fn full_product(a: u64, b: u64) -> u128 {
    let words = |x: u64| [x as u32, (x >> 32) as u32];
    let ([a0, a1], [b0, b1]) = (words(a), words(b));
    let low = word_product(a0, b0);
    // Below 2^64, because so is (2^32 − 1)² + 2·(2^32 − 1).
    let middle = word_product(a0, b1) + (low >> 32);
    let other = word_product(a1, b0) + u64::from(middle as u32);
    let high = word_product(a1, b1) + (middle >> 32) + (other >> 32);
    u128::from(high) << 64 | u128::from(other << 32 | u64::from(low as u32))
}

/// The product of two words.
#[inline(always)]
pub(super) fn word_product(a: u32, b: u32) -> u64 {
    if HAS_LONG_PRODUCTS { u64::from(a) * u64::from(b) } else { by_halves(a, b) }
}

/// The product of two words with signs.
#[inline(always)]
pub(crate) fn product(a: i32, b: i32) -> i64 {
    if HAS_LONG_PRODUCTS { i64::from(a) * i64::from(b) } else { by_signed_halves(a, b) }
}

/// The product of two words, for machines that have no long product: half of the instructions that the
/// compiler's product of two numbers of 64 bits takes.
#[inline(never)]
fn by_halves(a: u32, b: u32) -> u64 {
    let [[a0, a1], [b0, b1]] = [a, b].each(|x| [x & 0xffff, x >> 16]);
    let up = |x: u32| u64::from(x) << 16;
    (u64::from(a1 * b1) << 32 | u64::from(a0 * b0)) + up(a0 * b1) + up(a1 * b0)
}

/// The same with signs.
#[inline(never)]
fn by_signed_halves(a: i32, b: i32) -> i64 {
    let [[a0, a1], [b0, b1]] = [a, b].each(|x| [x & 0xffff, x >> 16]);
    let up = |x: i32| i64::from(x) << 16;
    let low = (a0 as u32) * (b0 as u32);
    (i64::from(a1 * b1) << 32 | i64::from(low)) + up(a0 * b1) + up(a1 * b0)
}

/// a·2^63/b rounded down, and the remainder, for two numbers whose top bit is set.
pub(super) fn divided_by_reciprocal(a: u64, b: u64) -> (u64, u64) {
    divided(a, b, inverse(b))
}

/// The [`reciprocal`] of a number whose top bit is set, for [`divided`].
#[inline(never)]
pub(super) fn inverse(b: u64) -> u32 {
    reciprocal((b >> 32) as u32 | 1 << 31)
}

/// The same, given the [`inverse`] of b.
///
/// Cores without a long division take the reciprocal of a word: three digits, each from the last
/// remainder, take a quarter of the instructions of 64 binary places.
///
/// No digit is too great, because the reciprocal is not, and rounding is downward. A digit of 29 bits is
/// at most three too low: the reciprocal lacks less than 2^-28 of itself, and two numbers are
/// cut. So each remainder is below four divisors, and each digit below 2^30.
#[inline(never)]
pub(super) fn divided(a: u64, b: u64, inverse: u32) -> (u64, u64) {
    // It is, and a zero would have no end.
    let b = b | 1 << 63;
    let (mut quotient, mut rest) = (0, u128::from(a) << 63);
    let mut digit = |down: u32, place: u32| {
        // 1/b is inverse/2^95.
        let digit = word_product((rest >> down) as u32, inverse) >> (95 + place - down);
        quotient += digit << place;
        rest -= limb_by_word(b, digit as u32) << place;
    };
    digit(96, 35);
    digit(70, 8);
    digit(44, 0);
    while rest >= u128::from(b) {
        rest -= u128::from(b);
        quotient += 1;
    }
    (quotient, rest as u64)
}

/// 2^63/(h + 1) rounded down, or less by at most 2^-28 of itself. The top bit of h is set.
///
/// With d = h/2^32 and y·2^-31 an estimate of 1/d, a step of Newton's method gives y·(2 − d·y), which
/// is never above 1/d and squares the relative error: 2^-4 at first, 2^-32 after three steps. The
/// product d·y is cut: 2 − d·y is too high by 2^-31 at most, and y by two. The difference between 1/h
/// and 1/(h + 1) is two more.
#[inline(always)]
fn reciprocal(h: u32) -> u32 {
    let upper = |a: u32, b: u32| (word_product(a, b) >> 32) as u32;
    // 2.819 − 1.875·d, in units of 2^-31, modulo 2^32.
    let mut y = 0x68d4_fdf3_u32.wrapping_sub(h - (h >> 4));
    for _ in 0..3 {
        y = upper(y, upper(h, y).wrapping_neg()) << 1;
    }
    y - 4
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::random::Random;

    #[test]
    fn limbs_carry() {
        let all = Limbs([u64::MAX, u64::MAX, u64::MAX, 0]);
        let one = Limbs([1, 0, 0, 0]);
        let next = Limbs([0, 0, 0, 1]);
        let with = |mut x: Limbs<4>, change: fn(&mut Limbs<4>)| {
            change(&mut x);
            x
        };
        assert!(Limbs([0; 4]) < one && one < all && all < next);
        assert_eq!(with(next, |x| x.subtract(&Limbs([1, 0, 0, 0]))), all);
        assert_eq!(with(all, Wide::double), Limbs([u64::MAX - 1, u64::MAX, u64::MAX, 1]));
        assert_eq!([Limbs([0; 4]), one, all, next].each(|x| x.width()), [0, 1, 192, 193]);
        assert_eq!(with(one, |x| x.shift_up(192)), next);
        assert_eq!(with(one, |x| x.shift_up(65)), Limbs([0, 2, 0, 0]));
        assert_eq!(Limbs::magnitude([u64::MAX; 4]), (true, one));
        assert_eq!(Limbs::magnitude([0, 0, 0, u64::MAX]), (true, next));
        assert_eq!(Limbs::magnitude(all.0), (false, all));
    }

    #[test]
    fn places_are_those_of_division() {
        for den in 1..=40_u128 {
            for num in 0..2 * den {
                for count in 0..20 {
                    let quotient = ((num << count) / (2 * den)) as u64;
                    let rest = (num << count) % (2 * den);
                    assert_eq!(divided_by_places(num, &den, count), (quotient, rest));
                    let limbs = |x: u128| Limbs([0, x as u64, 0]);
                    let places = divided_by_places(limbs(num), &limbs(den), count);
                    assert_eq!(places, (quotient, limbs(rest)));
                }
            }
        }
    }

    #[test]
    fn products_by_halves_are_products() {
        let words = [0, 1, 2, 0xffff, 0x1_0000, 0x8000_0001, 0xfff0_ffff, u32::MAX];
        for (a, b) in words.iter().flat_map(|&a| words.map(|b| (a, b))) {
            assert_eq!(by_halves(a, b), u64::from(a) * u64::from(b), "{a} {b}");
            let (a, b) = (a as i32, b as i32);
            assert_eq!(by_signed_halves(a, b), i64::from(a) * i64::from(b), "{a} {b}");
        }
    }

    fn check(a: u64, b: u64) {
        let num = u128::from(a) << 63;
        let (q, r) = ((num / u128::from(b)) as u64, (num % u128::from(b)) as u64);
        assert_eq!(divided_by_reciprocal(a, b), (q, r), "{a:x} / {b:x}");
    }

    /// Numbers of few digits, with runs of ones and of zeros, and of all digits.
    #[test]
    fn quotients_are_those_of_long_division() {
        let top = 1 << 63;
        let ends = [
            top,
            top + 1,
            top | 0xffff_ffff,
            top | 1 << 32,
            u64::MAX,
            u64::MAX - 1,
            u64::MAX << 32,
        ];
        for a in ends {
            for b in ends {
                check(a, b);
            }
        }
        let mut random = Random(0x0d15);
        let mut number = |n: u32| {
            let (bits, shift) = (random.bits(), random.bits() % 64);
            top | match n % 3 {
                0 => bits,
                1 => bits >> shift << shift,
                _ => bits | ((1 << shift) - 1),
            }
        };
        for n in 0..200_000 {
            check(number(n), number(n / 3));
        }
    }

    /// At every fourth bit pattern's neighbourhood, and at the ends.
    #[test]
    fn a_reciprocal_is_low_and_not_by_much() {
        let all = (1_u32 << 31..=u32::MAX).step_by(40_009);
        for h in all.chain([1 << 31, (1 << 31) + 1, u32::MAX - 1, u32::MAX]) {
            let (y, most) = (u64::from(reciprocal(h)), (1 << 63) / (u64::from(h) + 1));
            assert!(y <= most && most - y <= most >> 28, "{h:x}: {y} {most}");
        }
    }
}
