//! Floats as short multiples of a power of two, and quotients of their products, for cores with
//! 32-bit integers and no `f64`.
//!
//! Numbers that are multiples of 2^-28 of the greatest are exact in `i32`. Volumes are then exact,
//! and their quotient is computed to 2^-50 of itself. It is returned only if the next wider stages
//! would round to the same float; see [`ShortFloat::rounded_quotient`].

/// The leading 64 bits of a number: magnitude·2^exponent, with the top bit of the magnitude set.
/// Less than one unit is missing.
#[derive(Clone, Copy)]
pub struct Leading64 {
    is_negative: bool,
    magnitude: u64,
    exponent: i32,
}

impl Leading64 {
    /// The leading bits of a number below 2^96, if it is not zero.
    pub(crate) fn new(x: i128) -> Option<Self> {
        // In words of 32 bits, because shifts by a variable are long there.
        let magnitude = x.unsigned_abs();
        let (upper, lower) = ((magnitude >> 32) as u64, magnitude as u32);
        let (upper, lower, exponent) = if upper >> 32 != 0 {
            (upper, lower, 32)
        } else if upper != 0 {
            (upper << 32 | u64::from(lower), 0, 0)
        } else if lower != 0 {
            (u64::from(lower) << 32, 0, -32)
        } else {
            return None;
        };
        let (high, middle) = ((upper >> 32) as u32, upper as u32);
        let zeros = high.leading_zeros();
        let from_below = |x: u32, below: u32| x << zeros | below >> 1 >> (31 - zeros);
        let word = |x: u32, below: u32| u64::from(from_below(x, below));
        Some(Self {
            is_negative: x < 0,
            magnitude: word(high, middle) << 32 | word(middle, lower),
            exponent: exponent - zeros as i32,
        })
    }

    /// The number of bits that hold the integer.
    pub(crate) fn bits(self) -> i32 {
        self.exponent + 64
    }
}

/// A divisor, and approximately its reciprocal.
///
/// Let y = magnitude/2^64, in [1/2, 1), and D its upper word.
pub struct Divisor {
    den: Leading64,
    /// 2^31/y, less up to 2^-27 of itself. The start is 2^32 over the upper half of D plus one,
    /// with at most 2^-14 missing. One step of Newton's method leaves the square of that, and its
    /// own rounding.
    inverse: u32,
    /// 2^63·(1 − y·inverse/2^31): up to 2^36, and off by up to 2.
    missing: i64,
}

/// The product over 2^32, up to 2 below the truth.
fn times(a: u64, b: u32) -> u64 {
    let part = |a: u32| u64::from(a) * u64::from(b);
    part((a >> 32) as u32) + (part(a as u32) >> 32)
}

impl Divisor {
    pub(crate) fn new(den: Leading64) -> Self {
        const ONE: u64 = 1 << 63;
        let upper = (den.magnitude >> 32) as u32;
        let first = (u32::MAX / ((upper >> 16) + 1)) << 15;
        let missing = ONE - u64::from(upper) * u64::from(first);
        let inverse = first + ((u64::from(first) * (missing >> 32)) >> 31) as u32;
        let missing = ONE.wrapping_sub(times(den.magnitude, inverse)) as i64;
        Self { den, inverse, missing }
    }
}

/// A scalar that may be a short multiple: `f32`.
pub trait ShortFloat: Copy + Default {
    /// Whether any is.
    const MAY_BE_SHORT: bool = false;

    /// The coordinates over a power of two, and its exponent, if all are then integers with
    /// magnitudes of at most 29 bits.
    fn short<const K: usize>(all: &[[Self; 3]; K]) -> Option<([[i32; 3]; K], i32)> {
        let _ = all;
        None
    }

    /// num/den times 2^`exponent`, to the nearest. `None` if the middle of two floats is within
    /// 2^-`clear` of the computed value, relatively, or if the result is not a normal float. A
    /// computation with an error below 2^-`clear`, less 2^-50 for this one, therefore rounds to the
    /// same float. `clear` is from 26 to 48.
    fn rounded_quotient(num: Leading64, den: &Divisor, exponent: i32, clear: i32) -> Option<Self> {
        let _ = (num, den, exponent, clear);
        None
    }

    /// Zero, or less zero.
    fn zero(is_negative: bool) -> Self {
        let _ = is_negative;
        Self::default()
    }
}

impl ShortFloat for f64 {}

impl ShortFloat for f32 {
    const MAY_BE_SHORT: bool = true;

    fn short<const K: usize>(all: &[[f32; 3]; K]) -> Option<([[i32; 3]; K], i32)> {
        let largest = all.as_flattened().iter().fold(0, |most, x| most.max(x.to_bits() << 1 >> 1));
        let exponent = largest >> 23;
        // The scale and its inverse must be normal too.
        if !(29..=250).contains(&exponent) {
            return None;
        }
        let two_to = |biased: u32| f32::from_bits(biased << 23);
        let (scale, inverse) = (two_to(282 - exponent), two_to(exponent - 28));
        let (mut short, mut is_exact) = ([[0; 3]; K], true);
        for (to, &x) in short.as_flattened_mut().iter_mut().zip(all.as_flattened()) {
            *to = (x * scale) as i32;
            // Compared by the inverse, because a small number times the scale may be zero.
            is_exact &= *to as f32 * inverse == x;
        }
        is_exact.then_some((short, exponent as i32 - 155))
    }

    fn rounded_quotient(
        num: Leading64,
        divisor: &Divisor,
        exponent: i32,
        clear: i32,
    ) -> Option<f32> {
        // 2^63·num/den, off by less than 2^-50 of itself: the square of the missing part is up to
        // 2^-54, and rounding down loses less than 2^-53.
        let first = times(num.magnitude, divisor.inverse);
        let more = ((first >> 32) as i64 * (divisor.missing >> 8)) >> 23;
        let q = first.checked_add_signed(more)?;
        // The top bit is this one or the next.
        let (q, zeros) = if q >> 63 == 0 { (q << 1, 1) } else { (q, 0) };
        // 24 bits stay. q is below 2^64.
        let (kept, rest) = ((q >> 40) as u32, q & ((1 << 40) - 1));
        if (rest.abs_diff(1 << 39) >> 16) as u32 <= 1 << (48 - clear) {
            return None;
        }
        let den = divisor.den;
        let biased = num.exponent - den.exponent - zeros + exponent + 127;
        if !(1..=253).contains(&biased) {
            return None;
        }
        // The leading bit adds one to the exponent; so does a carry.
        let bits = ((biased as u32 - 1) << 23) + kept + u32::from(rest >> 39 != 0);
        let is_negative = num.is_negative != den.is_negative;
        Some(f32::from_bits(bits | u32::from(is_negative) << 31))
    }

    fn zero(is_negative: bool) -> f32 {
        if is_negative { -0.0 } else { 0.0 }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::random::Random;

    /// Against quotients of `f64`, which holds these numbers and rounds once more.
    #[test]
    fn quotients_are_the_nearest() {
        let mut random = Random(3);
        let mut given = 0;
        for case in 0..200_000 {
            let mut number = |bits: u32| (random.bits() as i64 >> (63 - bits)) as i128;
            let bits = 1 + case % 53;
            let (num, den) = (number(bits), number(53 - bits / 2));
            let (num, den) = if case % 9 == 0 { (num << 40, (1 << 52) - 1) } else { (num, den) };
            let (Some(n), Some(d)) = (Leading64::new(num), Leading64::new(den)) else { continue };
            let expected = (num as f64 / den as f64) as f32;
            if let Some(q) = f32::rounded_quotient(n, &Divisor::new(d), 0, 46) {
                assert_eq!(q.to_bits(), expected.to_bits(), "{num} / {den}");
                given += 1;
            }
        }
        assert!(given > 190_000, "{given}");
        let of = |num, den, e| {
            f32::rounded_quotient(Leading64::new(num)?, &Divisor::new(Leading64::new(den)?), e, 46)
        };
        assert_eq!(of(3, 2, 0), Some(1.5));
        assert_eq!(of(-3, 1 << 91, 90), Some(-1.5));
        // The middle of two floats, and no normal float: `None`.
        assert_eq!(of((1 << 24) + 1, 1, 0), None);
        assert_eq!((of(1, 1, 128), of(1, 1, -127), of(0, 1, 0)), (None, None, None));
    }

    #[test]
    fn only_whole_multiples_are_short() {
        let short = |x: [f32; 3]| f32::short(&[x]);
        assert_eq!(short([1.0, -0.5, 0.0]), Some(([[1 << 28, -1 << 27, 0]], -28)));
        let least = f32::from_bits((127 - 28) << 23);
        assert!(short([1.0, 0.0, least]).is_some() && short([1.0, 0.0, least / 2.0]).is_none());
        assert!(short([1.0, 0.0, f32::from_bits(1)]).is_none());
        assert!(short([3e30, 0.0, f32::from_bits(1)]).is_none());
        assert!(short([0.0; 3]).is_none());
    }
}
