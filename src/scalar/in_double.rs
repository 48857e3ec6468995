//! Coordinates in `f64`, and back.

use crate::arithmetic::whole;
#[cfg(feature = "fixed")]
use crate::arithmetic::{InRaw, REGISTERS_ARE_WIDE, Word, cut, exp2, exponent, raised};

/// Conversions between a scalar and `f64`: grids, contacts and times compute in it.
pub(crate) trait InDouble: Copy {
    /// Whether `f64` can represent every number of the type.
    const IS_IN_DOUBLE: bool;

    /// The unit of [`units`](Self::units): the last place of fixed point, and one of floats.
    const UNIT: f64;

    /// The number in units, to the nearest.
    fn units(self) -> f64;

    /// self − other in units, to the nearest.
    fn units_beyond(self, other: Self) -> f64;

    /// The number, to the nearest.
    #[inline]
    fn in_double(self) -> f64 {
        self.units() * Self::UNIT
    }

    /// self − other, to the nearest.
    #[inline]
    fn beyond_in_double(self, other: Self) -> f64 {
        self.units_beyond(other) * Self::UNIT
    }

    /// self + offset, to the nearest or next to it; clamped in fixed point.
    fn plus_double(self, offset: f64) -> Self;

    /// ±m·2^exponent units of the type's least number, rounded away from zero, or to the nearest
    /// with halves away from zero. m is at most 2^65. Out of range, returns infinity or the end of
    /// the range, and `false`.
    fn of_units(m: u128, exponent: i32, is_up: bool, is_negative: bool) -> (Self, bool);

    /// ±size, likewise, for a type of up to 32 bits. The size is not below zero, and half way between
    /// two numbers of a float type it is rounded to either.
    fn of_double(size: f64, is_up: bool, is_negative: bool) -> (Self, bool);
}

macro_rules! float {
    ($float:ident, $bits:ident) => {
        impl InDouble for $float {
            const IS_IN_DOUBLE: bool = true;
            const UNIT: f64 = 1.0;

            #[inline(always)]
            fn units(self) -> f64 {
                self.into()
            }
            #[inline(always)]
            fn units_beyond(self, other: Self) -> f64 {
                f64::from(self) - f64::from(other)
            }
            fn plus_double(self, offset: f64) -> Self {
                (f64::from(self) + offset) as $float
            }
            fn of_units(m: u128, exponent: i32, is_up: bool, is_negative: bool) -> (Self, bool) {
                const DIGITS: i32 = $float::MANTISSA_DIGITS as i32;
                let bits = 128 - m.leading_zeros() as i32;
                let places = (bits + exponent - DIGITS).max(0);
                let size = if places > $float::MAX_EXP - $float::MIN_EXP {
                    $float::INFINITY
                } else {
                    // At most 2^DIGITS; the carry into the exponent is correct.
                    let digits = whole(m, exponent - places, is_up) as $bits;
                    $float::from_bits(((places as $bits) << (DIGITS - 1)) + digits)
                };
                (if is_negative { 0.0 - size } else { size }, size < $float::INFINITY)
            }
            #[inline]
            fn of_double(size: f64, is_up: bool, is_negative: bool) -> (Self, bool) {
                let near = size as $float;
                // In bits: a processor does not foresee signs.
                let bits = near.to_bits() + $bits::from(is_up && f64::from(near) < size);
                let sign = $bits::from(is_negative) << ($bits::BITS - 1);
                // Zero has no sign.
                let signed = $float::from_bits(bits ^ sign) + 0.0;
                (signed, $float::from_bits(bits) < $float::INFINITY)
            }
        }
    };
}
float!(f32, u32);
float!(f64, u64);

/// x·2^n, for n from −64 to 64: an addition to the exponent where a product of floats is a function.
#[cfg(feature = "fixed")]
#[inline]
fn times_two_to(x: f64, n: i32) -> f64 {
    // Neither zero nor near an end.
    if !REGISTERS_ARE_WIDE && (65..2047 - 64).contains(&exponent(x)) {
        return raised(x, n);
    }
    x * exp2(n)
}

/// x·2^n, for n from −64 to 64, where an operation of floats is a function, by one.
#[cfg(feature = "fixed")]
#[inline(never)]
fn of_whole(x: i64, n: i32) -> f64 {
    if x == 0 { 0.0 } else { raised(x as f64, n) }
}

/// x·2^`places` plus a half of its sign, rounded twice: to a float, and toward zero. In words, where a sum of
/// floats is a function; `None` where they do not suffice.
///
/// The first rounding changes the second only below a half: the float before a half becomes one. From a half
/// on, the sum has no place that the number lacks, or it is one half at most beyond a power of two.
#[cfg(feature = "fixed")]
#[inline]
fn nearest_in_words(x: f64, places: i32) -> Option<i32> {
    // Twice the number below 2^30, and no number from a quarter to a half.
    let power = exponent(x) + places - 1023;
    if power == -2 || power >= 29 {
        return None;
    }
    let size = (cut(x.abs(), 1022 - places) + 1) >> 1;
    Some(if x < 0.0 { -size } else { size })
}

/// In raw bits.
#[cfg(feature = "fixed")]
impl<S: InRaw> InDouble for S {
    const IS_IN_DOUBLE: bool = S::Raw::BITS <= 32;
    const UNIT: f64 = exp2(-S::FRACTION_BITS);

    #[inline(always)]
    fn units(self) -> f64 {
        let raw: i64 = self.raw().into();
        raw as f64
    }
    #[inline(always)]
    fn units_beyond(self, other: Self) -> f64 {
        let [a, b]: [i64; 2] = [self.raw().into(), other.raw().into()];
        match a.checked_sub(b) {
            Some(d) => d as f64,
            None => (i128::from(a) - i128::from(b)) as f64,
        }
    }
    #[inline]
    fn in_double(self) -> f64 {
        if !REGISTERS_ARE_WIDE {
            return of_whole(self.raw().into(), -S::FRACTION_BITS);
        }
        times_two_to(self.units(), -S::FRACTION_BITS)
    }
    #[inline]
    fn beyond_in_double(self, other: Self) -> f64 {
        if !REGISTERS_ARE_WIDE && S::Raw::BITS <= 32 {
            let [a, b]: [i64; 2] = [self.raw().into(), other.raw().into()];
            return of_whole(a - b, -S::FRACTION_BITS);
        }
        times_two_to(self.units_beyond(other), -S::FRACTION_BITS)
    }
    fn plus_double(self, offset: f64) -> Self {
        let raw: i64 = self.raw().into();
        if !REGISTERS_ARE_WIDE && S::Raw::BITS <= 32 {
            if let Some(nearest) = nearest_in_words(offset, S::FRACTION_BITS) {
                return Self::clamped(raw + i64::from(nearest));
            }
        }
        let units = times_two_to(offset, S::FRACTION_BITS);
        let nearest = units + if units < 0.0 { -0.5 } else { 0.5 };
        if S::Raw::BITS <= 32 {
            return Self::clamped(raw.saturating_add(nearest as i64));
        }
        let sum = i128::from(raw).saturating_add(nearest as i128);
        Self::clamped(sum.clamp(i64::MIN.into(), i64::MAX.into()) as i64)
    }
    fn of_units(m: u128, exponent: i32, is_up: bool, is_negative: bool) -> (Self, bool) {
        let size = i128::try_from(whole(m, exponent, is_up)).unwrap_or(i128::MAX);
        let held = Self::held(if is_negative { -size } else { size });
        let end = if is_negative { i64::MIN } else { i64::MAX };
        (held.unwrap_or_else(|| Self::clamped(end)), held.is_some())
    }
    #[inline]
    fn of_double(size: f64, is_up: bool, is_negative: bool) -> (Self, bool) {
        let units = times_two_to(size, S::FRACTION_BITS);
        // In the range of `i64`, or else its end, which no type of up to 32 bits holds.
        let whole = if is_up { units } else { units + 0.5 } as i64;
        let whole = whole.saturating_add(i64::from(is_up && (whole as f64) < units));
        let size = if is_negative { -whole } else { whole };
        let held = Self::held(size.into());
        (held.unwrap_or_else(|| Self::clamped(size)), held.is_some())
    }
}

#[cfg(test)]
mod tests {
    use super::InDouble;
    #[cfg(feature = "fixed")]
    use super::nearest_in_words;
    use crate::arithmetic::exp2;
    #[cfg(feature = "fixed")]
    use crate::random::Random;

    /// Against the sum in floats, at halves and powers of two and beside them, and at any number.
    #[cfg(feature = "fixed")]
    #[test]
    fn words_round_as_floats_do() {
        let mut random = Random(0x4a1f);
        let mut in_words = 0;
        for n in 0..100_000_u64 {
            let bits = random.bits();
            let size = match n % 4 {
                0 => (bits >> (34 + n % 29)) as f64 * 0.5,
                1 => exp2((n % 64) as i32 - 32),
                _ => f64::from_bits((1023 - 8 + n % 39) << 52 | bits >> 12),
            };
            let near = size.to_bits().wrapping_add(bits % 5).wrapping_sub(2) & i64::MAX as u64;
            let x = f64::from_bits(near | bits >> 63 << 63);
            for places in [0, 4, 16, 32] {
                let units = x * exp2(places);
                let expected = (units + if units < 0.0 { -0.5 } else { 0.5 }) as i64;
                if let Some(found) = nearest_in_words(x, places) {
                    assert_eq!(i64::from(found), expected, "{x:e} {places}");
                    in_words += 1;
                }
            }
        }
        assert!(in_words > 200_000, "{in_words}");
    }

    /// Converts numbers of `f32` to units of the least number, and back.
    #[test]
    fn units_become_the_next_number() {
        for bits in [1, 2, 0x7f_ffff, 0x80_0000, 0x80_0001, 0x3f80_0000, 0x3f80_0001, 0x7f7f_ffff] {
            let x = f32::from_bits(bits);
            let parts = <f32 as crate::arithmetic::Float>::parts(x);
            let (m, e) = (u128::from(parts.magnitude), i32::from(parts.shift));
            assert_eq!(f32::of_units(m, e, true, false), (x, true));
            assert_eq!(f32::of_units(m << 30, e - 30, false, true), (-x, true));
            // A little more: the next number if rounded up, the same if rounded to the nearest.
            let (more, next) = ((m << 30) + 1, f32::from_bits(bits + 1));
            assert_eq!(f32::of_units(more, e - 30, true, false), (next, next.is_finite()));
            assert_eq!(f32::of_units(more, e - 30, false, false), (x, true));
        }
        assert_eq!(f32::of_units(1, 500, true, true), (f32::NEG_INFINITY, false));
        assert_eq!(f64::of_units(1, -500, true, false), (f64::from_bits(1), true));
        assert_eq!(f64::of_units(1, -500, false, false), (0.0, true));
    }
}
