//! `f32` and `f64` as numbers of a kernel, and scalars whose coordinates a float holds.

use core::ops::{Div, Mul};

use super::number::{Number, greatest};
use super::parts::{Bits, Parts, exp2, multiple, scaled};
use super::platform::REGISTERS_ARE_WIDE;
use super::quad::OfFour;
use super::soft::Soft;

/// A binary floating-point type of IEEE 754.
pub trait Float:
    Number + OfFour + Mul<Output = Self> + Div<Output = Self> + From<u16> + Into<f64> + 'static
{
    /// One half.
    const HALF: Self;
    /// u: half the distance from 1 to the next number.
    const ROUNDOFF: Self;
    /// If the greatest of three lengths is in this range, their products, and products with axes
    /// between one and four long, do not overflow. Underflow loses less than the error bounds have
    /// to spare.
    const RANGE: (Self, Self);
    /// P times this number is 1.5·2^k units, with k the digits after the first and a unit of P/16
    /// for `f32` and P/2^14 for `f64`. Adding it and subtracting it again leaves multiples of the
    /// unit unchanged. It also leaves numbers unchanged that are so great that they are multiples
    /// of half a unit, but no others.
    ///
    /// Lengths below 2·P, made of such numbers and halved at most once, have sums of products
    /// without rounding. The greatest sum is of six products of three lengths, two of them not
    /// halved. It is below 48·P³ in sixteenths of a cubed unit, which is 2^21.6 for `f32` and
    /// 2^51.6 for `f64`.
    const GRID_SHIFTER: Self;

    /// The greatest power of two that is not above this number, which is normal and above zero.
    fn power_of_two_below(self) -> Self;

    /// Sign, magnitude and exponent.
    fn parts(self) -> Parts;

    /// The exponent, as its bits have it.
    fn exponent(self) -> i32;

    /// In units of two to a power, which is as the bits of an exponent have it, rounded toward zero. The number
    /// is below 2^31 units.
    fn in_units(self, unit: i32) -> i32;

    /// m·2^e to the nearest; tiny results and `f32` are rounded twice.
    fn scaled(magnitude: u64, exponent: i32) -> Self;
}

macro_rules! float {
    ($float:ident: $bits:literal, $digits:literal, $range:expr, $shifter:expr) => {
        impl Number for $float {
            const ZERO: Self = 0.0;
            /// The least normal number, which exceeds the loss of a few underflows.
            const UNDERFLOW: Self = $float::MIN_POSITIVE;

            #[inline(always)]
            fn magnitude(self) -> Self {
                self.abs()
            }
            #[inline(always)]
            fn half(self) -> Self {
                self * Self::HALF
            }
            #[inline(always)]
            fn error(self, roundoffs: u16) -> Self {
                Self::from(roundoffs) * Self::ROUNDOFF * self
            }
            // Not `self <= -error` alone, which holds for two infinities. Their sum is NaN, and the
            // sign of any other sum is exact. Where a sum is slow, a test of the bits replaces it.
            #[inline(always)]
            fn is_not_above(self, error: Self) -> bool {
                if REGISTERS_ARE_WIDE {
                    self + error <= 0.0
                } else {
                    let is_finite = error.to_bits() << 1 < Self::INFINITY.to_bits() << 1;
                    (self <= -error) & is_finite
                }
            }
            // A NaN is in no range.
            #[inline(always)]
            fn in_range(self) -> bool {
                (self > Self::RANGE.0) & (self < Self::RANGE.1)
            }
            #[inline(always)]
            fn portion(self, den: Self, [error, other]: [Self; 2]) -> [Soft; 2] {
                enclosing(self, den, [error, other])
            }
        }

        impl Float for $float {
            const HALF: Self = 0.5;
            const ROUNDOFF: Self = Self::EPSILON / 2.0;
            const RANGE: (Self, Self) = $range;
            const GRID_SHIFTER: Self = $shifter as Self;

            #[inline(always)]
            fn power_of_two_below(self) -> Self {
                Self::from_bits(self.to_bits() & Self::INFINITY.to_bits())
            }

            fn parts(self) -> Parts {
                let bits = self.to_bits();
                let exponent = (bits & Self::INFINITY.to_bits()) >> $digits;
                let hidden = if exponent == 0 { 0 } else { 1 << $digits };
                Parts {
                    negative: self.is_sign_negative(),
                    magnitude: (hidden | bits & ((1 << $digits) - 1)).into(),
                    shift: exponent.saturating_sub(1) as u16,
                }
            }

            #[inline(always)]
            fn exponent(self) -> i32 {
                (self.to_bits() << 1 >> ($digits + 1)) as i32
            }

            #[inline(always)]
            fn in_units(self, unit: i32) -> i32 {
                // The leading one and the 30 bits below it.
                let digits = (self.to_bits().rotate_right($digits + 2) >> ($bits - 32)) as i32;
                const LACK: u32 = 30_u32.saturating_sub($digits);
                let size = 1 << 30 | digits & ((1 << 30) - (1 << LACK));
                let size = size.checked_shr((unit + 30 - self.exponent()) as u32).unwrap_or(0);
                if self.is_sign_negative() { -size } else { size }
            }

            fn scaled(magnitude: u64, exponent: i32) -> Self {
                scaled(magnitude, exponent) as Self
            }
        }
    };
}

// An underflow loses at most 2^-150 in each operation. Beyond the roundings, the bounds have 1·u·r²
// (areas) and 4·u·r³ (volumes) to spare (query::triangle_aabb::error_bound), against about 10 and
// 12·r + 6 underflows. That suffices from r = 2^-40 on. Above, r³·24 stays below 2^128 up to r = 2^41.
float!(f32: 32, 23, (exp2(-32) as f32, exp2(40) as f32), 3 << 22 >> 4);
// Likewise 2^-53·r² and 4·2^-53·r³ against 2^-1075, and r³·24 below 2^1024. A nonzero number that was
// an f32 is always in the range.
float!(f64: 64, 52, (exp2(-320), exp2(320)), 3_u64 << 51 >> 14);

/// The bits of all coordinates.
pub(super) fn bits<F: Float>(all: &[[F; 3]]) -> Bits {
    all.as_flattened().iter().fold(Bits::NONE, |bits, x| bits.with(x.parts()))
}

/// The quotient of two integers, to the nearest float or the one next to it. Each is given as its
/// sign and the limbs of its magnitude, least first. The divisor is not zero.
pub(crate) fn quotient<F: Float, const L: usize>(
    (is_negative, num): (bool, [u64; L]),
    (is_other_negative, den): (bool, [u64; L]),
) -> F {
    let soft = |limbs: [u64; L]| Soft::of_limbs(&limbs).unwrap_or(Soft::ZERO);
    let (magnitude, exponent) = soft(num).quotient(soft(den));
    let x = F::scaled(magnitude, exponent);
    if is_negative != is_other_negative { -x } else { x }
}

/// Two numbers that enclose num/den, given the errors of num and den.
///
/// Each bound carries the roundings of a difference, a sum and a quotient: 3u of itself, to first
/// order. 8u are allowed, so 5 remain for the roundings of the bounds and for second orders.
#[inline(always)]
fn enclosing<F: Float>(num: F, den: F, [num_error, den_error]: [F; 2]) -> [Soft; 2] {
    let (zero, one, roundings) = (F::ZERO, F::from(1), F::from(8) * F::ROUNDOFF);
    let lower = (num - num_error) / (den + den_error) * (one - roundings);
    let least = den - den_error;
    let upper = (num + num_error) / least * (one + roundings);
    let soft = |x: F| Soft::of_normal(x.into());
    let lower = if lower > F::UNDERFLOW { soft(lower) } else { Soft::ZERO };
    // A NaN counts as outside.
    let is_known = (least > zero) & (upper < one);
    let upper = if upper < F::UNDERFLOW { F::UNDERFLOW } else { upper };
    [lower, if is_known { soft(upper) } else { Soft::ONE }]
}

/// The bits of the greatest number that is [`cut_to_words`].
const WORD: i32 = 29;

/// Numbers in units of two to a power, rounded toward zero, and that power, as the bits of an exponent have it. The
/// greatest takes 29 bits. `None` if all are tiny.
#[inline(always)]
pub(crate) fn cut_to_words<S: FirstFloat, const K: usize>(
    all: &[[S; 3]; K],
) -> Option<([[i32; 3]; K], i32)> {
    let exponents = all.as_flattened().iter().map(|x| x.first().exponent());
    let unit = exponents.fold(0, greatest) + 1 - WORD;
    let mut words = [[0; 3]; K];
    for (to, x) in words.as_flattened_mut().iter_mut().zip(all.as_flattened()) {
        *to = x.first().in_units(unit);
    }
    (unit > 0).then_some((words, unit))
}

/// How many bits of a number in such units are below one.
#[inline(always)]
pub(crate) fn fraction_bits<S: FirstFloat>(unit: i32) -> i32 {
    S::SeptumFirst::from(1).exponent() - unit
}

/// Whether a number is a multiple of 2^`unit`, and below 2^52 of them.
#[inline(always)]
pub(crate) fn is_whole<S: FirstFloat>(x: S, unit: i32) -> bool {
    multiple(x.first().into(), unit).is_some()
}

/// A scalar whose coordinates are numbers of the float `F`, up to a limit, or multiples of
/// such by one power of two.
pub(crate) trait InFloat<F>: Copy {
    /// Below this magnitude nothing is rounded; `None` if nothing ever is.
    const LIMIT: Option<F>;

    /// The last place of a fixed-point number, as a number; zero of a float.
    const PLACE: F;

    /// Whether [`Offset`](super::Offset) is asked before this float, and not only beyond the limit,
    /// where there are vectors.
    const OFFSETS_FIRST: bool;

    /// The coordinate, to the nearest.
    fn in_float(self) -> F;
}

/// The coordinates, to the nearest.
#[inline(always)]
pub(crate) fn three_in_float<S: InFloat<F>, F>([x, y, z]: [S; 3]) -> [F; 3] {
    [x.in_float(), y.in_float(), z.in_float()]
}

/// The float that is asked first, four at once, in a query that has a kernel for that.
pub(crate) trait FirstFloat:
    InFloat<<Self as FirstFloat>::SeptumFirst> + InFloat<<Self as FirstFloat>::SeptumSecond>
{
    /// That float.
    type SeptumFirst: Float;

    /// The float that many at once ask where the first does not hold a coordinate; the same float if
    /// no longer one would help.
    type SeptumSecond: Float;

    /// [`InFloat::LIMIT`].
    const FIRST_LIMIT: Option<Self::SeptumFirst> = <Self as InFloat<Self::SeptumFirst>>::LIMIT;

    /// [`InFloat::in_float`].
    #[inline(always)]
    fn first(self) -> Self::SeptumFirst {
        self.in_float()
    }
}

impl FirstFloat for f32 {
    type SeptumFirst = f32;
    type SeptumSecond = f32;
}

impl FirstFloat for f64 {
    type SeptumFirst = f64;
    type SeptumSecond = f64;
}

impl<S: Float + Into<F>, F: Float> InFloat<F> for S {
    // Four numbers of `f64` are faster where one vector holds them. With AVX-512 the compiler loads eight,
    // and turns them at twice the cost.
    const OFFSETS_FIRST: bool = size_of::<S>() == size_of::<f64>()
        && cfg!(any(not(target_feature = "avx"), target_feature = "avx512f"));
    const LIMIT: Option<F> = None;
    const PLACE: F = F::ZERO;

    #[inline(always)]
    fn in_float(self) -> F {
        self.into()
    }
}

/// x in multiples of 2^(`unit` − 1023), rounded toward zero, if it is below 2^31.
#[inline(never)]
pub(crate) fn cut(x: f64, unit: i32) -> i32 {
    x.in_units(unit)
}
