//! Every signed type of the `fixed` crate, at full range.
//!
//! A fixed-point number is an integer with a name for its unit. A verdict does
//! not depend on the unit, so all of it is decided on the raw bits.

use core::cmp::Ordering;

use fixed::types::extra::{LeEqU8, LeEqU16, LeEqU32, LeEqU64};
use fixed::{FixedI8, FixedI16, FixedI32, FixedI64};

use super::bounded::Bounded;
use super::coarse::Coarse;
use super::integer::{Int8, Int16, Int32, Int64, REGISTERS_ARE_WIDE, below_i32, below_i64};
use super::ladder::{
    FEW_RUNGS, Predicate, exactly, first, only, rung, thorough, wide_integers, words,
};
use super::numbers::{Holds, Numbers, Placed, convert};
use super::quotient::Dividend;
use super::sum::{Parts, Sum};
use super::word::InWord;
use super::{Scalar, sealed};

/// The number with these raw bits, or the end of the type.
macro_rules! clamped {
    ($fixed:ident, $bits:expr) => {{
        let bits: i64 = $bits;
        <$fixed<Frac>>::from_bits(
            bits.clamp(<$fixed<Frac>>::MIN.to_bits().into(), <$fixed<Frac>>::MAX.to_bits().into())
                as _,
        )
    }};
}

/// What a system needs to divide, all of it by the raw bits.
macro_rules! quotients {
    ($fixed:ident, $length:ty, $volume:ty) => {
        const DIVIDES: bool = true;

        #[inline(always)]
        fn quotients(
            [a, b, c]: [$volume; 3],
            den: $volume,
            _: [$volume; 2],
        ) -> ([$fixed<Frac>; 3], bool) {
            let of = |num: $volume| clamped!($fixed, num.quotient(den, <$fixed<Frac>>::FRAC_NBITS));
            ([of(a), of(b), of(c)], true)
        }
        #[inline(always)]
        fn quotient_of_lengths(num: $length, den: $length) -> $fixed<Frac> {
            clamped!($fixed, num.quotient(den, <$fixed<Frac>>::FRAC_NBITS))
        }
        #[inline(always)]
        fn compare_quotient(
            num: $volume,
            den: $volume,
            _: [$volume; 2],
            t: $fixed<Frac>,
        ) -> Option<Ordering> {
            Some(num.compare(den, <$fixed<Frac>>::FRAC_NBITS, t.to_bits().into()))
        }
    };
}

macro_rules! scalar {
    ($fixed:ident, $bound:ident, $limbs:literal, $quick:ty, $products:ty,
     |$p:ident| $ladder:expr, $measure:expr) => {
        impl<Frac: $bound> sealed::Sealed for $fixed<Frac> {}

        impl<Frac: $bound + Send + Sync + 'static> Scalar for $fixed<Frac> {
            const ZERO: Self = Self::ZERO;

            const ONE: Parts =
                Parts { negative: false, magnitude: 1, shift: Self::FRAC_NBITS as u16 };
            type Quick = $quick;
            type Products = $products;
            // Four products of the raw bits, and room for their number.
            type Sum = Sum<$limbs>;

            #[inline(always)]
            fn is_finite(self) -> bool {
                true
            }
            fn quotient(num: &Self::Sum, den: &Self::Sum) -> Self {
                clamped!($fixed, num.as_i256().quotient(den.as_i256(), Self::FRAC_NBITS))
            }
            fn parts(self) -> Parts {
                let bits = i64::from(self.to_bits());
                Parts { negative: bits < 0, magnitude: bits.unsigned_abs(), shift: 0 }
            }
            #[inline(always)]
            fn decide<P: Predicate<Self>>($p: &P) -> P::Answer {
                $ladder
            }
            #[inline(always)]
            fn measure<P: Predicate<Self>>($p: &P) -> P::Answer {
                $measure
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
            fn plain_one() -> Self {
                Self::saturating_from_num(1)
            }
            #[inline(always)]
            fn plain_turned_by(self, other: Self) -> Self {
                if other < Self::ZERO { self.wrapping_neg() } else { self }
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
scalar!(
    FixedI8,
    LeEqU8,
    1,
    Int8,
    Int8,
    |p| words::<_, i32, _>(p, only::<_, Int8, _>),
    by_double(p)
);
scalar!(
    FixedI16,
    LeEqU16,
    2,
    Int16,
    Int16,
    |p| words::<_, i32, _>(p, only::<_, Int16, _>),
    by_double(p)
);
scalar!(FixedI32, LeEqU32, 3, Coarse, Int64, |p| by_size(p), by_double(p));
scalar!(
    FixedI64,
    LeEqU64,
    5,
    Coarse,
    Int64,
    |p| words::<_, i128, _>(p, |p| rung::<_, Int64, _>(p, exactly)),
    Self::decide(p)
);

/// Where floats are cheap, `f64` answers nearly all, and faster than integers. It
/// changes no answer.
#[inline(always)]
fn by_double<S: Scalar, P: Predicate<S>>(p: &P) -> P::Answer
where
    Bounded<f64>: Holds<S>,
{
    if REGISTERS_ARE_WIDE { first::<_, Bounded<f64>, _>(p, thorough) } else { S::decide(p) }
}

#[inline(always)]
fn by_size<Frac: LeEqU32 + Send + Sync + 'static, P: Predicate<FixedI32<Frac>>>(
    p: &P,
) -> P::Answer {
    if REGISTERS_ARE_WIDE {
        rung::<_, Int16, _>(p, middling)
    } else if FEW_RUNGS {
        words::<_, i64, _>(p, |p| rung::<_, Int32, _>(p, exactly))
    } else {
        words::<_, i32, _>(p, |p| words::<_, i64, _>(p, |p| rung::<_, Int32, _>(p, exactly)))
    }
}

#[inline(never)]
fn middling<Frac: LeEqU32 + Send + Sync + 'static, P: Predicate<FixedI32<Frac>>>(
    p: &P,
) -> P::Answer {
    rung::<_, Int32, _>(p, wide_integers)
}

/// The raw bits of every coordinate, in the system's type.
macro_rules! raw {
    ($coordinates:ident) => {
        convert($coordinates, 0, |_, x| x.to_bits().into())
    };
}

/// A type and the system for it, and which coordinates it holds.
macro_rules! holds {
    ($fixed:ident, $bound:ident, $system:ty, $length:ty, |$coordinates:ident| $fits:expr) => {
        impl<Frac: $bound> Holds<$fixed<Frac>> for $system {
            #[inline(always)]
            fn fits<const K: usize>($coordinates: &[[$fixed<Frac>; 3]; K]) -> bool {
                $fits
            }

            fn one() -> Option<i128> {
                // A unit above 2^30 would not leave the products room.
                (<$fixed<Frac>>::FRAC_NBITS <= 30).then(|| 1 << <$fixed<Frac>>::FRAC_NBITS)
            }

            fn times_one(d: $length) -> Option<<$system as Numbers>::Area> {
                // See the table in `integer`.
                Some(<$system as Numbers>::Area::from(2 * d) << <$fixed<Frac>>::FRAC_NBITS)
            }

            quotients!($fixed, $length, <$system as Numbers>::Volume);

            #[inline(always)]
            fn place<const P: usize, const E: usize>(
                points: &[[$fixed<Frac>; 3]; P],
                extents: &[[$fixed<Frac>; 3]; E],
            ) -> Placed<$length, P, E> {
                Placed { points: raw!(points), extents: raw!(extents) }
            }
        }
    };
}
holds!(FixedI8, LeEqU8, Int8, i32, |_all| true);
holds!(FixedI16, LeEqU16, Int16, i32, |_all| true);
holds!(FixedI32, LeEqU32, Int16, i32, |all| {
    below_i32(all.as_flattened().iter().map(|x| x.to_bits()), 18)
});
holds!(FixedI32, LeEqU32, Int32, i32, |all| {
    below_i32(all.as_flattened().iter().map(|x| x.to_bits()), 28)
});
holds!(FixedI32, LeEqU32, Int64, i64, |_all| true);
holds!(FixedI64, LeEqU64, Int64, i64, |all| {
    below_i64(all.as_flattened().iter().map(|x| x.to_bits()), 60)
});

/// The word of a type, and whether it holds whatever is asked of the type.
macro_rules! in_word {
    ($($fixed:ident, $bound:ident: $word:ty, $always_near:literal;)*) => {$(
        impl<Frac: $bound> InWord<$word> for $fixed<Frac> {
            const ALWAYS_NEAR: bool = $always_near;

            #[inline(always)]
            fn in_word(self) -> $word {
                self.to_bits().into()
            }
        }
    )*};
}
in_word! {
    FixedI8, LeEqU8: i32, true;
    FixedI16, LeEqU16: i32, true;
    FixedI32, LeEqU32: i32, false;
    FixedI32, LeEqU32: i64, true;
    FixedI64, LeEqU64: i128, true;
}

/// Types that the quick system brings down to size.
macro_rules! coarse {
    ($fixed:ident, $bound:ident, $place:ident) => {
        impl<Frac: $bound> Holds<$fixed<Frac>> for Coarse {
            #[inline(always)]
            fn fits<const K: usize>(_: &[[$fixed<Frac>; 3]; K]) -> bool {
                true
            }

            quotients!($fixed, i32, i64);

            #[inline(always)]
            fn place<const P: usize, const E: usize>(
                points: &[[$fixed<Frac>; 3]; P],
                extents: &[[$fixed<Frac>; 3]; E],
            ) -> Placed<i32, P, E> {
                Coarse::$place(&raw!(points), &raw!(extents))
            }
        }
    };
}
coarse!(FixedI32, LeEqU32, coarse_i32);
coarse!(FixedI64, LeEqU64, coarse_i64);
