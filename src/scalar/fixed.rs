//! The signed types of the `fixed` crate of up to 64 bits, at full range.

use fixed::types::extra::{LeEqU8, LeEqU16, LeEqU32, LeEqU64};
use fixed::{FixedI8, FixedI16, FixedI32, FixedI64};

use super::{Backend, Scalar};
use crate::arithmetic::{
    Embeds, Filtered, InWholeWord, Int8, Int16, Int32, Int64, OfFour, Parts, Quad,
    REGISTERS_ARE_WIDE, RoundedOps, SMALL_CODE, Soft, WholeWord, Window, clamped,
};
use crate::robust::{
    Predicate, Sum, exact_stage, in_quads, integer_stage, narrow_stage, numeric_stage, only_stage,
    short_stage, stage, volume_stage,
};

macro_rules! scalar {
    ($fixed:ident, $bound:ident, $limbs:literal, $float:ident,
     |$p:ident| $evaluate:expr, $numeric:expr, $bounded:expr) => {
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
            const IN_QUADS: bool = REGISTERS_ARE_WIDE && <$float as OfFour>::Quad::IS_VECTOR;
            type SeptumWindow = Window;
            type SeptumFull = Window;
            // Room for the sum of several products of four raw numbers.
            type SeptumSum = Sum<$limbs>;

            fn quotient(num: &Self::SeptumSum, den: &Self::SeptumSum) -> Self {
                clamped!($fixed, num.quotient(den, Self::FRAC_NBITS))
            }
            #[inline(always)]
            fn at_most(x: Soft) -> Self {
                let unit = -(Self::FRAC_NBITS as i32);
                match x.floor(64, unit) {
                    (whole, exponent) if exponent == unit => {
                        i64::try_from(whole).map_or(Self::MAX, |whole| clamped!($fixed, whole))
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
            fn without_quads<P: Predicate<Self>>(p: &P) -> P::Answer {
                short_stage(p, |$p| $evaluate)
            }
            #[inline(always)]
            fn evaluate_numeric<P: Predicate<Self>>($p: &P) -> P::Answer {
                $numeric
            }
            #[inline(always)]
            fn evaluate_bounded<P: Predicate<Self>>($p: &P) -> Option<P::Answer> {
                let short = if P::IN_SHORT { $p.cut_down() } else { None };
                short.or_else(|| $bounded)
            }
        }

        impl<Frac: $bound + Send + Sync + 'static> RoundedOps for $fixed<Frac> {
            const PLAIN_ZERO: Self = Self::ZERO;

            #[inline(always)]
            fn plain_one() -> Self {
                Self::saturating_from_num(1)
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
    1,
    f32,
    |p| narrow_stage::<_, i32, _>(p, |p| volume_stage::<_, i16, _>(p, only_stage::<_, Int8, _>)),
    by_double(p),
    Some(Self::evaluate(p))
);
scalar!(
    FixedI16,
    LeEqU16,
    2,
    f32,
    |p| in_words::<i32, _, _>(p, only_stage::<_, Int16, _>),
    by_double(p),
    Some(Self::evaluate(p))
);
scalar!(FixedI32, LeEqU32, 3, f32, |p| by_size(p), by_double(p), without_sums(p));
scalar!(
    FixedI64,
    LeEqU64,
    5,
    f64,
    |p| beyond_words(p),
    Self::evaluate(p),
    p.cut_down().or_else(|| p.in_short()).or_else(|| p.filter::<Int64>())
);

/// The stages of 64-bit fixed point.
#[inline(always)]
fn beyond_words<Frac: LeEqU64 + Send + Sync + 'static, P: Predicate<FixedI64<Frac>>>(
    p: &P,
) -> P::Answer {
    if SMALL_CODE && P::IN_SHORT {
        return exact_stage(p);
    }
    narrow_stage::<_, i128, _>(p, |p| stage::<_, Int64, _>(p, exact_stage))
}

/// The stages of cores with narrow registers, in words of `W`: the kernel without volumes, then the
/// one with volumes.
#[inline(always)]
fn in_words<W: WholeWord, S: InWholeWord<W>, P: Predicate<S>>(
    p: &P,
    next: impl FnOnce(&P) -> P::Answer,
) -> P::Answer {
    narrow_stage::<S, W, P>(p, |p| volume_stage::<S, W, P>(p, next))
}

/// If floats are cheap, asks `f64` first: it decides nearly all questions, faster than integers,
/// and changes no answer.
#[inline(always)]
fn by_double<S: Scalar, P: Predicate<S>>(p: &P) -> P::Answer
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
    if REGISTERS_ARE_WIDE {
        if has_short_stage::<Frac, P>() {
            stage::<_, Int16, _>(p, middling)
        } else {
            stage::<_, Int32, _>(p, integer_stage)
        }
    } else if SMALL_CODE {
        in_words::<i64, _, _>(p, |p| stage::<_, Int32, _>(p, exact_stage))
    } else {
        in_words::<i32, _, _>(p, |p| {
            in_words::<i64, _, _>(p, |p| stage::<_, Int32, _>(p, exact_stage))
        })
    }
}

/// Whether 18-bit integers are worth a stage. They are not if 28-bit integers cost no more, nor
/// after vectors, which leave only contacts and distant coordinates undecided.
#[inline(always)]
const fn has_short_stage<Frac: LeEqU32 + Send + Sync + 'static, P: Predicate<FixedI32<Frac>>>()
-> bool {
    P::HAS_VOLUMES && !(P::IN_QUADS && FixedI32::<Frac>::IN_QUADS)
}

#[inline(never)]
fn middling<Frac: LeEqU32 + Send + Sync + 'static, P: Predicate<FixedI32<Frac>>>(
    p: &P,
) -> P::Answer {
    stage::<_, Int32, _>(p, integer_stage)
}

/// The stages of [`by_size`] without exact sums: the last stage is 64-bit integers, which hold all
/// coordinates, and can fail only on products for oriented boxes.
#[inline(always)]
fn without_sums<Frac: LeEqU32 + Send + Sync + 'static, P: Predicate<FixedI32<Frac>>>(
    p: &P,
) -> Option<P::Answer> {
    if REGISTERS_ARE_WIDE {
        let near = FixedI32::<Frac>::in_quads(p);
        let is_short = has_short_stage::<Frac, P>();
        let near = near.or_else(|| p.in_short());
        let near =
            near.or_else(|| if is_short { p.filter::<Int16>() } else { p.filter::<Int32>() });
        return near.or_else(|| far_without_sums(p));
    }
    let near = p.in_short();
    let near = near.or_else(|| if SMALL_CODE { None } else { p.narrow::<i32>() });
    near.or_else(|| p.narrow::<i64>())
        .or_else(|| p.filter::<Int32>())
        .or_else(|| p.filter::<Int64>())
}

/// The stages of [`without_sums`] after the first, out of line.
#[inline(never)]
fn far_without_sums<Frac: LeEqU32 + Send + Sync + 'static, P: Predicate<FixedI32<Frac>>>(
    p: &P,
) -> Option<P::Answer> {
    let middling = if has_short_stage::<Frac, P>() { p.filter::<Int32>() } else { None };
    middling.or_else(|| p.filter::<Int64>())
}
