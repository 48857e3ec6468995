//! `f32` and `f64`: computed as they are, with a bound on the error.

use core::marker::PhantomData;
use core::ops::Mul;

use super::integer::Int64;
use super::ladder::{Predicate, rung, wide_integers};
use super::number::{Number, greatest};
use super::numbers::{Holds, Numbers, Placed, convert};
use super::sum::{Parts, Sum};
use super::{Scalar, sealed};

/// A binary floating-point type of IEEE 754.
pub trait Float: Number + Mul<Output = Self> + From<u8> + From<u16> + 'static {
    /// One half.
    const HALF: Self;
    /// u: half the distance from 1 to the next number.
    const ROUNDOFF: Self;
    /// Products of three lengths, the greatest of them in this range, and of those
    /// with axes between one and four long, neither overflow nor lose more to
    /// underflow than the bounds have to spare.
    const REACH: (Self, Self);
}

// f32: an underflow costs at most 2^-150 an operation. The bounds have 1 (areas)
// and 4 (volumes) times u·r² and u·r³ to spare (robust::bounds), against about 10
// and 12·r + 6 underflows: enough from r = 2^-40 on. Above, r³·24 stays below 2^128
// up to r = 2^41.
impl Float for f32 {
    const HALF: f32 = 0.5;
    const ROUNDOFF: f32 = f32::EPSILON / 2.0;
    const REACH: (f32, f32) = (f32::from_bits((127 - 32) << 23), f32::from_bits((127 + 40) << 23));
}

// f64: likewise 2^-53·r² and 4·2^-53·r³ against 2^-1075, and r³·24 below 2^1024. A
// nonzero number that was an f32 is always inside.
impl Float for f64 {
    const HALF: f64 = 0.5;
    const ROUNDOFF: f64 = f64::EPSILON / 2.0;
    const REACH: (f64, f64) =
        (f64::from_bits((1023 - 320) << 52), f64::from_bits((1023 + 320) << 52));
}

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
    ($($from:ty => $to:ty;)*) => {$(
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
bounded_holds! { f32 => f32; f32 => f64; f64 => f64; }

/// The exponents of the lowest and highest bit of any coordinate, as powers of
/// two in units of the least number; `None` if all are nought.
fn span<S: Scalar>(all: [&[[S; 3]]; 2]) -> Option<(i32, i32)> {
    let mut span = None;
    for x in all.into_iter().flatten().flatten() {
        let Parts { magnitude, shift, .. } = x.parts();
        if magnitude != 0 {
            let low = i32::from(shift) + magnitude.trailing_zeros() as i32;
            let high = i32::from(shift) + 64 - magnitude.leading_zeros() as i32;
            let (l, h) = span.unwrap_or((low, high));
            span = Some((low.min(l), high.max(h)));
        }
    }
    span
}

/// `x` in units of two to the power `low`; the unit divides `x`.
fn in_units<S: Scalar>(x: S, low: i32) -> i64 {
    let Parts { negative, magnitude, shift } = x.parts();
    let up = i32::from(shift) - low;
    // Nought may have any exponent; nothing else shifts by more than 60.
    let whole = if magnitude == 0 {
        0
    } else if up >= 0 {
        magnitude.wrapping_shl(up as u32)
    } else {
        magnitude.wrapping_shr(up.unsigned_abs())
    } as i64;
    if negative { -whole } else { whole }
}

/// Floats as whole multiples of one power of two, if 60 bits hold them all:
/// grids, and most scenes that were once in a coarser format. One has no place
/// among them: the unit is the scene's, not the scalar's.
impl<S: Scalar + Float> Holds<S> for Int64 {
    fn fits<const K: usize>(coordinates: &[[S; 3]; K]) -> bool {
        span([coordinates, &[]]).is_none_or(|(low, high)| high - low <= 60)
    }

    fn place<const P: usize, const E: usize>(
        points: &[[S; 3]; P],
        extents: &[[S; 3]; E],
    ) -> Placed<i64, P, E> {
        let (low, _) = span([points, extents]).unwrap_or_default();
        Placed {
            points: convert(points, 0, |_, x| in_units(x, low)),
            extents: convert(extents, 0, |_, x| in_units(x, low)),
        }
    }
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
    fn decide<P: Predicate<Self>>(p: &P) -> bool {
        rung::<_, Bounded<f32>, _>(p, doubled)
    }
}

/// The second rung of `f32`: the same code in `f64`.
#[cold]
#[inline(never)]
fn doubled<P: Predicate<f32>>(p: &P) -> bool {
    rung::<_, Bounded<f64>, _>(p, wide_integers)
}

impl Scalar for f64 {
    plain!();

    const ONE: Parts = Parts { negative: false, magnitude: 1, shift: 1074 };
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
    fn decide<P: Predicate<Self>>(p: &P) -> bool {
        rung::<_, Bounded<f64>, _>(p, wide_integers)
    }
}
