//! The conservative test for 64-bit scalars: coordinates cut down to 18 bits, and the box
//! grown by what that may have cost. Its "disjoint" can be trusted.
//!
//! All coordinates are taken relative to the first vertex and shifted down until they lie
//! below 2^18; that keeps volumes below 2^61 (see `arithmetic::integer`).
//!
//! A shift takes a coordinate v to w with v − 1 < w <= v, in units of the shift, so a
//! point of the triangle moves by less than one; the corners of a box move likewise, and
//! a half-extent loses less than one. What met, meets still in a box that is two units
//! larger each way. That holds of half-extents only: an extent would have to grow by four.
//!
//! On a coordinate axis a gap shrinks by less than three units: one for a vertex or for
//! the box, and two for the growth. So one of four units is still there. Most pairs that
//! [`overlaps`](super::Overlaps::overlaps) settles by a face have a wider one, and take no
//! shift ([`is_far_beside`]).

use super::frame::{BoxForm, Frame};
use super::kernel::any_axis;
use crate::arithmetic::{InRaw, Int16, REGISTERS_ARE_WIDE, greatest, least};
use crate::scalar::Scalar;
use crate::shape::{Aabb, AabbForm, Triangle, Vec3};

/// In how many bits a coordinate is left, beside its sign.
const BITS: u32 = 18;

/// `true` only if the shapes are disjoint.
#[inline(always)]
pub(super) fn disjoint<S: Scalar + InRaw>(triangle: &Triangle<S>, aabb: &Aabb<S>) -> bool {
    let (AabbForm::Center { center: p, half: q } | AabbForm::Corners { min: p, max: q }) =
        aabb.form();
    let by_center = matches!(aabb.form(), AabbForm::Center { .. });
    // Each form apart: what depends on it would be kept in memory. Where registers are
    // narrow, all is, and once is less code.
    match by_center {
        true if REGISTERS_ARE_WIDE => of_form(triangle, p, q, true),
        false if REGISTERS_ARE_WIDE => of_form(triangle, p, q, false),
        _ => of_form(triangle, p, q, by_center),
    }
}

#[inline(always)]
fn of_form<S: Scalar + InRaw>(
    triangle: &Triangle<S>,
    p: &Vec3<S>,
    q: &Vec3<S>,
    by_center: bool,
) -> bool {
    let [a, b, c] = triangle.vertices();
    let rows = [raw(a), raw(b), raw(c), raw(p), raw(q)];
    let short = if REGISTERS_ARE_WIDE && are_near(&rows) {
        if is_far_beside(&rows, by_center) {
            return true;
        }
        cut_down(&differences(&rows, by_center))
    } else {
        cut_down_anywhere(triangle, p, q, by_center)
    };
    is_disjoint(short, by_center)
}

/// Whether an axis separates what is left of the shapes, with the box grown.
#[inline(always)]
fn is_disjoint(([b, c, p, q], grown): ([[i32; 3]; 4], i32), by_center: bool) -> bool {
    let form = if by_center {
        BoxForm::Center(p, [q[0] + grown, q[1] + grown, q[2] + grown])
    } else {
        BoxForm::Corners(p, q, [grown; 3])
    };
    any_axis(&Frame::<Int16>::new(&[[0; 3], b, c], &form)) == Some(true)
}

/// Whether all coordinates lie within 2^60: then words hold their differences, and sums
/// of a few.
#[inline(always)]
fn are_near(rows: &[[i64; 3]; 5]) -> bool {
    let beyond = rows.as_flattened().iter().fold(0, |beyond, x| beyond | x.wrapping_add(1 << 60));
    beyond as u64 >> 61 == 0
}

/// What each of the others is away from the first vertex; a half-extent is no position.
#[inline(always)]
fn differences([a, b, c, p, q]: &[[i64; 3]; 5], by_center: bool) -> [[i64; 3]; 4] {
    let from = |x: &[i64; 3]| [x[0] - a[0], x[1] - a[1], x[2] - a[2]];
    [from(b), from(c), from(p), if by_center { *q } else { from(q) }]
}

/// Whether on some coordinate axis so much lies between triangle and box that a gap is left
/// when they are cut down.
///
/// Let t be the fewest bits that hold all extents and the greatest gap G. The first vertex
/// is no farther than an extent from where the triangle comes nearest to the box, that is
/// at most G away, and the box's centre and its other side are within an extent. In all that
/// is less than 3·2^t, so t + 2 bits hold what is cut down, the shift is at most t − 16, and
/// four units are at most 2^(t − 14). If G needs t bits it is more. Else some extent does,
/// and a G above 2^(t − 1) >> 13 is more too. Without a shift every gap is left.
#[inline(always)]
fn is_far_beside([a, b, c, p, q]: &[[i64; 3]; 5], by_center: bool) -> bool {
    let (mut size, mut gap) = (0, 0);
    for i in 0..3 {
        let (low, high) = (least(least(a[i], b[i]), c[i]), greatest(greatest(a[i], b[i]), c[i]));
        let (extent, beside) = if by_center {
            (q[i], greatest(low - p[i], p[i] - high) - q[i])
        } else {
            (q[i] - p[i], greatest(low - q[i], p[i] - high))
        };
        size |= (high - low) | extent;
        gap = greatest(gap, beside);
    }
    gap > size >> (BITS - 5)
}

/// How far lengths of this many bits are shifted, and by how much that makes a box grow.
#[inline(always)]
fn shift(bits: u32) -> (u32, i32) {
    let shift = bits.saturating_sub(BITS);
    (shift, if shift > 0 { 2 } else { 0 })
}

/// Lengths shifted down until 18 bits hold them, and by how much a box must grow.
#[inline(always)]
fn cut_down(lengths: &[[i64; 3]; 4]) -> ([[i32; 3]; 4], i32) {
    // For d below zero, !d: one less than the magnitude.
    let size = lengths.as_flattened().iter().fold(0, |size, d| size | (d ^ (d >> 63)));
    let (shift, grown) = shift(i64::BITS - size.leading_zeros());
    let mut short = [[0; 3]; 4];
    for k in 0..4 {
        for i in 0..3 {
            short[k][i] = (lengths[k][i] >> shift) as i32;
        }
    }
    (short, grown)
}

/// The same of shapes whose differences may need 65 bits; where registers are narrow, of
/// all, for that is less code.
// It takes the shapes again: rows taken by reference would be kept in memory for it.
#[inline(never)]
fn cut_down_anywhere<S: Scalar + InRaw>(
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
            // 64 bits of the difference, and its sign: all ones below zero.
            falls[k][i] = -i64::from(rows[k][i] < from);
            rows[k][i] = rows[k][i].wrapping_sub(from);
            size |= rows[k][i] ^ falls[k][i];
        }
    }
    let (shift, grown) = shift(i64::BITS - size.leading_zeros());
    let mut short = [[0; 3]; 4];
    for k in 0..4 {
        for i in 0..3 {
            let low = (rows[k][i] >> shift) as i32 & ((1 << BITS) - 1);
            short[k][i] = low | (falls[k][i] as i32) << BITS;
        }
    }
    (short, grown)
}

/// The raw bits.
#[inline(always)]
fn raw<S: InRaw + Copy>(v: &Vec3<S>) -> [i64; 3] {
    let bits = |x: S| x.raw().into();
    [bits(v.x), bits(v.y), bits(v.z)]
}

#[cfg(test)]
mod tests {
    use fixed::types::I32F32;

    use super::*;

    /// SplitMix64 (G. L. Steele, D. Lea, C. H. Flood, "Fast Splittable Pseudorandom Number
    /// Generators", OOPSLA 2014).
    fn random(state: &mut u64) -> u64 {
        *state = state.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let z = (*state ^ (*state >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        let z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }

    fn check(rows: &[[i64; 3]; 5], by_center: bool) -> bool {
        let [a, b, c, p, q] = rows.map(|row| row.map(I32F32::from_bits));
        let triangle = Triangle::new(a, b, c).unwrap();
        let short = cut_down(&differences(rows, by_center));
        let far = cut_down_anywhere(&triangle, &Vec3::from(p), &Vec3::from(q), by_center);
        assert_eq!(short, far, "{rows:?}");
        let is_beside = is_far_beside(rows, by_center);
        assert!(!is_beside || is_disjoint(short, by_center), "{rows:?}");
        is_beside
    }

    #[test]
    fn a_wide_gap_is_left_when_all_is_cut_down() {
        let state = &mut 1;
        let mut beside = 0;
        for _ in 0..100_000 {
            // Of any size, with one about as far off as the shift may move it.
            let bits = 3 + random(state) % 56;
            let mut number = || (random(state) & ((1 << bits) - 1)) as i64 - (1 << (bits - 1));
            let mut rows = [(); 5].map(|()| [(); 3].map(|()| number()));
            let gap = (1 << bits >> 14) + (number() >> 13);
            let [a, b, c, p, q] = &mut rows;
            for i in 0..3 {
                q[i] = q[i].abs();
            }
            let top = greatest(greatest(a[0], b[0]), c[0]);
            p[0] = top + q[0] + gap;
            beside += u32::from(check(&rows, true));
            let [.., p, q] = &mut rows;
            for i in 0..3 {
                (p[i], q[i]) = (p[i] - q[i], p[i] + q[i]);
            }
            beside += u32::from(check(&rows, false));
        }
        // Neither always nor never.
        assert!((20_000..180_000).contains(&beside), "{beside}");
    }
}
