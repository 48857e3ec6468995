//! Numbers in parts: sign, magnitude and exponent, and the bits of a float.

use core::hint::black_box;

use super::limbs::word_product;
use super::platform::is_software;

/// A number as sign, integer magnitude and power of two, in units of the least number of its type.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Parts {
    /// Whether it is below zero.
    pub negative: bool,
    /// The magnitude before the shift.
    pub magnitude: u64,
    /// How far to shift the magnitude up.
    pub shift: u16,
}

impl Parts {
    /// Zero.
    pub(crate) const ZERO: Self = Self { negative: false, magnitude: 0, shift: 0 };

    /// The number one, in no unit, as a neutral factor.
    pub(crate) const UNIT: Self = Self { negative: false, magnitude: 1, shift: 0 };

    /// The number with its sign reversed.
    pub fn negated(self) -> Self {
        Self { negative: !self.negative, ..self }
    }

    /// The number in units of two to the power `low`. The unit divides it, and 63 bits hold it.
    #[inline]
    pub(crate) fn in_units(self, low: i32) -> i64 {
        // Up or down by less than 64, and no bit is lost.
        let up = i32::from(self.shift).wrapping_sub(low) as u32;
        let (whole, sign) = (self.magnitude.rotate_left(up) as i64, -i64::from(self.negative));
        (whole ^ sign) - sign
    }

    /// The number in such units, rounded toward zero, if 63 bits hold it.
    pub(crate) fn cut_to_units(self, low: i32) -> i64 {
        let up = i32::from(self.shift) - low;
        let whole = if up < 0 {
            self.magnitude.checked_shr(up.unsigned_abs()).unwrap_or(0)
        } else {
            self.magnitude << up
        };
        if self.negative { -(whole as i64) } else { whole as i64 }
    }

    /// The number in such units, if 127 bits hold it.
    #[inline]
    pub(crate) fn in_wide_units(self, low: i32) -> i128 {
        let up = i32::from(self.shift).wrapping_sub(low) as u32;
        let whole = u128::from(self.magnitude).rotate_left(up) as i128;
        // rustc 1.95 loses signs of a choice between two numbers, in loops compiled for AVX-512.
        let sign = -i128::from(self.negative);
        (whole ^ sign) - sign
    }
}

/// The exponents of the lowest and of the highest bit of some numbers, as powers of two in units
/// of the least number.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Bits {
    pub(crate) low: i32,
    pub(crate) high: i32,
}

impl Bits {
    /// The exponents of no number, or of zero.
    pub(crate) const NONE: Self = Self { low: i32::MAX, high: 0 };

    /// The exponents with one more number. No branch, because whether a number is zero is hard to
    /// predict.
    #[inline(always)]
    pub(crate) fn with(self, x: Parts) -> Self {
        let low = i32::from(x.shift) + x.magnitude.trailing_zeros() as i32;
        let high = i32::from(x.shift) + 64 - x.magnitude.leading_zeros() as i32;
        let is_zero = x.magnitude == 0;
        Self {
            low: self.low.min(if is_zero { i32::MAX } else { low }),
            high: self.high.max(if is_zero { 0 } else { high }),
        }
    }

    /// The number of bits that hold all, in units of the lowest.
    pub(crate) fn width(self) -> i32 {
        let width = self.high.saturating_sub(self.low);
        if width > 0 { width } else { 0 }
    }
}

/// m·2^e, to the nearest; tiny results are rounded twice.
pub(crate) fn scaled(magnitude: u64, exponent: i32) -> f64 {
    let mut x = magnitude as f64;
    let mut left = exponent.clamp(-2400, 2400);
    while left != 0 {
        let step = left.clamp(-1000, 1000);
        x *= exp2(step);
        left -= step;
    }
    x
}

/// 2^n, a normal number.
#[inline(always)]
pub(crate) const fn exp2(n: i32) -> f64 {
    f64::from_bits(((1023 + n) as u64) << 52)
}

/// x·2^n, if both are normal numbers.
#[inline(always)]
pub(crate) fn raised(x: f64, n: i32) -> f64 {
    f64::from_bits(x.to_bits().wrapping_add((n as u64) << (f64::MANTISSA_DIGITS - 1)))
}

/// x·y: where products of floats are functions, by one product of words if these hold both mantissas.
#[inline]
pub(crate) fn short_product(x: f64, y: f64) -> f64 {
    if is_software::<f64>() { product_in_words(x, y) } else { x * y }
}

#[inline(never)]
fn product_in_words(x: f64, y: f64) -> f64 {
    // The mantissa, and whether that is all.
    let word = |x: f64| {
        let bits = x.to_bits();
        ((bits >> 21) as u32 | 1 << 31, (bits as u32) << 11 == 0 && exponent(x) > 0)
    };
    let sign = (x.to_bits() ^ y.to_bits()) >> 63 << 63;
    // As an axis often is.
    if is_zero(y) && exponent(x) < 2047 {
        return f64::from_bits(sign);
    }
    let ((a, is_all), (b, are_all)) = (word(x), word(y));
    let product = word_product(a, b);
    let is_less = product >> 63 == 0;
    let (mantissa, up) = (product << u32::from(is_less), exponent(x) + exponent(y) - 1023);
    let power = up + i32::from(!is_less);
    if is_all && are_all && mantissa << 53 == 0 && (1..2047).contains(&power) {
        return f64::from_bits(sign | (power as u64) << 52 | mantissa << 1 >> 12);
    }
    x * y
}

/// A float in multiples of 2^`unit`, if it is one and below 2^52 of them.
pub(crate) fn multiple(x: f64, unit: i32) -> Option<i64> {
    let bits = x.to_bits();
    if is_zero(x) {
        return Some(0);
    }
    let mantissa = bits & ((1 << 52) - 1) | 1 << 52;
    let down =
        u32::try_from(unit + 1075 - exponent(x)).ok().filter(|down| (1..=52).contains(down))?;
    let size = mantissa >> down;
    let size = (size << down == mantissa).then_some(size as i64)?;
    Some(if bits >> 63 == 0 { size } else { -size })
}

/// Whether a float is zero, where a comparison is a function, of which the compiler makes one of bits too.
#[inline(always)]
pub(crate) fn is_zero(x: f64) -> bool {
    exponent(x) == 0 && black_box(x.to_bits()) << 1 == 0
}

/// The exponent of a float, as its bits have it.
#[inline(always)]
pub(crate) fn exponent(x: f64) -> i32 {
    (x.to_bits() >> (f64::MANTISSA_DIGITS - 1)) as i32 & 0x7ff
}
