//! Fixed-point numbers in number systems, by their raw bits.
//!
//! A fixed-point number is an integer with a unit. A verdict does not depend on the unit; a
//! quotient, an offset and an axis do.

use core::cmp::Ordering;

use super::big_int::BigInt;
use super::ends::{enclosed, enclosed_on_line};
use super::filtered::{Filtered, compare_quotient};
use super::float::{FirstFloat, InFloat};
use super::integer::{Int8, Int16, Int32, Int64, IntNear, below};
use super::parts::exp2;
use super::quotient::{Dividend, nearest_of_all, nearest_whole, nearest_whole_of_row};
use super::system::{Arithmetic, Embeds, convert};
use super::window::{Limbs2, Limbs4, ShortWindow, Window};
use super::words::InRaw;
use fixed::types::extra::{LeEqU8, LeEqU16, LeEqU32, LeEqU64};
use fixed::{FixedI8, FixedI16, FixedI32, FixedI64};

/// Exact numbers for each type, in integers of the machine or in a window, and the coordinates that
/// they hold.
macro_rules! embeds {
    ($kind:ident, #[$inline:meta]: $($fixed:ident, $bound:ident, $system:ty, $length:ty,
     $of_areas:ty, |$coordinates:ident| $fits:expr;)*) => {$(
        impl<Frac: $bound> Embeds<$fixed<Frac>> for $system {
            type OfAreas = $of_areas;

            #[inline(always)]
            fn holds<const K: usize>($coordinates: &[[$fixed<Frac>; 3]; K]) -> bool {
                $fits
            }
            #[$inline]
            fn embed_held<const K: usize>(all: &[[$fixed<Frac>; 3]; K]) -> [[$length; 3]; K] {
                convert(all, 0, |x| x.to_bits().into())
            }
            embeds!(@one $kind, $system, $length, <$fixed<Frac>>::FRAC_NBITS);

            const DIVIDES: bool = true;

            #[$inline]
            fn quotients(
                [a, b, c]: [<$system as Arithmetic>::Volume; 3],
                den: <$system as Arithmetic>::Volume,
                _: [<$system as Arithmetic>::Volume; 2],
            ) -> ([$fixed<Frac>; 3], bool) {
                let of = |num: <$system as Arithmetic>::Volume| {
                    <$fixed<Frac>>::clamped(num.quotient(den, <$fixed<Frac>>::FRAC_NBITS))
                };
                ([of(a), of(b), of(c)], true)
            }
            #[$inline]
            fn quotient_of_lengths(num: $length, den: $length) -> $fixed<Frac> {
                <$fixed<Frac>>::clamped(num.quotient(den, <$fixed<Frac>>::FRAC_NBITS))
            }
            #[$inline]
            fn coordinate(
                num: <$system as Arithmetic>::Sextic,
                den: <$system as Arithmetic>::Sextic,
                _: [<$system as Arithmetic>::Sextic; 2],
            ) -> Option<$fixed<Frac>> {
                Some(<$fixed<Frac>>::clamped(Dividend::quotient(num, den, 0)))
            }
            #[$inline]
            fn compare_quotient(
                num: <$system as Arithmetic>::Volume,
                den: <$system as Arithmetic>::Volume,
                _: [<$system as Arithmetic>::Volume; 2],
                t: $fixed<Frac>,
            ) -> Option<Ordering> {
                let (shift, t) = (<$fixed<Frac>>::FRAC_NBITS, t.to_bits());
                embeds!(@compare $kind, $system, num, den, shift, t)
            }
        }
    )*};
    (@one integers, $system:ty, $length:ty, $shift:expr) => {
        fn one() -> Option<<$system as Arithmetic>::Product> {
            // A unit above 2^30 would leave no room for the products.
            ($shift <= 30).then(|| 1 << $shift)
        }
        fn times_one(d: $length, _: $length) -> <$system as Arithmetic>::Area {
            // See the table in `integer`.
            <$system as Arithmetic>::Area::from(2 * d) << $shift
        }
    };
    (@one window, $system:ty, $length:ty, $shift:expr) => {
        fn one() -> Option<<$system as Arithmetic>::Product> {
            Some((1_i128 << $shift).into())
        }
        fn times_one(d: $length, _: $length) -> <$system as Arithmetic>::Area {
            Self::area(2 * d, 1 << $shift)
        }
    };
    (@compare integers, $system:ty, $num:ident, $den:ident, $shift:ident, $t:ident) => {
        Some($num.compare($den, $shift, $t.into()))
    };
    (@compare window, $system:ty, $num:ident, $den:ident, $shift:ident, $t:ident) => {{
        let num: <$system as Arithmetic>::Product = $num.times(&BigInt::<2>::from(1 << $shift));
        num.partial_cmp(&$den.times(&BigInt::<2>::from(i128::from($t))))
    }};
}
embeds! { integers, #[inline(always)]:
    FixedI8, LeEqU8, Int8, i32, Int32, |_all| true;
    FixedI16, LeEqU16, Int16, i32, Int64, |_all| true;
    FixedI32, LeEqU32, IntNear, i32, Int64, |_all| true;
    FixedI32, LeEqU32, Int16, i32, Int64, |all| below(all.as_flattened(), 18);
    FixedI32, LeEqU32, Int32, i32, Int64, |all| below(all.as_flattened(), 28);
    FixedI32, LeEqU32, Int64, i64, Window, |_all| true;
    FixedI64, LeEqU64, Int64, i64, Window, |all| below(all.as_flattened(), 60);
}
embeds! { window, #[inline]:
    FixedI8, LeEqU8, ShortWindow, i64, Limbs2, |_all| true;
    FixedI16, LeEqU16, ShortWindow, i64, Limbs2, |_all| true;
    FixedI32, LeEqU32, ShortWindow, i64, Limbs2, |_all| true;
    FixedI64, LeEqU64, Window, i128, Limbs4, |_all| true;
}

/// The raw bits of a type, in a word of the machine, and in the floats that are asked first and second,
/// each with its limit.
macro_rules! in_raw {
    ($(
        $fixed:ident, $bound:ident: $raw:ty, [$first:ty, $second:ty], $($float:ty: $limit:expr),+;
    )*) => {$(
        impl<Frac: $bound> InRaw for $fixed<Frac> {
            type Raw = $raw;

            const FRACTION_BITS: i32 = Self::FRAC_NBITS as i32;

            const GREATEST: i64 = Self::MAX.to_bits() as i64;

            #[inline(always)]
            fn raw(self) -> $raw {
                self.to_bits().into()
            }
            #[inline(always)]
            fn from_raw(raw: i64) -> Self {
                Self::from_bits(raw as _)
            }
        }

        $(impl<Frac: $bound> InFloat<$float> for $fixed<Frac> {
            const OFFSETS_FIRST: bool = size_of::<$float>() == size_of::<f64>();
            const LIMIT: Option<$float> = $limit;
            const PLACE: $float = 1.0 / (1_u128 << Self::FRAC_NBITS) as $float;
            #[inline(always)]
            fn in_float(self) -> $float {
                self.to_bits() as $float
            }
        })+

        impl<Frac: $bound> FirstFloat for $fixed<Frac> {
            type SeptumFirst = $first;
            type SeptumSecond = $second;
        }
    )*};
}
in_raw! {
    FixedI8, LeEqU8: i32, [f32, f32], f32: None;
    FixedI16, LeEqU16: i32, [f32, f32], f32: None;
    FixedI32, LeEqU32: i32, [f32, f64], f32: Some((1_u32 << 24) as f32), f64: None;
    FixedI64, LeEqU64: i64, [f64, f64], f64: Some((1_u64 << 53) as f64);
}

/// Integers in `f64`: verdicts if they exceed the error, and quotients if it is certain how they
/// round.
impl<S: InRaw<Raw = i32>> Embeds<S> for Filtered<f64> {
    type OfAreas = Self;

    const DIVIDES: bool = false;

    #[inline(always)]
    fn holds<const K: usize>(_: &[[S; 3]; K]) -> bool {
        true
    }
    #[inline(always)]
    fn embed_held<const K: usize>(all: &[[S; 3]; K]) -> [[f64; 3]; K] {
        convert(all, 0.0, |x| x.raw().into())
    }
    fn one() -> Option<f64> {
        Some(unit::<S>())
    }
    fn times_one(d: f64, _: f64) -> f64 {
        d * unit::<S>()
    }
    #[inline(always)]
    fn quotient_of_lengths(_: f64, _: f64) -> S {
        S::from_raw(0)
    }
    #[inline(always)]
    fn quotients(num: [f64; 3], den: f64, errors: [f64; 2]) -> ([S; 3], bool) {
        let unit = unit::<S>();
        let ([t, u, v], are_good) = nearest_whole(num, den, errors, unit, S::GREATEST as f64);
        let of = |bits: u64| S::from_raw(bits as i64);
        ([of(t), of(u), of(v)], are_good)
    }
    #[inline(always)]
    fn quotients_of_row(row: [f64; 4], errors: [f64; 2]) -> ([S; 3], bool) {
        let unit = unit::<S>();
        let ([t, u, v], are_good) = nearest_whole_of_row(row, errors, unit, S::GREATEST as f64);
        let of = |bits: u64| S::from_raw(bits as i64);
        ([of(t), of(u), of(v)], are_good)
    }
    /// In units of the last place.
    #[inline(always)]
    fn nearest(between: [f64; 2]) -> Option<S> {
        let bits = nearest_of_all(between, S::GREATEST as f64)?;
        Some(S::from_raw(bits as i64))
    }
    /// In units of the last place.
    #[inline(always)]
    fn coordinate(num: f64, den: f64, errors: [f64; 2]) -> Option<S> {
        <Self as Embeds<S>>::nearest(enclosed(num, den, errors)?)
    }
    /// In units of the last place.
    #[inline(always)]
    fn on_line(
        a: &[f64; 3],
        v: &[f64; 3],
        num: f64,
        den: f64,
        errors: (f64, f64, f64),
    ) -> Option<[S; 3]> {
        let [x, y, z] = enclosed_on_line(a, v, num, den, errors)?;
        let nearest = <Self as Embeds<S>>::nearest;
        Some([nearest(x)?, nearest(y)?, nearest(z)?])
    }
    #[inline(always)]
    fn compare_quotient(num: f64, den: f64, errors: [f64; 2], t: S) -> Option<Ordering> {
        let t = f64::from(t.raw()) / unit::<S>();
        compare_quotient(num, den, errors, t, f64::INFINITY)
    }
}

/// The number of last places in one.
#[inline(always)]
fn unit<S: InRaw>() -> f64 {
    exp2(S::FRACTION_BITS)
}
