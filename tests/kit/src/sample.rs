//! The properties of a scalar that tests need: its exact value and its neighbours. They come from
//! the bits, not from the crate under test.

use fixed::types::extra::{LeEqU8, LeEqU16, LeEqU32, LeEqU64};
use fixed::{FixedI8, FixedI16, FixedI32, FixedI64};
use septum::Scalar;

/// A scalar whose values can be decomposed and enumerated.
pub trait Sample: Scalar {
    /// The least finite value.
    const LEAST: Self;
    /// The greatest finite value.
    const GREATEST: Self;
    /// Integers of this many bits are exact in [`whole`](Self::whole).
    const WHOLE_BITS: u32;

    /// Whether the type is a float.
    const IS_FLOAT: bool;

    /// The name of the type.
    fn name() -> String;

    /// Mantissa and exponent: the value is exactly m·2^e.
    fn mantissa_exponent(self) -> (i64, i32);

    /// The value nearest to `x`, or the extreme if `x` lies beyond it.
    fn nearest(x: f64) -> Self;

    /// self + other, rounded in floats; fixed point wraps around.
    fn plus(self, other: Self) -> Self;

    /// self − other, rounded in floats; fixed point wraps around.
    fn minus(self, other: Self) -> Self;

    /// The value of `n` units; the unit is a fixed power of two for each type.
    fn whole(n: i64) -> Self;

    /// A number for each value, in order, adjacent values numbered adjacently.
    fn ordinal(self) -> i64;

    /// The value of that number, or the extreme if there is none.
    fn from_ordinal(n: i64) -> Self;

    /// The value `steps` places further up, stopping at the extremes.
    fn moved(self, steps: i64) -> Self {
        Self::from_ordinal(self.ordinal().saturating_add(steps))
    }

    /// An approximation of the value.
    fn approximate(self) -> f64 {
        let (mantissa, exponent) = self.mantissa_exponent();
        // As two factors, because 2^-1074 alone would underflow.
        let (half, rest) = (exponent / 2, exponent - exponent / 2);
        mantissa as f64 * 2_f64.powi(half) * 2_f64.powi(rest)
    }

    /// A value between the two, strictly unless they are equal or adjacent.
    fn between(self, other: Self) -> Self {
        let middle = Self::nearest(self.approximate() / 2.0 + other.approximate() / 2.0);
        let (low, high) = if self < other { (self, other) } else { (other, self) };
        if low < middle && middle < high {
            return middle;
        }
        let (low, high) = (i128::from(low.ordinal()), i128::from(high.ordinal()));
        Self::from_ordinal(((low + high) >> 1) as i64)
    }
}

macro_rules! float_sample {
    ($float:ident, $bits:ident, $signed:ident) => {
        impl Sample for $float {
            const LEAST: Self = $float::MIN;
            const GREATEST: Self = $float::MAX;
            const WHOLE_BITS: u32 = $float::MANTISSA_DIGITS;
            const IS_FLOAT: bool = true;

            fn name() -> String {
                stringify!($float).into()
            }
            fn mantissa_exponent(self) -> (i64, i32) {
                const FRACTION: u32 = $float::MANTISSA_DIGITS - 1;
                let bits = self.to_bits();
                let fraction = (bits & ((1 << FRACTION) - 1)) as i64;
                let biased = ((bits << 1) >> (FRACTION + 1)) as i32;
                let mantissa = if biased == 0 { fraction } else { fraction | 1 << FRACTION };
                let exponent = biased.max(1) - $float::MAX_EXP + 2 - $float::MANTISSA_DIGITS as i32;
                (if self.is_sign_negative() { -mantissa } else { mantissa }, exponent)
            }
            fn nearest(x: f64) -> Self {
                (x as $float).clamp(Self::LEAST, Self::GREATEST)
            }
            fn plus(self, other: Self) -> Self {
                self + other
            }
            fn minus(self, other: Self) -> Self {
                self - other
            }
            fn whole(n: i64) -> Self {
                // In sixty-fourths, so that some numbers have a fraction.
                n as $float / 64.0
            }
            fn ordinal(self) -> i64 {
                // Both zeros are number zero.
                let magnitude = (self.to_bits() << 1 >> 1) as i64;
                if self.is_sign_negative() { -magnitude } else { magnitude }
            }
            fn from_ordinal(n: i64) -> Self {
                let last = Self::GREATEST.to_bits() as i64;
                let n = n.clamp(-last, last);
                let magnitude = $float::from_bits(n.unsigned_abs() as $bits);
                if n < 0 { -magnitude } else { magnitude }
            }
        }
    };
}
float_sample!(f32, u32, i32);
float_sample!(f64, u64, i64);

macro_rules! fixed_sample {
    ($fixed:ident, $bound:ident, $raw:ident) => {
        impl<Frac: $bound + Send + Sync + 'static> Sample for $fixed<Frac> {
            const LEAST: Self = Self::MIN;
            const GREATEST: Self = Self::MAX;
            const WHOLE_BITS: u32 = $raw::BITS - 1;
            const IS_FLOAT: bool = false;

            fn name() -> String {
                format!("I{}F{}", Self::INT_NBITS, Self::FRAC_NBITS)
            }
            fn mantissa_exponent(self) -> (i64, i32) {
                (self.to_bits().into(), -(Self::FRAC_NBITS as i32))
            }
            fn nearest(x: f64) -> Self {
                Self::saturating_from_num(x)
            }
            fn plus(self, other: Self) -> Self {
                self.wrapping_add(other)
            }
            fn minus(self, other: Self) -> Self {
                self.wrapping_sub(other)
            }
            fn whole(n: i64) -> Self {
                Self::from_bits($raw::try_from(n).expect("more bits than the type has"))
            }
            fn ordinal(self) -> i64 {
                self.to_bits().into()
            }
            fn from_ordinal(n: i64) -> Self {
                Self::from_bits(n.clamp($raw::MIN.into(), $raw::MAX.into()) as $raw)
            }
        }
    };
}
fixed_sample!(FixedI8, LeEqU8, i8);
fixed_sample!(FixedI16, LeEqU16, i16);
fixed_sample!(FixedI32, LeEqU32, i32);
fixed_sample!(FixedI64, LeEqU64, i64);
