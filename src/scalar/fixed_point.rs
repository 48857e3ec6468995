//! The public trait `FixedPoint`: unit normals by an integer root.

use fixed::types::extra::{LeEqU8, LeEqU16, LeEqU32, LeEqU64};
use fixed::{FixedI8, FixedI16, FixedI32, FixedI64};

use super::Scalar;
use crate::arithmetic::{Limbs, Signed, Wide, over_roots};

/// A signed fixed-point type of up to 64 bits, which has unit normals by an integer root
/// ([`unit_normal`](crate::Triangle::unit_normal)).
///
/// Sealed, like [`Scalar`], and implemented for `FixedI8`, `FixedI16`, `FixedI32` and `FixedI64`
/// with any number of fraction bits.
pub trait FixedPoint: Scalar + IntegerRoot {}

/// The integer arithmetic of a unit normal. Not exported.
pub trait IntegerRoot: Sized {
    /// The magnitude of a normal's component, in raw bits.
    type Component: Copy + Ord + Default;

    /// (b − a)·(d − c) − (f − e)·(h − g): a component of the normal, twice the area of the
    /// triangle's projection.
    fn area(ab: [Self; 2], cd: [Self; 2], ef: [Self; 2], gh: [Self; 2]) -> Signed<Self::Component>;
    /// The unit vector along `n`, each component rounded to the nearest.
    fn unit(n: [Signed<Self::Component>; 3]) -> [Self; 3];
}

// With b bits, a difference is below 2^b in magnitude, a component of the normal below 2^2b (the
// triangle lies in a cube of side 2^b), and |n|² below 3·2^4b. The shift by f ≤ b fraction bits
// makes it 5b + 5 bits: 45, 85, 165, 325.
macro_rules! fixed_point {
    ($fixed:ident, $bound:ident, $raw:ty, $area:ty, $wide:ty, |$m:ident| $square:expr) => {
        impl<Frac: $bound + Send + Sync + 'static> FixedPoint for $fixed<Frac> {}

        impl<Frac: $bound + Send + Sync + 'static> IntegerRoot for $fixed<Frac> {
            type Component = $area;

            #[inline(always)]
            fn area(ab: [Self; 2], cd: [Self; 2], ef: [Self; 2], gh: [Self; 2]) -> Signed<$area> {
                let product = |[a, b]: [Self; 2], [c, d]: [Self; 2]| {
                    let m = |x: Self, y: Self| <$area>::from(x.to_bits().abs_diff(y.to_bits()));
                    ((a > b) != (c > d), m(a, b) * m(c, d))
                };
                let ((minus, p), (minus_too, q)) = (product(ab, cd), product(ef, gh));
                if minus != minus_too {
                    Signed { negative: minus, magnitude: p + q }
                } else {
                    Signed { negative: minus != (p < q), magnitude: p.abs_diff(q) }
                }
            }
            fn unit([x, y, z]: [Signed<$area>; 3]) -> [Self; 3] {
                let square = |$m: $area| -> $wide { $square };
                let squares = [square(x.magnitude), square(y.magnitude), square(z.magnitude)];
                let [p, q, r] = over_roots(squares, Self::FRAC_NBITS);
                let signed = |negative, magnitude| {
                    Self::from_bits(match <$raw>::try_from(magnitude) {
                        Ok(x) if negative => -x,
                        Ok(x) => x,
                        Err(_) if negative => <$raw>::MIN,
                        Err(_) => <$raw>::MAX,
                    })
                };
                [signed(x.negative, p), signed(y.negative, q), signed(z.negative, r)]
            }
        }
    };
}
fixed_point!(FixedI8, LeEqU8, i8, u16, u64, |m| u64::from(m) * u64::from(m));
fixed_point!(FixedI16, LeEqU16, i16, u32, u128, |m| (u64::from(m) * u64::from(m)).into());
fixed_point!(FixedI32, LeEqU32, i32, u64, Limbs<3>, |m| {
    Limbs::new(u128::from(m) * u128::from(m), 0)
});
fixed_point!(FixedI64, LeEqU64, i64, u128, Limbs<6>, |m| {
    let (low, high) = (m & u128::from(u64::MAX), m >> 64);
    let mut mixed = Limbs::new(low * high, 1);
    mixed.double();
    Limbs::new(low * low, 0) + Limbs::new(high * high, 2) + mixed
});
