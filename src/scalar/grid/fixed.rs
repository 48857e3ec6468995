//! The grids of fixed point.

use fixed::types::extra::{LeEqU8, LeEqU16, LeEqU32, LeEqU64};
use fixed::{FixedI8, FixedI16, FixedI32, FixedI64};

use super::Gridded;
use crate::arithmetic::exp2;
use crate::scalar::in_double::InDouble;

/// The grid of a fixed-point type, in raw bits.
#[derive(Clone, Copy, Debug)]
pub struct FixedSteps<W> {
    origin: W,
    /// The binary logarithm of the step.
    shift: u32,
}

// $w is a signed word for sums of raw bits, $u the same without a sign, for differences.
macro_rules! fixed_point {
    ($($fixed:ident: $bound:ident, $raw:ty, $w:ty, $u:ty;)*) => {$(
        impl<Frac: $bound> Gridded for $fixed<Frac> {
            type SeptumSteps = FixedSteps<$w>;

            fn steps(min: Self, max: Self) -> Self::SeptumSteps {
                let origin = <$w>::from(min.to_bits());
                let length = <$w>::from(max.to_bits()).wrapping_sub(origin) as $u;
                // The least shift with length ≤ 65,535·2^shift.
                let mut shift = (<$u>::BITS - 16).saturating_sub(length.leading_zeros());
                if length >> shift == 0xffff && (length >> shift) << shift != length {
                    shift += 1;
                }
                FixedSteps { origin, shift }
            }

            fn exponent(steps: &Self::SeptumSteps) -> i32 {
                steps.shift as i32
            }

            #[inline]
            fn point_below(self, steps: &Self::SeptumSteps) -> u16 {
                let x = <$w>::from(self.to_bits());
                if x < steps.origin {
                    return 0;
                }
                let length = x.wrapping_sub(steps.origin) as $u;
                u16::try_from(length >> steps.shift).unwrap_or(u16::MAX)
            }

            #[inline]
            fn point_above(self, steps: &Self::SeptumSteps) -> u16 {
                let x = <$w>::from(self.to_bits());
                if x < steps.origin {
                    return 0;
                }
                let length = x.wrapping_sub(steps.origin) as $u;
                let q = length >> steps.shift;
                let is_between = q << steps.shift != length;
                u16::try_from(q).map_or(u16::MAX, |q| q.saturating_add(is_between.into()))
            }

            #[inline]
            fn point(steps: &Self::SeptumSteps, q: u16) -> Self {
                let q = <$u>::from(q);
                if q > <$u>::MAX >> steps.shift {
                    return Self::MAX;
                }
                let at = steps.origin.saturating_add_unsigned(q << steps.shift);
                Self::from_bits(<$raw>::try_from(at).unwrap_or(<$raw>::MAX))
            }

            #[inline]
            fn reach(self, h: Self) -> [Self; 2] {
                let (a, b) = (self.saturating_sub(h), self.saturating_add(h));
                if a < b { [a, b] } else { [b, a] }
            }

            #[inline]
            fn origin(steps: &Self::SeptumSteps) -> Self {
                Self::from_bits(steps.origin as $raw)
            }

            #[inline]
            fn steps_per_unit(steps: &Self::SeptumSteps) -> f64 {
                exp2(-(steps.shift as i32))
            }

            #[inline]
            fn farthest(self) -> f64 {
                self.farthest_number().map_or(f64::INFINITY, |t| {
                    // Allows for the rounding of the conversion to `f64`.
                    let t = t.in_double();
                    t + t.abs() * (2.0 * f64::EPSILON)
                })
            }

            #[inline]
            fn farthest_number(self) -> Option<Self> {
                // The greatest number may stand for a t beyond the range.
                self.checked_add(Self::DELTA)
            }
        }
    )*};
}
fixed_point! {
    FixedI8: LeEqU8, i8, i32, u32;
    FixedI16: LeEqU16, i16, i32, u32;
    FixedI32: LeEqU32, i32, i32, u32;
    FixedI64: LeEqU64, i64, i64, u64;
}
