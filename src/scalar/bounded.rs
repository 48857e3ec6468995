//! Floats as they are, with a bound on their error.

use core::cmp::Ordering;
use core::marker::PhantomData;

use super::float::Float;
use super::number::greatest;
use super::numbers::{Holds, Numbers, Placed, convert};

/// The number system of a float type with a bound on its error: an answer is
/// given only where it stands clear of the bound.
#[derive(Clone, Copy, Debug)]
pub struct Bounded<F>(PhantomData<F>);

impl<F: Float> Numbers for Bounded<F> {
    type Length = F;
    type Area = F;
    type Volume = F;
    type Slim = Self;

    const FINAL: bool = false;
    const ONE_FORM: bool = false;

    #[inline(always)]
    fn area(a: F, b: F) -> F {
        a * b
    }
    #[inline(always)]
    fn volume(a: F, b: F) -> F {
        a * b
    }
    #[inline(always)]
    fn from_center(v: F, center: F) -> F {
        v - center
    }
    // Not v − (min + max)/2: the sum rounds by the distance from the origin,
    // the differences only by the distance from the box.
    #[inline(always)]
    fn from_corners(v: F, min: F, max: F) -> F {
        half((v - min) + (v - max))
    }
    #[inline(always)]
    fn half_extent(half: F) -> F {
        half
    }
    #[inline(always)]
    fn half_between(min: F, max: F) -> F {
        half(max - min)
    }
    #[inline(always)]
    fn middle(n: F) -> F {
        half(n)
    }
    type Product = F;
    #[inline(always)]
    fn operand(a: F) -> F {
        a
    }
    #[inline(always)]
    fn product_bounds(axes: F, length: F, half: F, [x, y, z]: [u16; 3]) -> Option<[F; 3]> {
        let reach = greatest(length, half * axes);
        // Axes are unit vectors, or near: what is longer may as well go to the end.
        if !(axes < F::from(4_u8) && reach > F::REACH.0 && reach < F::REACH.1) {
            return None;
        }
        let u = |n: u16| F::from(n) * F::ROUNDOFF;
        let square = reach * reach;
        Some([u(x) * (axes * axes * reach), u(y) * (axes * square), u(z) * (square * reach)])
    }
    #[inline(always)]
    fn area_bound(a: F, b: F, c: F, roundoffs: u8) -> Option<F> {
        let tame = |x: F| x > F::REACH.0 && x < F::REACH.1;
        (tame(a) && tame(b) && c < F::REACH.1)
            .then(|| F::from(roundoffs) * F::ROUNDOFF * (a * b + c))
    }
    #[inline(always)]
    fn volume_bound(a: F, b: F, c: F, roundoffs: u8) -> Option<F> {
        let tame = |x: F| (x > F::REACH.0) & (x < F::REACH.1);
        (tame(a) & tame(b) & tame(c)).then(|| F::from(roundoffs) * F::ROUNDOFF * (a * b * c))
    }
    #[inline(always)]
    fn length_error(size: F, roundoffs: u8) -> F {
        F::from(roundoffs) * F::ROUNDOFF * size
    }
    #[inline(always)]
    fn area_error(size: F, roundoffs: u8) -> F {
        F::from(roundoffs) * F::ROUNDOFF * size + F::TINY
    }
    #[inline(always)]
    fn widened(slim: F) -> F {
        slim
    }
    #[inline(always)]
    fn is_slim(_: F) -> bool {
        false
    }
    #[inline(always)]
    fn bounds(reach: F, areas: u8, volumes: u8) -> Option<(F, F)> {
        // Written so that a NaN is refused too.
        if !(reach > F::REACH.0 && reach < F::REACH.1) {
            return None;
        }
        let square = reach * reach;
        let (areas, volumes) = (F::from(areas) * F::ROUNDOFF, F::from(volumes) * F::ROUNDOFF);
        Some((areas * square, volumes * (square * reach)))
    }
}

#[inline(always)]
fn half<F: Float>(x: F) -> F {
    x * F::HALF
}

macro_rules! compare_quotient {
    ($scalar:ty, $float:ty, |$t:ident| $value:expr) => {
        #[inline(always)]
        fn compare_quotient(
            num: $float,
            den: $float,
            [num_error, den_error]: [$float; 2],
            $t: $scalar,
        ) -> Option<Ordering> {
            let t: $float = $value;
            let product = t * den;
            // Twice what the operands may err, and twice the rounding of the
            // product; that of the gap is a trifle against the former.
            let error =
                2.0 * (num_error + t.abs() * den_error) + 2.0 * <$float>::ROUNDOFF * product.abs();
            let gap = num - product;
            if gap.abs() > error && product.abs() < <$float>::INFINITY {
                gap.partial_cmp(&0.0)
            } else {
                None
            }
        }
    };
}

macro_rules! bounded_holds {
    ($from:ty => $to:ty, $divides:literal, $clear:expr, |$num:ident, $den:ident| $quotients:expr) => {
        impl Holds<$from> for Bounded<$to> {
            const DIVIDES: bool = $divides;

            #[inline(always)]
            fn fits<const K: usize>(_: &[[$from; 3]; K]) -> bool {
                true
            }
            fn one() -> Option<$to> {
                Some(1.0)
            }
            fn times_one(d: $to) -> Option<$to> {
                Some(d)
            }
            #[inline(always)]
            fn quotient_of_lengths(num: $to, den: $to) -> $from {
                (num / den) as $from
            }
            #[inline(always)]
            fn quotients(
                $num: [$to; 3],
                $den: $to,
                [error, other]: [$to; 2],
            ) -> ([$from; 3], bool) {
                let is_clear = |value: $to, error: $to| value.abs() >= $clear * error;
                let are_clear = is_clear($num[0], error)
                    & is_clear($num[1], other)
                    & is_clear($num[2], other)
                    & is_clear($den, other);
                ($quotients, $divides & are_clear)
            }
            compare_quotient!($from, $to, |t| t.into());
            #[inline(always)]
            fn place<const P: usize, const E: usize>(
                points: &[[$from; 3]; P],
                extents: &[[$from; 3]; E],
            ) -> Placed<$to, P, E> {
                Placed {
                    points: convert(points, 0.0, |_, x| x.into()),
                    extents: convert(extents, 0.0, |_, x| x.into()),
                }
            }
        }
    };
}
// An `f32` computed in `f32` would be too far from the truth.
bounded_holds! { f32 => f32, false, 1.0, |_num, _den| [0.0; 3] }
// Both numbers within 2^-25 of themselves: with the last rounding less than 2 ulp.
bounded_holds! { f32 => f64, true, 33_554_432.0, |num, den| {
    [(num[0] / den) as f32, (num[1] / den) as f32, (num[2] / den) as f32]
}}
// Both within 2^-32.
bounded_holds! { f64 => f64, true, 4_294_967_296.0, |num, den| {
    [num[0] / den, num[1] / den, num[2] / den]
}}

/// Whole numbers that `f64` holds: verdicts where they are clear, and quotients
/// where it is clear to which side they round.
#[cfg(feature = "fixed")]
macro_rules! whole {
    ($($fixed:ident, $bound:ident, $raw:ty;)*) => {$(
        impl<Frac: fixed::types::extra::$bound> Holds<fixed::$fixed<Frac>> for Bounded<f64> {
            const DIVIDES: bool = false;

            #[inline(always)]
            fn fits<const K: usize>(_: &[[fixed::$fixed<Frac>; 3]; K]) -> bool {
                true
            }
            fn one() -> Option<f64> {
                Some(unit(<fixed::$fixed<Frac>>::FRAC_NBITS))
            }
            fn times_one(d: f64) -> Option<f64> {
                Some(d * unit(<fixed::$fixed<Frac>>::FRAC_NBITS))
            }
            #[inline(always)]
            fn quotient_of_lengths(_: f64, _: f64) -> fixed::$fixed<Frac> {
                fixed::$fixed::ZERO
            }
            #[inline(always)]
            fn quotients(
                num: [f64; 3],
                den: f64,
                errors: [f64; 2],
            ) -> ([fixed::$fixed<Frac>; 3], bool) {
                let unit = unit(<fixed::$fixed<Frac>>::FRAC_NBITS);
                let ([t, u, v], are_good) =
                    nearest_whole(num, den, errors, unit, <$raw>::MAX.into());
                let of = |bits: u64| fixed::$fixed::from_bits(bits as $raw);
                ([of(t), of(u), of(v)], are_good)
            }
            compare_quotient!(fixed::$fixed<Frac>, f64, |t| {
                f64::from(t.to_bits()) / unit(<fixed::$fixed<Frac>>::FRAC_NBITS)
            });
            #[inline(always)]
            fn place<const P: usize, const E: usize>(
                points: &[[fixed::$fixed<Frac>; 3]; P],
                extents: &[[fixed::$fixed<Frac>; 3]; E],
            ) -> Placed<f64, P, E> {
                Placed {
                    points: convert(points, 0.0, |_, x| x.to_bits().into()),
                    extents: convert(extents, 0.0, |_, x| x.to_bits().into()),
                }
            }
        }
    )*};
}
#[cfg(feature = "fixed")]
whole! {
    FixedI8, LeEqU8, i8;
    FixedI16, LeEqU16, i16;
    FixedI32, LeEqU32, i32;
}

/// How many units of the last place make one.
#[cfg(feature = "fixed")]
#[inline(always)]
fn unit(fraction_bits: u32) -> f64 {
    f64::from_bits((1023 + u64::from(fraction_bits)) << 52)
}

/// The three quotients times `unit`, each to the nearest whole number, in its last
/// bits; and whether all of them are, which is so if they are below `most` and not so
/// near a half that they may be wrong.
#[cfg(feature = "fixed")]
#[inline(always)]
fn nearest_whole(
    num: [f64; 3],
    den: f64,
    errors: [f64; 2],
    unit: f64,
    most: f64,
) -> ([u64; 3], bool) {
    // Adding this rounds to a whole number, in the last bits of the sum: 1.5·2^52.
    const WHOLE: f64 = 6_755_399_441_055_744.0;
    let inverse = unit / den;
    let q = [num[0] * inverse, num[1] * inverse, num[2] * inverse];
    let sums = [q[0] + WHOLE, q[1] + WHOLE, q[2] + WHOLE];
    let rest = |k: usize| (q[k] - (sums[k] - WHOLE)).abs();
    let rest = greatest(greatest(rest(0), rest(1)), rest(2));
    let largest = greatest(greatest(q[0].abs(), q[1].abs()), q[2].abs());
    // Twice what the numerators may err, twice what the divisor may, and all roundings
    // from here on.
    let doubt = inverse.abs()
        * (2.0 * greatest(errors[0], errors[1]) + largest * (2.0 * errors[1] / unit))
        + largest * (4.0 * f64::EPSILON);
    // Ordered so that a NaN is not good.
    let are_good = (rest + doubt < 0.5) & (largest < most);
    ([sums[0].to_bits(), sums[1].to_bits(), sums[2].to_bits()], are_good)
}
