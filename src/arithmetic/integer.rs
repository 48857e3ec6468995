//! Exact integers: a system for each width of coordinates, with the narrowest types that suffice.
//!
//! Positions and extents are below 2^k, in the doubled frame of [`Arithmetic`]; sizes are below
//! 2^m, and no coordinate in the frame exceeds the size:
//!
//! | quantity | magnitude | k = 7 | k = 18 | k = 28 | k = 60 |
//! | --- | --- | --- | --- | --- | --- |
//! | edge, half-extent | 2^(k+1) | 2^8 | 2^19 | 2^29 | 2^61 |
//! | position, 2v − min − max | 2^(k+2) | 2^9 | 2^20 | 2^30 | 2^62 |
//! | normal, radius on an edge axis | 2^(2k+3) | 2^17 | 2^39 | 2^59 | 2^123 |
//! | 2p + n on an edge axis | 2^(2k+4) + 2^(2k+3) | 2^18.6 | 2^40.6 | 2^60.6 | 2^124.6 |
//! | n·v and Σ h·abs(n) | 3·2^(3k+5) | 2^27.6 | 2^60.6 | 2^90.6 | 2^186.6 |
//! | 2·d·one of a plane, with F fraction bits | 2^(k+1+F) | 2^16 | 2^51 | 2^61 | 2^125 |
//! | the same as the last but one, by size | 6·2^(3m) | | | 2^62.6 for m = 20 | 2^125.6 for m = 41 |
//! | det − u − v of ray and triangle, by size | 18·2^(3m) | | | 2^61.2 for m = 19 | 2^124.2 for m = 40 |
//! | near and far of a line, not doubled | 3·2^k | 2^8.6 | 2^19.6 | 2^29.6 | 2^61.6 |
//! | near·m, with m = abs(d), or b − a of a segment | 3·2^(2k+1) | 2^16.6 | 2^38.6 | 2^58.6 | 2^122.6 |
//! | 2·near·one, with F fraction bits | 3·2^(k+1+F) | 2^17.6 | 2^52.6 | 2^62.6 | 2^126.6 |
//!
//! | products of two areas, not doubled | 18·2^(4k+4) | 2^36.2 | 2^80.2 | 2^120.2 | 2^248.2 |
//! | product of two volumes, not doubled | 36·2^(6k+6) | 2^53.2 | 2^119.2 | 2^179.2 | 2^371.2 |
//! | the same by size | 36·2^(6m) | | | 2^125.2 for m = 20 | 2^251.2 for m = 41 |
//!
//! A type of b bits holds magnitudes below 2^(b−1). Products of four for oriented boxes take 37
//! bits for k = 7 and F up to 8: 30 products of two differences up to 2^8 and two numbers up to
//! 2^8.

use core::cmp::Ordering;

use super::big_int::BigInt;
use super::limbs::full_product;
use super::out_of_line;
use super::platform::REGISTERS_ARE_WIDE;
use super::system::Arithmetic;
use super::wide::I256;
#[cfg(feature = "fixed")]
use super::words::InRaw;
#[cfg(feature = "fixed")]
use super::words::Word;

/// For 8-bit coordinates: everything in `i32`.
#[cfg(feature = "fixed")]
#[derive(Clone, Copy, Debug)]
pub struct Int8;

/// For coordinates below 2^18: areas and volumes in `i64`.
#[derive(Clone, Copy, Debug)]
pub struct Int16;

/// [`Int16`] for lines and boxes that were checked when they were made. It holds whatever it is given.
#[cfg(feature = "fixed")]
#[derive(Clone, Copy, Debug)]
pub struct IntNear;

/// For 32-bit coordinates below 2^28: areas in `i64`, volumes in `i128`.
#[cfg(feature = "fixed")]
#[derive(Clone, Copy, Debug)]
pub struct Int32;

/// For coordinates below 2^60: areas in `i128`, volumes in 256 bits. With `LARGE` all kernels
/// share one copy of each product.
#[derive(Clone, Copy, Debug)]
pub struct Int64<const LARGE: bool = false>;

/// [`Int64`] for floats. On small cores they come here from contact alone, and flash is short.
pub type Int64OfFloats = Int64<{ !REGISTERS_ARE_WIDE }>;

/// [`Int64`] with volumes in `i128`, for sizes below 2^41.
#[derive(Clone, Copy, Debug)]
pub struct Int64Narrow;

macro_rules! integers {
    ($($system:ty $([$large:ident])?: $length:ty, $area:ty, $volume:ty, $product:expr, $quartic:ty, $of_areas:expr,
       $sextic:ty, $of_volumes:expr, $of_quartic:expr, $operand:ty; $narrow:ty, $is_narrow:expr
       $(, $short_sign:expr)?;)*) => {$(
        impl $(<const $large: bool>)? Arithmetic for $system {
            type Length = $length;
            type Area = $area;
            type Volume = $volume;
            type Quartic = $quartic;
            type Sextic = $sextic;
            type Product = $operand;
            type Narrow = $narrow;

            const CERTAIN: bool = true;
            $(const LARGE: bool = $large;)?
            const DOUBLED: bool = true;
            const CORNER_FORM_ONLY: bool = !REGISTERS_ARE_WIDE;

            #[inline(always)]
            fn area(a: $length, b: $length) -> $area {
                <$area>::from(a) * <$area>::from(b)
            }
            #[inline(always)]
            fn volume(a: $area, b: $length) -> $volume {
                $product(a, b)
            }
            #[inline(always)]
            fn quartic(a: $area, b: $area) -> $quartic {
                $of_areas(a, b)
            }
            #[inline(always)]
            fn sextic(a: $volume, b: $volume) -> $sextic {
                $of_volumes(a.into(), b.into())
            }
            #[inline(always)]
            fn sextic_of_areas(a: $quartic, b: $area) -> $sextic {
                $of_quartic(a.into(), b.into())
            }
            #[inline(always)]
            fn minor([a, b]: [$length; 2], [c, d]: [$length; 2]) -> $area {
                let minor = || Self::area(a, b) - Self::area(c, d);
                if Self::LARGE { out_of_line(minor) } else { minor() }
            }
            #[inline(always)]
            fn dot(a: &[$area; 3], b: &[$length; 3]) -> $volume {
                let dot = || {
                    Self::volume(a[0], b[0]) + Self::volume(a[1], b[1]) + Self::volume(a[2], b[2])
                };
                if Self::LARGE { out_of_line(dot) } else { dot() }
            }
            $(#[inline(always)]
            fn short_sign(a: &[$area; 3], b: &[$area; 3]) -> Option<Ordering> {
                $short_sign(a, b)
            })?
            #[inline(always)]
            fn operand(a: $length) -> $operand {
                a.into()
            }
            #[inline(always)]
            fn widened(narrow: <$narrow as Arithmetic>::Volume) -> $volume {
                narrow.into()
            }
            #[inline(always)]
            fn is_narrow(size: $length) -> bool {
                !Self::LARGE && $is_narrow(size)
            }
        }
    )*};
}
#[cfg(feature = "fixed")]
integers! {
    Int8: i32, i32, i32, |a, b| a * b, i64, |a, b| i64::from(a) * i64::from(b), i64,
        |a: i64, b: i64| a * b, |a: i64, b: i64| a * b, i64; Self, |_: i32| false;
    Int32: i32, i64, i128, |a, b| i128::from(a) * i128::from(b), i128, of_four, I256, I256::of_two,
        I256::of_two, i128; Int16, |size: i32| !REGISTERS_ARE_WIDE && size >> 20 == 0;
    IntNear: i32, i64, i64, |a, b| a * i64::from(b), i128, of_four, i128, of_four,
        of_four_and_two, i128; Self, |_: i32| false;
}
integers! {
    Int16: i32, i64, i64, |a, b| a * i64::from(b), i128, of_four, i128, of_four,
        of_four_and_two, i128; Self, |_: i32| false, short_sign;
    Int64<LARGE> [LARGE]: i64, i128, I256, I256::product, I256, of_four_wide, BigInt<6>, of_six, of_six,
        i128; Int64Narrow, |size: i64| size >> 41 == 0;
    Int64Narrow: i64, i128, i128, |a, b| a * i128::from(b), I256, of_four_wide, BigInt<6>, of_six,
        of_six, i128; Self, |_: i64| false;
}

/// The sign of a·b, if both are cross products of vectors below 2^20 and short products suffice.
#[inline(always)]
fn short_sign(a: &[i64; 3], b: &[i64; 3]) -> Option<Ordering> {
    if REGISTERS_ARE_WIDE { None } else { sign_by_short_products(a, b) }
}

/// Components are below 2^41. Cut to multiples of 2^27, one is too low by less than one: A + α with
/// 0 ≤ α < 1. Then (A + α)·(B + β) differs from A·B by less than abs(A) + abs(B) + 1, and the sum of
/// three products is at most 3·2^28. If that leaves a doubt, components below 2^30 have products of
/// 60 bits.
#[inline(never)]
fn sign_by_short_products(a: &[i64; 3], b: &[i64; 3]) -> Option<Ordering> {
    let (mut sum, mut error) = (0, 3);
    for (a, b) in a.iter().zip(b) {
        let (a, b) = ((a >> 27) as i32, (b >> 27) as i32);
        sum += a * b;
        error += a.abs() + b.abs();
    }
    if sum.abs() >= error {
        return Some(sum.cmp(&0));
    }
    // A number below zero is folded to one less than its magnitude.
    let are_short = a.iter().chain(b).fold(0, |bits, x| bits | (x ^ x >> 63)) >> 30 == 0;
    are_short.then(|| (a[0] * b[0] + a[1] * b[1] + a[2] * b[2]).cmp(&0))
}

/// The product of two numbers of 64 bits: with narrow registers four products of words.
#[inline(always)]
pub(crate) fn of_four(a: i64, b: i64) -> i128 {
    if REGISTERS_ARE_WIDE { i128::from(a) * i128::from(b) } else { by_words(a, b) }
}

#[inline(never)]
fn by_words(a: i64, b: i64) -> i128 {
    let product = full_product(a.unsigned_abs(), b.unsigned_abs()) as i128;
    if (a ^ b) < 0 { -product } else { product }
}

/// A product of four lengths times an area.
#[inline(always)]
fn of_four_and_two(a: i128, b: i64) -> i128 {
    if REGISTERS_ARE_WIDE { a * i128::from(b) } else { by_words_and_two(a, b) }
}

#[inline(never)]
fn by_words_and_two(a: i128, b: i64) -> i128 {
    let (magnitude, other) = (a.unsigned_abs(), b.unsigned_abs());
    // The upper half is short, and the product fits.
    let high = ((magnitude >> 64) as u64).wrapping_mul(other);
    let low = full_product(magnitude as u64, other);
    let product = low.wrapping_add(u128::from(high) << 64) as i128;
    if (a < 0) == (b < 0) { product } else { -product }
}

/// The product of two areas of 64-bit coordinates.
#[inline(never)]
fn of_four_wide(a: i128, b: i128) -> I256 {
    I256::of_two(a, b)
}

/// The product of two volumes of 64-bit coordinates.
#[inline(never)]
fn of_six(a: I256, b: I256) -> BigInt<6> {
    let ((is_negative, a), (is_other_negative, b)) = (a.limbs(), b.limbs());
    let product = BigInt(a).times(&BigInt(b));
    if is_negative == is_other_negative { product } else { -product }
}

/// Whether all coordinates lie below two to the `most`.
#[cfg(feature = "fixed")]
#[inline(always)]
pub(super) fn below<S: InRaw>(coordinates: &[S], most: u32) -> bool {
    // A number below zero is folded to one less than its magnitude.
    coordinates.iter().fold(S::Raw::ZERO, |size, x| size | x.raw().folded()) >> most == S::Raw::ZERO
}

#[cfg(test)]
mod tests {
    use super::{by_words, by_words_and_two, sign_by_short_products};
    use crate::arithmetic::Each;

    #[test]
    fn signs_of_short_products_are_signs() {
        let most = (1_i64 << 41) - 1;
        let numbers = [-most, -1 << 30, (-1 << 27) - 1, -1, 0, 1, (1 << 27) - 1, 1 << 36, most];
        let vectors = || (0..729).map(|k| [k % 9, k / 9 % 9, k / 81].each(|k| numbers[k]));
        let mut known = 0;
        for (a, b) in vectors().flat_map(|a| vectors().map(move |b| (a, b))) {
            let exact: i128 = a.iter().zip(&b).map(|(&a, &b)| i128::from(a) * i128::from(b)).sum();
            if let Some(sign) = sign_by_short_products(&a, &b) {
                known += 1;
                assert_eq!(sign, exact.cmp(&0), "{a:?} {b:?}");
            }
        }
        assert!(known > 729 * 729 / 2, "{known}");
    }

    #[test]
    fn products_by_words_are_products() {
        let words = [0, 1, 2, 0xffff, 0x1_0000, 0x8000_0001, 0xfff0_ffff, u32::MAX];
        let both = |a: u32, b: u32| (u64::from(a) << 32 | u64::from(b)) as i64;
        let longs = || words.iter().flat_map(|&a| words.map(|b| both(a, b)));
        for (a, b) in longs().flat_map(|a| longs().map(move |b| (a, b))) {
            assert_eq!(by_words(a, b), i128::from(a) * i128::from(b), "{a} {b}");
            let c = i128::from(a) << 30 | 0x2bad_c0de;
            assert_eq!(by_words_and_two(c, b >> 32), c * i128::from(b >> 32), "{c} {b}");
        }
    }
}
