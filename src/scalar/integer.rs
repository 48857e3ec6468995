//! Exact integers: for each width of coordinates a system with the narrowest
//! types that hold.
//!
//! With positions and extents below 2^k, in the doubled frame of [`Numbers`],
//! and with a reach below 2^m (no coordinate in the frame exceeds the reach):
//!
//! | quantity | magnitude | k = 7 | k = 18 | k = 28 | k = 60 |
//! | --- | --- | --- | --- | --- | --- |
//! | edge, half-extent | 2^(k+1) | 2^8 | 2^19 | 2^29 | 2^61 |
//! | position, 2v − min − max | 2^(k+2) | 2^9 | 2^20 | 2^30 | 2^62 |
//! | normal, radius on an edge axis | 2^(2k+3) | 2^17 | 2^39 | 2^59 | 2^123 |
//! | 2p + n on an edge axis | 2^(2k+4) + 2^(2k+3) | 2^18.6 | 2^40.6 | 2^60.6 | 2^124.6 |
//! | n·v and Σ h·abs(n) | 3·2^(3k+5) | 2^27.6 | 2^60.6 | 2^90.6 | 2^186.6 |
//! | 2·d·one of a plane, with F fraction bits | 2^(k+1+F) | 2^16 | 2^51 | 2^61 | 2^125 |
//! | the same as the last but one, by reach | 6·2^(3m) | | | 2^62.6 for m = 20 | 2^125.6 for m = 41 |
//! | near and far of a line, not doubled | 3·2^k | 2^8.6 | 2^19.6 | 2^29.6 | 2^61.6 |
//! | near·m, with m = abs(d), or b − a of a segment | 3·2^(2k+1) | 2^16.6 | 2^38.6 | 2^58.6 | 2^122.6 |
//! | 2·near·one, with F fraction bits | 3·2^(k+1+F) | 2^17.6 | 2^52.6 | 2^62.6 | 2^126.6 |
//!
//! A type of b bits holds magnitudes below 2^(b−1).

use super::ladder::FEW_RUNGS;
use super::number::Number;
use super::numbers::Numbers;
use super::wide::I256;

/// For 8-bit coordinates: everything in `i32`.
#[cfg(feature = "fixed")]
#[derive(Clone, Copy, Debug)]
pub struct Int8;

/// For coordinates below 2^18: areas and volumes in `i64`.
#[cfg(feature = "fixed")]
#[derive(Clone, Copy, Debug)]
pub struct Int16;

/// For 32-bit coordinates below 2^28: areas in `i64`, volumes in `i128`.
#[cfg(feature = "fixed")]
#[derive(Clone, Copy, Debug)]
pub struct Int32;

/// For coordinates below 2^60: areas in `i128`, volumes in 256 bits.
#[derive(Clone, Copy, Debug)]
pub struct Int64;

/// [`Int64`] with volumes in `i128`, for a reach below 2^41.
#[derive(Clone, Copy, Debug)]
pub struct Int64Slim;

/// Whether registers hold 64 bits. Then small coordinates have a kernel of their
/// own; elsewhere code is dearer than time, and one kernel chooses the width of
/// its volumes. Neither changes an answer; `--cfg septum_narrow` tests the other one
/// on a wide machine.
pub(super) const REGISTERS_ARE_WIDE: bool =
    cfg!(all(any(target_pointer_width = "64", target_arch = "wasm32"), not(septum_narrow)))
        && !FEW_RUNGS;

macro_rules! integers {
    ($($system:ty: $length:ty, $area:ty, $volume:ty, $product:expr; $slim:ty, $is_slim:expr;)*) => {$(
        impl Numbers for $system {
            type Length = $length;
            type Area = $area;
            type Volume = $volume;
            type Slim = $slim;

            const FINAL: bool = true;
            const ONE_FORM: bool = !REGISTERS_ARE_WIDE;

            #[inline(always)]
            fn area(a: Self::Length, b: Self::Length) -> $area {
                <$area>::from(a) * <$area>::from(b)
            }
            #[inline(always)]
            fn volume(a: $area, b: Self::Length) -> $volume {
                $product(a, b)
            }
            #[inline(always)]
            fn from_center(v: Self::Length, center: Self::Length) -> Self::Length {
                let d = v - center;
                d + d
            }
            #[inline(always)]
            fn from_corners(v: Self::Length, min: Self::Length, max: Self::Length) -> Self::Length {
                (v - min) + (v - max)
            }
            #[inline(always)]
            fn half_extent(half: Self::Length) -> Self::Length {
                half + half
            }
            #[inline(always)]
            fn half_between(min: Self::Length, max: Self::Length) -> Self::Length {
                max - min
            }
            #[inline(always)]
            fn middle(n: $area) -> $area {
                n
            }
            type Product = i128;
            #[inline(always)]
            fn operand(a: $length) -> i128 {
                a.into()
            }
            // Sums of at most 30 products of four operands up to 2^30.
            #[inline(always)]
            fn product_bounds(axes: i128, length: i128, half: i128, _: [u16; 3]) -> Option<[i128; 3]> {
                let most = axes.max(length).max(half);
                (most <= 1 << 30).then_some([0; 3])
            }
            #[inline(always)]
            fn area_bound(_: $length, _: $length, _: $area, _: u8) -> Option<$area> {
                Some(<$area as Number>::ZERO)
            }
            #[inline(always)]
            fn volume_bound(_: $length, _: $length, _: $length, _: u8) -> Option<$volume> {
                Some(<$volume as Number>::ZERO)
            }
            #[inline(always)]
            fn length_error(_: $length, _: u8) -> $length {
                0
            }
            #[inline(always)]
            fn area_error(_: $area, _: u8) -> $area {
                0
            }
            #[inline(always)]
            fn widened(slim: <$slim as Numbers>::Volume) -> $volume {
                slim.into()
            }
            #[inline(always)]
            fn is_slim(reach: Self::Length) -> bool {
                $is_slim(reach)
            }
            #[inline(always)]
            fn bounds(_: Self::Length, _: u8, _: u8) -> Option<($area, $volume)> {
                Some((<$area as Number>::ZERO, <$volume as Number>::ZERO))
            }
        }
    )*};
}
#[cfg(feature = "fixed")]
integers! {
    Int8: i32, i32, i32, |a, b| a * b; Self, |_: i32| false;
    Int16: i32, i64, i64, |a, b| a * i64::from(b); Self, |_: i32| false;
    Int32: i32, i64, i128, |a, b| i128::from(a) * i128::from(b); Int16, |reach: i32| !REGISTERS_ARE_WIDE && reach >> 20 == 0;
}
integers! {
    Int64: i64, i128, I256, I256::product; Int64Slim, |reach: i64| reach >> 41 == 0;
    Int64Slim: i64, i128, i128, |a, b| a * i128::from(b); Self, |_: i64| false;
}

/// Whether all coordinates lie below two to the `most`.
#[cfg(feature = "fixed")]
macro_rules! below {
    ($name:ident: $raw:ty) => {
        #[inline(always)]
        pub(super) fn $name(coordinates: impl Iterator<Item = $raw>, most: u32) -> bool {
            // For x below nought, !x: one less than the magnitude.
            coordinates.fold(0, |size, x| size | (x ^ (x >> (<$raw>::BITS - 1)))) >> most == 0
        }
    };
}
#[cfg(feature = "fixed")]
below! { below_i32: i32 }
#[cfg(feature = "fixed")]
below! { below_i64: i64 }
