//! The conservative test for 64-bit scalars: coordinates are truncated to 18 bits, and the box
//! grows by the possible loss. Its "disjoint" is certain.
//!
//! All coordinates are taken relative to the first vertex and shifted right until they are below
//! 2^18, which keeps volumes below 2^61 (see `arithmetic::integer`).
//!
//! In units of the shift, a coordinate v becomes w with v − 1 < w <= v. So a point of the triangle
//! moves by less than one unit, the corners of a box likewise, and a half-extent loses less than
//! one. Shapes that met still meet if the box is two units larger on each side. (This is for
//! half-extents; a full extent would have to grow by four.)
//!
//! # The shortcut by vectors
//!
//! With vectors, most pairs need no truncation. Shapes that certainly meet also meet in the larger
//! box, and a gap that is wide enough survives the truncation. Let R be the size of the pair: the
//! greatest sum of half-extent and extent of the triangle on an axis.
//!
//! * If no face separates by R/512, the truncated lengths are below 2.01·R, so a unit is at most
//!   2⁻¹⁸·2·2.01·R = 2^-15.99·R. If a face separates by G, they are below 2.01·R + G, and a unit is
//!   at most 2^-15.99·R + 2⁻¹⁷·G. G shrinks by less than four units, which is less than G.
//! * In the frame of the box a vertex and an edge change by at most one unit, and a half-extent
//!   grows by 2.5. |v|, |e| and h are at most 1.01·R. On an edge axis p changes by 4 units of R,
//!   half the normal by 2 and its magnitude by 2, the radius by 2.5·2 + 2 = 7: 15, and their
//!   squares.
//! * On the normal, n·v changes by 3·(4 + 2) = 18 units of R², and Σ h·|n| by 3·(2.5·2 + 4) = 27:
//!   45, and their squares. That is at most 2^-10.4·R³, and R³/512 is greater by a factor of 2.6.

use super::frame::{BoxForm, Frame};
use super::kernel::any_axis;
use super::offsets;
use crate::arithmetic::{InRaw, Int16};
use crate::query::obb_short::raw;
use crate::scalar::Scalar;
use crate::shape::{Aabb, Triangle, Vec3};

/// The bits of a truncated coordinate, without its sign.
const BITS: u32 = 18;

/// `true` only if the shapes are disjoint.
#[inline(always)]
pub(super) fn disjoint<S: Scalar + InRaw>(triangle: &Triangle<S>, aabb: &Aabb<S>) -> bool {
    if S::IN_QUADS {
        return match offsets::pair(triangle, aabb, offsets::coarsely_apart) {
            Ok(apart) => apart,
            // By value, for the reason given in `overlaps`.
            Err(_) => disjoint_in_doubt(triangle, *aabb),
        };
    }
    disjoint_when_cut_down(triangle, aabb)
}

#[cold]
#[inline(never)]
fn disjoint_in_doubt<S: Scalar + InRaw>(triangle: &Triangle<S>, aabb: Aabb<S>) -> bool {
    disjoint_when_cut_down(triangle, &aabb)
}

#[inline(always)]
pub(super) fn disjoint_when_cut_down<S: Scalar + InRaw>(
    triangle: &Triangle<S>,
    aabb: &Aabb<S>,
) -> bool {
    let (p, q, by_center) = aabb.numbers();
    let ([b, c, p, q], grown) = cut_down(triangle, &p.into(), &q.into(), by_center);
    let form = if by_center {
        BoxForm::Center(p, [q[0] + grown, q[1] + grown, q[2] + grown])
    } else {
        BoxForm::Corners(p, q, [grown; 3])
    };
    any_axis(&Frame::<Int16>::new(&[[0; 3], b, c], &form)) == Some(true)
}

/// The offsets of the points from the first vertex, truncated to 18 bits, and the growth of the
/// box. A half-extent is no offset.
#[inline(never)]
fn cut_down<S: Scalar + InRaw>(
    triangle: &Triangle<S>,
    p: &Vec3<S>,
    q: &Vec3<S>,
    by_center: bool,
) -> ([[i32; 3]; 4], i32) {
    let [a, b, c] = triangle.vertices();
    let (a, mut rows) = (raw(a), [raw(b), raw(c), raw(p), raw(q)]);
    let mut falls = [[0; 3]; 4];
    let mut size = 0;
    for k in 0..4 {
        for i in 0..3 {
            let from = if by_center && k == 3 { 0 } else { a[i] };
            // The low 64 bits of the difference, and its sign: all ones if negative.
            falls[k][i] = -i64::from(rows[k][i] < from);
            rows[k][i] = rows[k][i].wrapping_sub(from);
            // For negative d, !d is one less than the magnitude.
            size |= rows[k][i] ^ falls[k][i];
        }
    }
    let shift = (i64::BITS - size.leading_zeros()).saturating_sub(BITS);
    let mut short = [[0; 3]; 4];
    for k in 0..4 {
        for i in 0..3 {
            let low = (rows[k][i] >> shift) as i32 & ((1 << BITS) - 1);
            short[k][i] = low | (falls[k][i] as i32) << BITS;
        }
    }
    (short, if shift > 0 { 2 } else { 0 })
}
