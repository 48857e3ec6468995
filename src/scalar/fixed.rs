//! The signed types of the `fixed` crate of up to 64 bits, at full range.

use super::{Backend, FixedBackend, Scalar};
use crate::arithmetic::{
    Embeds, Filtered, InRaw, Int8, Int16, Int32, Int64, OfFour, Parts, Quad, REGISTERS_ARE_WIDE,
    RoundedOps, SMALL_CODE, ShortFloat, ShortWindow, Soft, WholeWord, Window, quotient_of_sums,
};
use crate::robust::{
    Numeric, Predicate, Stage, Sum, WordKernel, exact_stage, in_quads, integer_stage, note,
    numeric_stage, only_stage, stage,
};
use fixed::types::extra::{LeEqU8, LeEqU16, LeEqU32, LeEqU64};
use fixed::{FixedI8, FixedI16, FixedI32, FixedI64};

macro_rules! scalar {
    ($fixed:ident, $bound:ident, $window:ty, $limbs:literal, $float:ident,
     |$p:ident| $words:expr, $evaluate:expr, $numeric:expr, $bounded:expr) => {
        impl<Frac: $bound + Send + Sync + 'static> Scalar for $fixed<Frac> {
            const ZERO: Self = Self::ZERO;

            #[inline(always)]
            fn is_finite(self) -> bool {
                true
            }
        }

        impl<Frac: $bound + Send + Sync + 'static> Backend for $fixed<Frac> {
            const ONE: Parts =
                Parts { negative: false, magnitude: 1, shift: Self::FRAC_NBITS as u16 };
            const UNIT_LENGTH: Self = Self::DELTA;
            const UNIT_OF_SQUARES: [Self; 2] = {
                let half = Self::FRAC_NBITS / 2;
                [Self::from_bits(1 << half), Self::from_bits(1 << (Self::FRAC_NBITS - half))]
            };
            const IN_QUADS: bool = REGISTERS_ARE_WIDE && <$float as OfFour>::Quad::IS_VECTOR;
            type SeptumWindow = $window;
            type SeptumFull = $window;
            // Room for the sum of several products of four raw numbers.
            type SeptumSum = Sum<$limbs>;

            fn quotient(num: &Self::SeptumSum, den: &Self::SeptumSum) -> Self {
                Self::clamped(quotient_of_sums(num, den, Self::FRAC_NBITS))
            }
            #[inline(always)]
            fn at_most(x: Soft) -> Self {
                let unit = -(Self::FRAC_NBITS as i32);
                match x.floor(64, unit) {
                    (whole, exponent) if exponent == unit => {
                        i64::try_from(whole).map_or(Self::MAX, Self::clamped)
                    }
                    _ => Self::MAX,
                }
            }
            fn parts(self) -> Parts {
                let bits = i64::from(self.to_bits());
                Parts { negative: bits < 0, magnitude: bits.unsigned_abs(), shift: 0 }
            }
            #[inline(always)]
            fn evaluate<P: Predicate<Self>>(p: &P) -> P::Answer {
                match Self::in_quads(p) {
                    Some(answer) => answer,
                    None => Self::without_quads(p),
                }
            }
            #[inline(always)]
            fn in_quads<P: Predicate<Self>>(p: &P) -> Option<P::Answer> {
                if Self::IN_QUADS { in_quads::<_, $float, _>(p) } else { None }
            }
            #[inline(always)]
            fn without_quads<P: Predicate<Self>>($p: &P) -> P::Answer {
                match $p.in_words(false) {
                    Some(answer) => answer,
                    None => $evaluate,
                }
            }
            #[inline(always)]
            fn evaluate_numeric<P: Numeric<Self>>($p: &P) -> P::Answer {
                $numeric
            }
            #[inline(always)]
            fn evaluate_bounded<P: Predicate<Self>>($p: &P) -> Option<P::Answer> {
                $bounded
            }
        }

        impl<Frac: $bound + Send + Sync + 'static> ShortFloat for $fixed<Frac> {}

        impl<Frac: $bound + Send + Sync + 'static> FixedBackend for $fixed<Frac> {
            #[inline(always)]
            fn in_machine_words<K: WordKernel<Self>>($p: &K) -> Option<K::Answer> {
                if REGISTERS_ARE_WIDE { None } else { $words }
            }
        }

        impl<Frac: $bound + Send + Sync + 'static> RoundedOps for $fixed<Frac> {
            const PLAIN_ZERO: Self = Self::ZERO;

            #[inline(always)]
            fn plain_one() -> Self {
                Self::saturating_from_num(1)
            }
            fn rest_of_one(u: Self, v: Self) -> Self {
                let [u, v] = [u, v].map(|x| i128::from(x.to_bits()));
                let least = -i128::from(Self::GREATEST) - 1;
                let rest = (1_i128 << Self::FRAC_NBITS) - u - v;
                Self::from_raw(rest.clamp(least, Self::GREATEST.into()) as i64)
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
            fn plain_div(self, other: Self) -> Self {
                if other == Self::ZERO {
                    if self < Self::ZERO { Self::MIN } else { Self::MAX }
                } else {
                    self.wrapping_div(other)
                }
            }
            #[inline(always)]
            fn plain_abs(self) -> Self {
                self.wrapping_abs()
            }
            #[inline(always)]
            fn flip_sign_by(self, other: Self) -> Self {
                if other < Self::ZERO { self.wrapping_neg() } else { self }
            }
            #[inline(always)]
            fn plain_half(self) -> Self {
                self >> 1_u32
            }
        }
    };
}
scalar!(
    FixedI8,
    LeEqU8,
    ShortWindow,
    1,
    f32,
    |p| within(p.narrow::<i32>().or_else(|| p.narrow_volumes::<i16>())),
    only_stage::<_, Int8, _>(p),
    by_double(p),
    Self::in_quads(p).or_else(|| p.in_words(true)).or_else(|| p.filter::<Int8>())
);
scalar!(
    FixedI16,
    LeEqU16,
    ShortWindow,
    2,
    f32,
    |p| in_words::<i32, _, _>(p),
    only_stage::<_, Int16, _>(p),
    by_double(p),
    Self::in_quads(p).or_else(|| p.in_words(true)).or_else(|| p.filter::<Int16>())
);
scalar!(
    FixedI32,
    LeEqU32,
    ShortWindow,
    3,
    f32,
    |p| {
        let near = if SMALL_CODE { None } else { in_words::<i32, _, _>(p) };
        near.or_else(|| in_words::<i64, _, _>(p))
    },
    by_size(p),
    by_double(p),
    without_sums(p)
);
scalar!(
    FixedI64,
    LeEqU64,
    Window,
    5,
    f64,
    |p| within(p.narrow::<i128>()),
    if SMALL_CODE && P::PROFILE.is_cut {
        exact_stage(p)
    } else {
        stage::<_, Int64, _>(p, exact_stage)
    },
    Self::evaluate(p),
    p.in_words(true).or_else(|| p.filter::<Int64>())
);

/// The answer of a kernel in words of `W`: without volumes, or with them.
#[inline(always)]
fn in_words<W: WholeWord, S: InRaw, K: WordKernel<S>>(kernel: &K) -> Option<K::Answer> {
    within(kernel.narrow::<W>().or_else(|| kernel.narrow_volumes::<W>()))
}

/// The answer of a kernel in words. Without one, the shapes are beyond these words.
#[inline(always)]
fn within<T>(answer: Option<T>) -> Option<T> {
    if answer.is_none() {
        note(Stage::Narrow);
    }
    answer
}

/// If floats are cheap, asks `f64` first: it decides nearly all questions, faster than integers,
/// and changes no answer.
#[inline(always)]
fn by_double<S: Scalar, P: Numeric<S>>(p: &P) -> P::Answer
where
    Filtered<f64>: Embeds<S>,
{
    if !REGISTERS_ARE_WIDE {
        return S::evaluate(p);
    }
    match S::in_quads(p) {
        Some(answer) => answer,
        None => numeric_stage(p, |p, _| without_quads(p)),
    }
}

/// The stages after vectors, out of line.
#[inline(never)]
fn without_quads<S: Scalar, P: Predicate<S>>(p: &P) -> P::Answer {
    S::without_quads(p)
}

#[inline(always)]
fn by_size<Frac: LeEqU32 + Send + Sync + 'static, P: Predicate<FixedI32<Frac>>>(
    p: &P,
) -> P::Answer {
    if !REGISTERS_ARE_WIDE {
        stage::<_, Int32, _>(p, exact_stage)
    } else if has_short_stage::<Frac, P>() {
        stage::<_, Int16, _>(p, middling)
    } else {
        stage::<_, Int32, _>(p, integer_stage::<_, Int64, _>)
    }
}

/// Whether 18-bit integers are worth a stage. They are not if 28-bit integers cost no more, nor
/// after vectors, which leave only contacts and distant coordinates undecided.
#[inline(always)]
const fn has_short_stage<Frac: LeEqU32 + Send + Sync + 'static, P: Predicate<FixedI32<Frac>>>()
-> bool {
    P::PROFILE.has_volumes && !(P::PROFILE.has_quads && FixedI32::<Frac>::IN_QUADS)
}

#[inline(never)]
fn middling<Frac: LeEqU32 + Send + Sync + 'static, P: Predicate<FixedI32<Frac>>>(
    p: &P,
) -> P::Answer {
    stage::<_, Int32, _>(p, integer_stage::<_, Int64, _>)
}

/// The stages of [`by_size`] without exact sums: the last stage is 64-bit integers, which hold all
/// coordinates, and can fail only on products for oriented boxes.
#[inline(always)]
fn without_sums<Frac: LeEqU32 + Send + Sync + 'static, P: Predicate<FixedI32<Frac>>>(
    p: &P,
) -> Option<P::Answer> {
    if !REGISTERS_ARE_WIDE {
        let near = p.in_words(true).or_else(|| p.filter::<Int32>());
        return near.or_else(|| p.filter::<Int64>());
    }
    let is_short = has_short_stage::<Frac, P>();
    FixedI32::<Frac>::in_quads(p)
        .or_else(|| p.in_words(true))
        .or_else(|| if is_short { p.filter::<Int16>() } else { p.filter::<Int32>() })
        .or_else(|| far_without_sums(p))
}

/// The stages of [`without_sums`] after the first, out of line.
#[inline(never)]
fn far_without_sums<Frac: LeEqU32 + Send + Sync + 'static, P: Predicate<FixedI32<Frac>>>(
    p: &P,
) -> Option<P::Answer> {
    let middling = if has_short_stage::<Frac, P>() { p.filter::<Int32>() } else { None };
    middling.or_else(|| p.filter::<Int64>())
}
