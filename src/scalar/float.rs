//! `f32` and `f64` as scalars.

use super::{Backend, FloatFormat, Scalar};
use crate::arithmetic::{
    Embeds, Float, FullF32, FullF64, Int64OfFloats, Parts, REGISTERS_ARE_WIDE, RoundedOps,
    SMALL_CODE, Soft, Window, exp2, quotient,
};
use crate::robust::{
    Clue, Numeric, Predicate, Sum, exact_stage, in_floats, in_quads, integer_stage, numeric_stage,
    refined_stage,
};

macro_rules! float {
    ($float:ty) => {
        impl Scalar for $float {
            const ZERO: Self = 0.0;

            #[inline(always)]
            fn is_finite(self) -> bool {
                self.is_finite()
            }
        }

        impl RoundedOps for $float {
            const PLAIN_ZERO: Self = 0.0;

            #[inline(always)]
            fn plain_one() -> Self {
                1.0
            }
            #[inline(always)]
            fn rest_of_one(u: Self, v: Self) -> Self {
                1.0 - u - v
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
            fn plain_abs(self) -> Self {
                self.abs()
            }
            #[inline(always)]
            fn flip_sign_by(self, other: Self) -> Self {
                // Exclusive or of the sign bits takes two instructions; a choice takes three.
                let minus: Self = -0.0;
                Self::from_bits(self.to_bits() ^ (other.to_bits() & minus.to_bits()))
            }
            #[inline(always)]
            fn plain_half(self) -> Self {
                self * 0.5
            }
        }
    };
}
float!(f32);
float!(f64);

/// The methods that `f32` and `f64` share.
macro_rules! as_any_float {
    ($float:ident) => {
        const UNIT_LENGTH: Self = 1.0;
        const UNIT_OF_SQUARES: [Self; 2] = [1.0; 2];
        const IN_QUADS: bool = REGISTERS_ARE_WIDE;

        fn parts(self) -> Parts {
            Float::parts(self)
        }
        fn quotient(num: &Self::SeptumSum, den: &Self::SeptumSum) -> Self {
            quotient(num.sign_magnitude(), den.sign_magnitude())
        }
        #[inline(always)]
        fn at_most(x: Soft) -> Self {
            let least = -i32::from(Self::ONE.shift);
            let (whole, exponent) = x.floor(Self::MANTISSA_DIGITS, least);
            Float::scaled(whole, exponent)
        }
        #[inline(always)]
        fn evaluate<P: Predicate<Self>>(p: &P) -> P::Answer {
            match in_floats::<_, $float, _>(p) {
                Some(answer) => answer,
                None => Self::without_quads(p),
            }
        }
        #[inline(always)]
        fn in_quads<P: Predicate<Self>>(p: &P) -> Option<P::Answer> {
            in_quads::<_, $float, _>(p)
        }
        #[inline(always)]
        fn evaluate_bounded<P: Predicate<Self>>(p: &P) -> Option<P::Answer> {
            in_floats::<_, $float, _>(p)
        }
    };
}

impl Backend for f32 {
    const ONE: Parts = Parts { negative: false, magnitude: 1, shift: 149 };
    const FLOAT: Option<FloatFormat<f32>> = Some(FloatFormat {
        roundoff: <f32 as Float>::ROUNDOFF,
        least_normal: f32::MIN_POSITIVE,
        invertible: (exp2(-100) as f32, exp2(100) as f32),
    });
    type SeptumWindow = Window;
    type SeptumFull = FullF32;
    // Products of four numbers of 2^-149 to 2^128 take 1108 bits; the rest is room to add them.
    type SeptumSum = Sum<18>;

    as_any_float!(f32);

    #[inline(always)]
    fn without_quads<P: Predicate<Self>>(p: &P) -> P::Answer {
        if SMALL_CODE { exact_stage(p) } else { doubled(p) }
    }
    #[inline(always)]
    fn evaluate_numeric<P: Numeric<Self>>(p: &P) -> P::Answer {
        if P::PROFILE.has_quads && REGISTERS_ARE_WIDE {
            return Self::evaluate(p);
        }
        // Here `f64` costs no more than `f32`.
        if REGISTERS_ARE_WIDE {
            return numeric_stage(p, refined);
        }
        // A hit's numbers come from integers or from `f64`; `f32` can only decide that there is no
        // hit.
        match in_floats::<_, f32, _>(p) {
            Some(answer) => answer,
            None => doubled(p),
        }
    }
}

/// The second stage of `f32`: the same code in `f64`.
#[cold]
#[inline(never)]
fn doubled<P: Predicate<f32>>(p: &P) -> P::Answer {
    match in_floats::<_, f64, _>(p) {
        Some(answer) => answer,
        None => beyond_floats(p),
    }
}

/// The stages after floats.
#[inline(always)]
fn beyond_floats<S: Backend, P: Predicate<S>>(p: &P) -> P::Answer
where
    Int64OfFloats: Embeds<S>,
{
    if SMALL_CODE { exact_stage(p) } else { integer_stage::<_, Int64OfFloats, _>(p) }
}

/// The stages of `f32` for hits after the first, if `f64` is cheap. Hits beyond the precision of
/// `f64` get the same numbers from residuals as from integers, in less time.
#[cold]
#[inline(never)]
fn refined<P: Numeric<f32>>(p: &P, clue: Clue) -> P::Answer {
    refined_stage(p, clue, beyond_floats)
}

impl Backend for f64 {
    const ONE: Parts = Parts { negative: false, magnitude: 1, shift: 1074 };
    const FLOAT: Option<FloatFormat<f64>> = Some(FloatFormat {
        roundoff: <f64 as Float>::ROUNDOFF,
        least_normal: f64::MIN_POSITIVE,
        invertible: (exp2(-1000), exp2(1000)),
    });
    type SeptumWindow = Window;
    type SeptumFull = FullF64;
    // Products of four numbers of 2^-1074 to 2^1024 take 8392 bits; the rest is room to add them.
    type SeptumSum = Sum<132>;

    as_any_float!(f64);

    #[inline(always)]
    fn without_quads<P: Predicate<Self>>(p: &P) -> P::Answer {
        beyond_floats(p)
    }
    #[inline(always)]
    fn evaluate_numeric<P: Numeric<Self>>(p: &P) -> P::Answer {
        if P::PROFILE.has_quads && REGISTERS_ARE_WIDE {
            return Self::evaluate(p);
        }
        numeric_stage(p, refined_doubles)
    }
}

/// The stages of `f64` for hits after the first.
#[inline(never)]
fn refined_doubles<P: Numeric<f64>>(p: &P, clue: Clue) -> P::Answer {
    refined_stage(p, clue, beyond_floats)
}
