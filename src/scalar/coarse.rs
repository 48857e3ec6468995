//! A quick system for wide fixed point, whose "disjoint" can be trusted.

use super::integer::Int16;
use super::numbers::{Numbers, Placed, convert};

/// The arithmetic of [`Int16`] on coordinates shifted down until they fit it,
/// with the box grown by what the shift lost.
#[derive(Clone, Copy, Debug)]
pub struct Coarse;

type Length = <Int16 as Numbers>::Length;
type Area = <Int16 as Numbers>::Area;
type Volume = <Int16 as Numbers>::Volume;

impl Numbers for Coarse {
    type Length = Length;
    type Area = Area;
    type Volume = Volume;
    type Slim = Self;

    const FINAL: bool = true;
    const ONE_FORM: bool = Int16::ONE_FORM;

    #[inline(always)]
    fn area(a: Length, b: Length) -> Area {
        Int16::area(a, b)
    }
    #[inline(always)]
    fn volume(a: Area, b: Length) -> Volume {
        Int16::volume(a, b)
    }
    #[inline(always)]
    fn from_center(v: Length, center: Length) -> Length {
        Int16::from_center(v, center)
    }
    #[inline(always)]
    fn from_corners(v: Length, min: Length, max: Length) -> Length {
        Int16::from_corners(v, min, max)
    }
    #[inline(always)]
    fn half_extent(half: Length) -> Length {
        Int16::half_extent(half)
    }
    #[inline(always)]
    fn half_between(min: Length, max: Length) -> Length {
        Int16::half_between(min, max)
    }
    #[inline(always)]
    fn middle(n: Area) -> Area {
        Int16::middle(n)
    }
    type Product = <Int16 as Numbers>::Product;
    fn operand(a: Length) -> Self::Product {
        Int16::operand(a)
    }
    #[inline(always)]
    fn length_error(_: Length, _: u8) -> Length {
        0
    }
    #[inline(always)]
    fn area_error(_: Area, _: u8) -> Area {
        0
    }
    #[inline(always)]
    fn widened(slim: Volume) -> Volume {
        slim
    }
    #[inline(always)]
    fn is_slim(_: Length) -> bool {
        false
    }
    #[inline(always)]
    fn bounds(reach: Length, areas: u8, volumes: u8) -> Option<(Area, Volume)> {
        Int16::bounds(reach, areas, volumes)
    }
}

/// Places raw integers relative to the first point and shifted down until they
/// lie below two to the 18; that keeps volumes below 2^61 (see `integer`).
///
/// A shift takes a vertex v to w with v − 1 < w <= v, in units of the shift, so
/// a point of the triangle moves by as much; the corners of a box move likewise
/// and a half-extent loses less than one. What met, meets still in a box that is
/// two units larger each way.
macro_rules! coarse {
    ($name:ident: $raw:ty => $wide:ty) => {
        impl Coarse {
            #[inline(always)]
            pub(super) fn $name<const P: usize, const E: usize>(
                points: &[[$raw; 3]; P],
                extents: &[[$raw; 3]; E],
            ) -> Placed<Length, P, E> {
                let origin = points.first().copied().unwrap_or_default();
                let mut size: $wide = 0;
                let mut measure = |x: $wide| {
                    size |= x ^ (x >> (<$wide>::BITS - 1));
                    x
                };
                let near =
                    convert(points, 0, |i, x| measure(<$wide>::from(x) - <$wide>::from(origin[i])));
                let extents = convert(extents, 0, |_, x| measure(x.into()));
                let shift = (<$wide>::BITS - size.leading_zeros()).saturating_sub(18);
                let grown = if shift > 0 { 2 } else { 0 };
                Placed {
                    points: convert(&near, 0, |_, x| (x >> shift) as i32),
                    extents: convert(&extents, 0, |_, x| (x >> shift) as i32 + grown),
                }
            }
        }
    };
}
coarse! { coarse_i32: i32 => i64 }
coarse! { coarse_i64: i64 => i128 }
