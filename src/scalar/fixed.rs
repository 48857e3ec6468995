//! Every signed type of the `fixed` crate, at full range.
//!
//! A fixed-point number is an integer with a name for its unit. A verdict does
//! not depend on the unit, so all of it is decided on the raw bits.

use core::num::Wrapping;

use fixed::types::extra::{LeEqU16, LeEqU32, LeEqU64, LeEqU8};
use fixed::{FixedI16, FixedI32, FixedI64, FixedI8};

use super::coarse::Coarse;
use super::integer::{Int16, Int32, Int64, Int8};
use super::ladder::{exactly, integers_then_exact, Predicate};
use super::numbers::{convert, Holds, Placed};
use super::sum::{Parts, Sum};
use super::{sealed, Scalar};

macro_rules! scalar {
    ($fixed:ident, $bound:ident, $limbs:literal, $quick:ty, $system:ty, $last:expr) => {
        impl<Frac: $bound> sealed::Sealed for $fixed<Frac> {}

        impl<Frac: $bound + Send + Sync + 'static> Scalar for $fixed<Frac> {
            const ZERO: Self = Self::ZERO;

            const ONE: Parts =
                Parts { negative: false, magnitude: 1, shift: Self::FRAC_NBITS as u16 };
            type Quick = $quick;
            // Four products of the raw bits, and room for their number.
            type Sum = Sum<$limbs>;

            #[inline(always)]
            fn is_finite(self) -> bool {
                true
            }
            fn parts(self) -> Parts {
                let bits = i64::from(self.to_bits());
                Parts { negative: bits < 0, magnitude: bits.unsigned_abs(), shift: 0 }
            }
            #[inline(always)]
            fn decide<P: Predicate<Self>>(p: &P) -> bool {
                match p.attempt::<$system>() {
                    Some(answer) => answer,
                    None => $last(p),
                }
            }
            #[inline(always)]
            fn plain_add(self, other: Self) -> Self {
                self.wrapping_add(other)
            }
            #[inline(always)]
            fn plain_sub(self, other: Self) -> Self {
                self.wrapping_sub(other)
            }
            #[inline(always)]
            fn plain_mul(self, other: Self) -> Self {
                self.wrapping_mul(other)
            }
            #[inline(always)]
            fn plain_abs(self) -> Self {
                self.wrapping_abs()
            }
            #[inline(always)]
            fn plain_half(self) -> Self {
                self >> 1_u32
            }
        }
    };
}
scalar!(FixedI8, LeEqU8, 1, Int8, Int8, exactly);
scalar!(FixedI16, LeEqU16, 2, Int16, Int16, exactly);
scalar!(FixedI32, LeEqU32, 3, Coarse, Int32, integers_then_exact::<_, Int64, _>);
scalar!(FixedI64, LeEqU64, 5, Coarse, Int64, exactly);

/// Types whose every value fits a system's length as it is.
macro_rules! always_held {
    ($fixed:ident, $bound:ident, $system:ty, $length:ty) => {
        impl<Frac: $bound> Holds<$fixed<Frac>> for $system {
            #[inline(always)]
            fn place<const P: usize, const E: usize>(
                points: &[[$fixed<Frac>; 3]; P],
                extents: &[[$fixed<Frac>; 3]; E],
            ) -> Placed<Wrapping<$length>, P, E> {
                let raw = |_, x: $fixed<Frac>| Wrapping(x.to_bits().into());
                Placed {
                    points: convert(points, Wrapping(0), raw),
                    extents: convert(extents, Wrapping(0), raw),
                    fit: true,
                }
            }
        }
    };
}
always_held!(FixedI8, LeEqU8, Int8, i32);
always_held!(FixedI16, LeEqU16, Int16, i32);
always_held!(FixedI32, LeEqU32, Int64, i64);

/// Types whose values may be too large for their first system.
macro_rules! held_if_small {
    ($fixed:ident, $bound:ident: $system:ty, $length:ty, $place:ident, $coarse:ident) => {
        impl<Frac: $bound> Holds<$fixed<Frac>> for $system {
            #[inline(always)]
            fn place<const P: usize, const E: usize>(
                points: &[[$fixed<Frac>; 3]; P],
                extents: &[[$fixed<Frac>; 3]; E],
            ) -> Placed<Wrapping<$length>, P, E> {
                <$system>::$place(
                    &convert(points, 0, |_, x| x.to_bits()),
                    &convert(extents, 0, |_, x| x.to_bits()),
                )
            }
        }

        impl<Frac: $bound> Holds<$fixed<Frac>> for Coarse {
            #[inline(always)]
            fn place<const P: usize, const E: usize>(
                points: &[[$fixed<Frac>; 3]; P],
                extents: &[[$fixed<Frac>; 3]; E],
            ) -> Placed<Wrapping<i32>, P, E> {
                Coarse::$coarse(
                    &convert(points, 0, |_, x| x.to_bits()),
                    &convert(extents, 0, |_, x| x.to_bits()),
                )
            }
        }
    };
}
held_if_small!(FixedI32, LeEqU32: Int32, i32, place_i32, coarse_i32);
held_if_small!(FixedI64, LeEqU64: Int64, i64, place_i64, coarse_i64);
