//! Quotients of mantissas, and quotients between zero and one, rounded down to 64 digits.
//!
//! Each number of a scalar from zero to one has at most 64 digits. A quotient that is rounded down
//! again, to the scalar, therefore equals one that was rounded once. Rounding also keeps order: the
//! greatest rounded quotient is the greatest quotient, rounded.
//!
//! Cores without a long division take the reciprocal of a word: three digits, each from the last
//! remainder, take a quarter of the instructions of 64 binary places.

use super::integer::word_product;
use super::limbs::{Limbs, Wide, divided_by_places};
use super::soft::Soft;

/// Two numbers that enclose num/den, given the errors of num and den.
///
/// Each bound carries the roundings of a difference, a sum and a quotient: 3u of itself, to first
/// order. 8u are allowed, so 5 remain for the roundings of the bounds and for second orders.
#[inline(always)]
pub(super) fn enclosing(num: f64, den: f64, [num_error, den_error]: [f64; 2]) -> [Soft; 2] {
    const ROUNDINGS: f64 = 4.0 * f64::EPSILON;
    let lower = (num - num_error) / (den + den_error) * (1.0 - ROUNDINGS);
    let least = den - den_error;
    let upper = (num + num_error) / least * (1.0 + ROUNDINGS);
    let lower = if lower > f64::MIN_POSITIVE { Soft::of_normal(lower) } else { Soft::ZERO };
    // A NaN counts as outside.
    let is_known = (least > 0.0) & (upper < 1.0);
    let upper = if upper < f64::MIN_POSITIVE { f64::MIN_POSITIVE } else { upper };
    [lower, if is_known { Soft::of_normal(upper) } else { Soft::ONE }]
}

/// The quotient of two numbers above zero in a register. The first is not the greater.
#[inline(always)]
pub(super) fn divided_short(num: u64, den: u64) -> Soft {
    let places = num.leading_zeros() - den.leading_zeros();
    let rest = num << places;
    let is_less = rest < den;
    let wide = u128::from(rest) << if is_less { 64 } else { 63 };
    // At least 2^63 and below 2^64; the divisor is above zero.
    let mantissa = wide.checked_div(den.into()).unwrap_or(0) as u64;
    Soft::rounded_down(mantissa, -63 - i32::from(is_less) - places as i32)
}

/// The quotient for longer numbers.
#[inline(never)]
pub(super) fn divided(num: u128, den: u128) -> Soft {
    if let (Ok(num), Ok(den)) = (u64::try_from(num), u64::try_from(den)) {
        return divided_short(num, den);
    }
    by_places(num, &den)
}

/// The quotient of two numbers above zero that can be doubled. The first is not the greater.
#[inline(always)]
fn by_places<W: Wide>(mut num: W, den: &W) -> Soft {
    let places = den.width().saturating_sub(num.width());
    num.shift_up(places);
    // If the first place is zero, there are 65 places, and the word drops that one.
    let is_less = num < *den;
    let (mantissa, _) = divided_by_places(num, den, 64 + u32::from(is_less));
    Soft::rounded_down(mantissa, -63 - i32::from(is_less) - places as i32)
}

/// The quotient of numbers in limbs.
#[cold]
#[inline(never)]
pub(super) fn divided_limbs<const L: usize>(num: Limbs<L>, den: &Limbs<L>) -> Soft {
    by_places(num, den)
}

/// a·2^63/b rounded down, and the remainder, for two numbers whose top bit is set.
///
/// No digit is too great, because the reciprocal is not, and rounding is downward. A digit of 29 bits is
/// at most three too low: the reciprocal lacks less than 2^-28 of itself, and two numbers are
/// cut. So each remainder is below four divisors, and each digit below 2^30.
#[inline(never)]
pub(super) fn divided_by_reciprocal(a: u64, b: u64) -> (u64, u64) {
    // It is, and a zero would have no end.
    let b = b | 1 << 63;
    let inverse = reciprocal((b >> 32) as u32);
    let (mut quotient, mut rest) = (0, u128::from(a) << 63);
    let mut digit = |down: u32, place: u32| {
        // 1/b is inverse/2^95.
        let digit = word_product((rest >> down) as u32, inverse) >> (95 + place - down);
        quotient += digit << place;
        let low = u128::from(word_product(digit as u32, b as u32));
        let high = u128::from(word_product(digit as u32, (b >> 32) as u32));
        rest -= (low + (high << 32)) << place;
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
    use super::{Limbs, Soft, divided_by_reciprocal, divided_limbs, reciprocal};
    use crate::arithmetic::Number;
    use crate::arithmetic::wide::I256;
    use crate::random::Random;

    const ZERO: [i64; 2] = [0; 2];

    /// All widths divide alike, and like long division on paper.
    #[test]
    fn all_widths_agree() {
        let numbers = [1_i64, 2, 3, 5, 7, 11, 1 << 20, (1 << 20) + 1, 0x1234_5678_9abc, 1 << 55];
        for den in numbers {
            for num in numbers.into_iter().filter(|&num| num <= den) {
                let [short, upper] = num.portion(den, ZERO);
                assert_eq!(short, upper);
                let (whole, unit) = short.floor(64, -2000);
                // whole·2^unit ≤ num/den < (whole + 1)·2^unit, all below 2^120.
                let scaled = u128::from(num.unsigned_abs()) << -unit;
                let (whole, divisor) = (u128::from(whole), u128::from(den.unsigned_abs()));
                assert!(whole >> 63 == 1 && whole * divisor <= scaled, "{num}/{den}");
                assert!(scaled < (whole + 1) * divisor, "{num}/{den}");

                for shift in [0, 60] {
                    let (n, d) = (i128::from(num) << shift, i128::from(den) << shift);
                    assert_eq!(n.portion(d, [0; 2])[0], short, "{num}/{den}");
                }
                let (n, d) = (I256::product(1 << 90, num), I256::product(1 << 90, den));
                assert_eq!(n.portion(d, [d; 2])[0], short, "{num}/{den}");
                for (i, k) in [(0, 0), (1, 1), (2, 2)] {
                    let (mut n, mut d) = ([0; 4], [0; 4]);
                    (n[i], d[k]) = (num as u64, den as u64);
                    assert_eq!(divided_limbs(Limbs(n), &Limbs(d)), short, "{num}/{den}");
                }
                let (mut n, mut d) = ([0; 4], [0; 4]);
                (n[0], d[2]) = (num as u64, den as u64);
                let far = divided_limbs(Limbs(n), &Limbs(d));
                assert_eq!(far, short.scaled(-128));
            }
        }
    }

    #[test]
    fn floats_enclose_the_quotient() {
        for (num, den) in [(1.0, 3.0), (1e-200, 7.0), (0.9999999, 1.0), (5.0, 5.0)] {
            let [low, high] = f64::portion(num, den, [0.0; 2]);
            assert!(low.is_less_than(high), "{num}/{den}");
            let [lower, higher] = f64::portion(num, den, [num * 1e-10, den * 1e-10]);
            assert!(lower.is_less_than(low) && !higher.is_less_than(high));
        }
        assert_eq!(
            f64::portion(1.0, 0.5, [0.0, 1.0]),
            [f64::portion(1.0, 1.5, [0.0; 2])[0], Soft::ONE]
        );
        assert_eq!(f64::portion(-1.0, 0.5, [0.0; 2])[0], Soft::ZERO);
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
