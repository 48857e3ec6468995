//! The axes of a rotated frame, in each scalar.

use core::ops::{Add, Neg, Sub};

use crate::arithmetic::{Each, cos_sin_f64};
#[cfg(feature = "fixed")]
use crate::arithmetic::{cos_sin_30, cos_sin_62};

/// The arithmetic of rotations that an oriented box requires of a scalar.
pub(crate) trait Rotation: Copy {
    /// Whether the type holds vectors of length one.
    const HAS_UNIT_VECTORS: bool;

    /// Whether rounding a rotation always leaves dot products of axes within one eighth of the
    /// exact ones.
    const KEEPS_FRAMES: bool;

    /// The coordinate axes rotated by the quaternion x, y, z, w; `None` if its square differs from
    /// 1 by more than a quarter.
    fn by_quaternion(quaternion: [Self; 4]) -> Option<[[Self; 3]; 3]>;

    /// The coordinate axes rotated about x, then y, then z.
    fn by_turns(turns: [Self; 3]) -> [[Self; 3]; 3];
}

/// The coordinate axes rotated about x, y and z, given the cosines and sines.
#[inline(always)]
fn turned<T>([(cx, sx), (cy, sy), (cz, sz)]: [(T, T); 3], times: fn(T, T) -> T) -> [[T; 3]; 3]
where
    T: Copy + Add<Output = T> + Sub<Output = T> + Neg<Output = T>,
{
    let (cz_sy, sz_sy) = (times(cz, sy), times(sz, sy));
    [
        [times(cz, cy), times(sz, cy), -sy],
        [times(cz_sy, sx) - times(sz, cx), times(sz_sy, sx) + times(cz, cx), times(cy, sx)],
        [times(cz_sy, cx) + times(sz, sx), times(sz_sy, cx) - times(cz, sx), times(cy, cx)],
    ]
}

/// The axes of a quaternion's rotation, multiplied by the quaternion's square.
#[inline(always)]
fn by_products<T>(q: [T; 4], times: impl Fn(T, T) -> T) -> [[T; 3]; 3]
where
    T: Copy + Add<Output = T> + Sub<Output = T>,
{
    let [x, y, z, w] = q;
    let [xx, yy, zz, ww] = q.each(|x| times(x, x));
    let twice = |x: T| x + x;
    let (xy, zw) = (times(x, y), times(z, w));
    let (xz, yw) = (times(x, z), times(y, w));
    let (yz, xw) = (times(y, z), times(x, w));
    [
        [(xx + ww) - (yy + zz), twice(xy + zw), twice(xz - yw)],
        [twice(xy - zw), (yy + ww) - (xx + zz), twice(yz + xw)],
        [twice(xz + yw), twice(yz - xw), (zz + ww) - (xx + yy)],
    ]
}

/// The axes of a quaternion's rotation, in `f64`, with errors below 7 roundoffs of 2^-53.
///
/// Let N be the square of the quaternion. N is a sum at most three operations deep, and errs by a
/// relative 3 roundoffs. A diagonal component is a difference of two sums that err by 2 each,
/// together 2·N, plus its own rounding 1. An off-diagonal component errs by at most 1·N for
/// products and sum. The quotient adds 1, and the 3 of N: below 7 for |component| ≤ 1, to first
/// order.
#[inline(never)] // On s390x: see `axes::faces_in_double`.
fn by_quaternion_f64(q: [f64; 4]) -> Option<[[f64; 3]; 3]> {
    let [x, y, z, w] = q.each(|x| x * x);
    let square = (x + w) + (y + z);
    // Zero plus a number is never −0.
    let over = |row: [f64; 3]| row.each(|n| 0.0 + n / square);
    ((square - 1.0).abs() <= 0.25).then(|| by_products(q, |a, b| a * b).each(over))
}

/// The rotated axes in `f64`, with errors of at most 24 roundoffs of 2^-53: cosines and sines err
/// by 4, a product of two by 4 + 4 + 1, a product of three by 9 + 4 + 1, and the sum of both by 14
/// + 9 + 1.
fn by_turns_f64(turns: [f64; 3]) -> [[f64; 3]; 3] {
    turned(turns.each(cos_sin_f64), |a, b| a * b).each(|row| row.each(|x| 0.0 + x))
}

macro_rules! float {
    ($($float:ident)*) => {$(
        impl Rotation for $float {
            const HAS_UNIT_VECTORS: bool = true;
            const KEEPS_FRAMES: bool = true;

            fn by_quaternion(quaternion: [Self; 4]) -> Option<[[Self; 3]; 3]> {
                let axes = by_quaternion_f64(quaternion.each(f64::from))?;
                Some(axes.each(|row| row.each(|x| x as Self)))
            }

            fn by_turns(turns: [Self; 3]) -> [[Self; 3]; 3] {
                by_turns_f64(turns.each(f64::from)).each(|row| row.each(|x| x as Self))
            }
        }
    )*};
}
float! { f32 f64 }

/// n/d to the nearest multiple of 2^-`bits`, for n ≤ d. The top bit of `d` must be free.
#[cfg(feature = "fixed")]
#[inline(always)]
fn quotient<T>(n: T, d: T, bits: u32) -> T
where
    T: Copy + Ord + Add<Output = T> + Sub<Output = T> + From<bool>,
{
    let (mut rest, mut quotient) = (n, T::from(n >= d));
    if n >= d {
        rest = rest - d;
    }
    for _ in 0..bits {
        (rest, quotient) = (rest + rest, quotient + quotient);
        if rest >= d {
            (rest, quotient) = (rest - d, quotient + T::from(true));
        }
    }
    quotient + T::from(rest >= d - rest)
}

/// For each type, words for the squares of its raw bits, and unsigned words for the sum of four.
///
/// Quaternions: a component is a quotient of integers of at most 5/4 · 2^2F, with F fraction bits.
/// F is below the width of the type, so twice that fits its word, and the only error is the
/// rounding of the quotient.
///
/// Turns: errors before the last rounding, in units of 2^-30 or 2^-62. Cosines and sines err by 4,
/// a product of two by 4 + 4 + 1/2, a product of three by 8.5 + 4 + 1/2, and the sum of both by
/// 21.5 units: below 2^-25 or 2^-57.
#[cfg(feature = "fixed")]
macro_rules! fixed {
    ($($fixed:ident, $bound:ident, $int:ident, $uint:ident;)*) => {$(
        impl<Frac: fixed::types::extra::$bound> Rotation for fixed::$fixed<Frac> {
            const HAS_UNIT_VECTORS: bool = Self::INT_NBITS > 0;
            // A component is off by h = 2^-(F + 1), and 2^-25 more at most, so a dot product is off
            // by 2√3·h + 3·h², which is 0.112 for F = 4.
            const KEEPS_FRAMES: bool = Self::FRAC_NBITS >= 4;

            fn by_quaternion(quaternion: [Self; 4]) -> Option<[[Self; 3]; 3]> {
                let q = quaternion.each(|x| $int::from(x.to_bits()));
                let [x, y, z, w] = q.each(|x| x.unsigned_abs() * x.unsigned_abs());
                let square = x.checked_add(y)?.checked_add(z)?.checked_add(w)?;
                let one: $uint = 1 << (2 * Self::FRAC_NBITS);
                if square.abs_diff(one) > one >> 2 {
                    return None;
                }
                let mut axes = [[Self::ZERO; 3]; 3];
                for (axis, products) in axes.iter_mut().zip(by_products(q, |a, b| a * b)) {
                    for (to, n) in axis.iter_mut().zip(products) {
                        let size = quotient(n.unsigned_abs(), square, Self::FRAC_NBITS) as $int;
                        // The number 1 may lie just beyond the type.
                        *to = clamped!(if n < 0 { -size } else { size });
                    }
                }
                Some(axes)
            }

            fn by_turns(turns: [Self; 3]) -> [[Self; 3]; 3] {
                if Self::FRAC_NBITS <= 16 {
                    let circle = |x: Self| {
                        let part = (x.to_bits() as u32).checked_shl(32 - Self::FRAC_NBITS);
                        cos_sin_30(part.unwrap_or(0))
                    };
                    let times = |a, b| ((i64::from(a) * i64::from(b) + (1 << 29)) >> 30) as i32;
                    turned(turns.each(circle), times).each(|axis| axis.each(|x| {
                        let shift = 30 - Self::FRAC_NBITS;
                        clamped!((x + (1 << (shift - 1))) >> shift)
                    }))
                } else {
                    let circle = |x: Self| {
                        let part = (x.to_bits() as u64).checked_shl(64 - Self::FRAC_NBITS);
                        cos_sin_62(part.unwrap_or(0))
                    };
                    let times = |a, b| ((i128::from(a) * i128::from(b) + (1 << 61)) >> 62) as i64;
                    turned(turns.each(circle), times).each(|axis| axis.each(|x| {
                        let half = (1 << 62 >> Self::FRAC_NBITS) / 2;
                        let places = 62 - Self::FRAC_NBITS as i32;
                        let x = i128::from(x) + half;
                        clamped!(if places < 0 { x << -places } else { x >> places })
                    }))
                }
            }
        }
    )*};
}

/// A number from its raw bits, clamped to the range of the type.
#[cfg(feature = "fixed")]
macro_rules! clamped {
    ($bits:expr) => {{
        let bits = $bits;
        match bits.try_into() {
            Ok(bits) => Self::from_bits(bits),
            Err(_) if bits < 0 => Self::MIN,
            Err(_) => Self::MAX,
        }
    }};
}
#[cfg(feature = "fixed")]
fixed! {
    FixedI8, LeEqU8, i32, u32;
    FixedI16, LeEqU16, i32, u32;
    FixedI32, LeEqU32, i64, u64;
    FixedI64, LeEqU64, i128, u128;
}
