//! Floats as they are, with a bound on their error.

use core::cmp::Ordering;
use core::marker::PhantomData;

use super::float::Float;
use super::number::{greatest, least};
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
        let (low, high) = (least(least(a, b), c), greatest(greatest(a, b), c));
        (low > F::REACH.0 && high < F::REACH.1)
            .then(|| F::from(roundoffs) * F::ROUNDOFF * (a * b * c))
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

macro_rules! bounded_holds {
    ($($from:ty => $to:ty, $clear:expr $(, $quotients:item)?;)*) => {$(
        impl Holds<$from> for Bounded<$to> {
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
            fn quotient(num: $to, den: $to) -> $from {
                (num / den) as $from
            }
            $($quotients)?
            #[inline(always)]
            fn quotient_of_lengths(num: $to, den: $to) -> $from {
                (num / den) as $from
            }
            #[inline(always)]
            fn compare_quotient(
                num: $to,
                den: $to,
                [num_error, den_error]: [$to; 2],
                t: $from,
            ) -> Option<Ordering> {
                let t: $to = t.into();
                let product = t * den;
                // Twice what the operands may err, and twice the rounding of the
                // product; that of the gap is a trifle against the former.
                let error = 2.0 * (num_error + t.abs() * den_error)
                    + 2.0 * <$to>::ROUNDOFF * product.abs();
                let gap = num - product;
                if gap.abs() > error && product.abs() < <$to>::INFINITY {
                    gap.partial_cmp(&0.0)
                } else {
                    None
                }
            }
            #[inline(always)]
            fn resolves(value: $to, error: $to) -> bool {
                value.abs() >= $clear * error
            }
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
    )*};
}
// Quotients must be good to 2^-26 for an `f32`, to 2^-31 for an `f64`; an `f32`
// computed in `f32` is never.
bounded_holds! {
    f32 => f32, f32::INFINITY;
    f32 => f64, TWO_TO_THE_27,
        // One division is cheaper than three, and rounds no more than f64 can spare.
        #[inline(always)]
        fn quotients(num: [f64; 3], den: f64) -> [f32; 3] {
            let inverse = 1.0 / den;
            [(num[0] * inverse) as f32, (num[1] * inverse) as f32, (num[2] * inverse) as f32]
        };
    f64 => f64, TWO_TO_THE_32;
}

const TWO_TO_THE_27: f64 = 134_217_728.0;
const TWO_TO_THE_32: f64 = 4_294_967_296.0;
