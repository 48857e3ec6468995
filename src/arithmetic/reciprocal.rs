//! The quotient of two mantissas from the reciprocal of a word: for cores without a long division.
//! Three digits, each from the last remainder, take a quarter of the instructions of 64 binary places.

use super::integer::word_product;

/// a·2^63/b rounded down, and the remainder, for two numbers whose top bit is set.
///
/// No digit is too great, because the reciprocal is not, and rounding is downward. A digit of 29 bits is
/// at most three too low: the reciprocal lacks less than 2^-28 of itself, and two numbers are
/// cut. So each remainder is below four divisors, and each digit below 2^30.
#[inline(never)]
pub(super) fn divided(a: u64, b: u64) -> (u64, u64) {
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
    use super::{divided, reciprocal};
    use crate::random::Random;

    fn check(a: u64, b: u64) {
        let num = u128::from(a) << 63;
        let (q, r) = ((num / u128::from(b)) as u64, (num % u128::from(b)) as u64);
        assert_eq!(divided(a, b), (q, r), "{a:x} / {b:x}");
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
