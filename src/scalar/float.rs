//! `f32` and `f64` as scalars.

use core::ops::Mul;

use super::bounded::Bounded;
use super::integer::REGISTERS_ARE_WIDE;
use super::ladder::{FEW_RUNGS, Predicate, exactly, first, rung, thorough, wide_integers};
use super::number::Number;
use super::padding::Padding;
use super::quotient::Leading;
use super::sum::{Parts, Sum};
use super::{Scalar, sealed};

/// A binary floating-point type of IEEE 754.
pub trait Float: Number + Mul<Output = Self> + From<u8> + From<u16> + 'static {
    /// One half.
    const HALF: Self;
    /// u: half the distance from 1 to the next number.
    const ROUNDOFF: Self;
    /// The least normal number: more than what a few underflows cost.
    const TINY: Self;
    /// Products of three lengths, the greatest of them in this range, and of those
    /// with axes between one and four long, neither overflow nor lose more to
    /// underflow than the bounds have to spare.
    const REACH: (Self, Self);

    /// m·2^e to the nearest, but for a second rounding where the result is tiny or
    /// an `f32`.
    fn scaled(magnitude: u64, exponent: i32) -> Self;
}

// f32: an underflow costs at most 2^-150 an operation. The bounds have 1 (areas)
// and 4 (volumes) times u·r² and u·r³ to spare (robust::bounds), against about 10
// and 12·r + 6 underflows: enough from r = 2^-40 on. Above, r³·24 stays below 2^128
// up to r = 2^41.
impl Float for f32 {
    const TINY: f32 = f32::MIN_POSITIVE;
    const HALF: f32 = 0.5;
    const ROUNDOFF: f32 = f32::EPSILON / 2.0;
    const REACH: (f32, f32) = (f32::from_bits((127 - 32) << 23), f32::from_bits((127 + 40) << 23));

    fn scaled(magnitude: u64, exponent: i32) -> f32 {
        f64::scaled(magnitude, exponent) as f32
    }
}

// f64: likewise 2^-53·r² and 4·2^-53·r³ against 2^-1075, and r³·24 below 2^1024. A
// nonzero number that was an f32 is always inside.
impl Float for f64 {
    const TINY: f64 = f64::MIN_POSITIVE;
    const HALF: f64 = 0.5;
    const ROUNDOFF: f64 = f64::EPSILON / 2.0;
    const REACH: (f64, f64) =
        (f64::from_bits((1023 - 320) << 52), f64::from_bits((1023 + 320) << 52));

    fn scaled(magnitude: u64, exponent: i32) -> f64 {
        let mut x = magnitude as f64;
        let mut left = exponent.clamp(-2400, 2400);
        while left != 0 {
            let step = left.clamp(-1000, 1000);
            x *= f64::from_bits(((1023 + step) as u64) << 52);
            left -= step;
        }
        x
    }
}

/// The quotient of two whole numbers, to the nearest or next to it.
pub(super) fn quotient<F: Float>(num: Leading, den: Leading) -> F {
    let (negative, magnitude, exponent) = num.quotient(den);
    let x = F::scaled(magnitude, exponent);
    if negative { -x } else { x }
}

impl sealed::Sealed for f32 {}
impl sealed::Sealed for f64 {}

macro_rules! plain {
    () => {
        const ZERO: Self = 0.0;

        #[inline(always)]
        fn is_finite(self) -> bool {
            self.is_finite()
        }
        fn quotient(num: &Self::Sum, den: &Self::Sum) -> Self {
            quotient(num.leading(), den.leading())
        }
        #[inline(always)]
        fn plain_add(self, other: Self) -> Self {
            self + other
        }
        #[inline(always)]
        fn plain_sub(self, other: Self) -> Self {
            self - other
        }
        #[inline(always)]
        fn plain_mul(self, other: Self) -> Self {
            self * other
        }
        #[inline(always)]
        fn plain_div(self, other: Self) -> Self {
            self / other
        }
        #[inline(always)]
        fn plain_one() -> Self {
            1.0
        }
        #[inline(always)]
        fn plain_turned_by(self, other: Self) -> Self {
            // The signs as bits: two instructions, where a choice takes three.
            let minus: Self = -0.0;
            Self::from_bits(self.to_bits() ^ (other.to_bits() & minus.to_bits()))
        }
        #[inline(always)]
        fn plain_abs(self) -> Self {
            self.abs()
        }
        #[inline(always)]
        fn plain_half(self) -> Self {
            self * 0.5
        }
    };
}

impl Scalar for f32 {
    plain!();

    const ONE: Parts = Parts { negative: false, magnitude: 1, shift: 149 };
    const PADDING: Option<Padding<f32>> = Some(Padding {
        ratio: 4.0 * f32::EPSILON,
        least: f32::MIN_POSITIVE,
        tame: (f32::from_bits((127 - 100) << 23), f32::from_bits((127 + 100) << 23)),
    });
    type Quick = Bounded<f32>;
    type Products = Bounded<f32>;
    // Four products of 2^-149 to 2^128: 1108 bits, and room for their number.
    type Sum = Sum<18>;

    fn parts(self) -> Parts {
        let bits = self.to_bits();
        let (exponent, fraction) = ((bits >> 23) & 0xff, bits & 0x7f_ffff);
        let hidden = if exponent == 0 { 0 } else { 1 << 23 };
        Parts {
            negative: bits >> 31 != 0,
            magnitude: (hidden | fraction) as u64,
            shift: exponent.saturating_sub(1) as u16,
        }
    }

    #[inline(always)]
    fn decide<P: Predicate<Self>>(p: &P) -> P::Answer {
        rung::<_, Bounded<f32>, _>(p, if FEW_RUNGS { exactly } else { doubled })
    }

    #[inline(always)]
    fn measure<P: Predicate<Self>>(p: &P) -> P::Answer {
        if DOUBLE_IS_CHEAP {
            return first::<_, Bounded<f64>, _>(p, doubled);
        }
        // Numbers come from f64; f32 can but say that there are none.
        rung::<_, Bounded<f32>, _>(p, doubled)
    }
}

/// Whether `f64` costs no more than `f32`. It changes no answer.
const DOUBLE_IS_CHEAP: bool = REGISTERS_ARE_WIDE;

/// The second rung of `f32`: the same code in `f64`.
#[cold]
#[inline(never)]
fn doubled<P: Predicate<f32>>(p: &P) -> P::Answer {
    rung::<_, Bounded<f64>, _>(p, wide_integers)
}

impl Scalar for f64 {
    plain!();

    const ONE: Parts = Parts { negative: false, magnitude: 1, shift: 1074 };
    const PADDING: Option<Padding<f64>> = Some(Padding {
        ratio: 4.0 * f64::EPSILON,
        least: f64::MIN_POSITIVE,
        tame: (f64::from_bits((1023 - 1000) << 52), f64::from_bits((1023 + 1000) << 52)),
    });
    type Quick = Bounded<f64>;
    type Products = Bounded<f64>;
    // Four products of 2^-1074 to 2^1024: 8392 bits, and room for their number.
    type Sum = Sum<132>;

    fn parts(self) -> Parts {
        let bits = self.to_bits();
        let (exponent, fraction) = ((bits >> 52) & 0x7ff, bits & 0xf_ffff_ffff_ffff);
        let hidden = if exponent == 0 { 0 } else { 1 << 52 };
        Parts {
            negative: bits >> 63 != 0,
            magnitude: hidden | fraction,
            shift: exponent.saturating_sub(1) as u16,
        }
    }

    #[inline(always)]
    fn decide<P: Predicate<Self>>(p: &P) -> P::Answer {
        rung::<_, Bounded<f64>, _>(p, if FEW_RUNGS { exactly } else { wide_integers })
    }

    #[inline(always)]
    fn measure<P: Predicate<Self>>(p: &P) -> P::Answer {
        first::<_, Bounded<f64>, _>(p, thorough)
    }
}

#[cfg(test)]
mod tests {
    use super::{Float, Padding, Scalar};

    /// 2^e, made without bits.
    fn two_to<F: Float>(e: i32) -> F {
        let factor = if e < 0 { F::HALF } else { F::from(2_u8) };
        (0..e.unsigned_abs()).fold(F::from(1_u8), |x, _| x * factor)
    }

    /// What the bounds and the docs say of a type, whatever its constants are made of.
    fn check<F: Float + Scalar>(digits: i32, reach: [i32; 2], tame: [i32; 2]) {
        let one = F::from(1_u8);
        assert!(F::ROUNDOFF == two_to(-digits));
        assert!(one + F::ROUNDOFF == one && one + two_to(1 - digits) > one);
        assert!(F::REACH == (two_to(reach[0]), two_to(reach[1])));
        let Some(Padding { ratio, least, tame: ends }) = F::PADDING else { unreachable!() };
        assert!(ratio == two_to(3 - digits) && least == F::TINY);
        assert!(ends == (two_to(tame[0]), two_to(tame[1])));
    }

    #[test]
    fn constants_are_what_they_are_said_to_be() {
        check::<f32>(24, [-32, 40], [-100, 100]);
        check::<f64>(53, [-320, 320], [-1000, 1000]);
    }
}
