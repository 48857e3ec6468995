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

use super::frame::{BoxForm, Frame};
use super::kernel::any_axis;
use crate::arithmetic::{InWord, Int16};
use crate::scalar::Scalar;
use crate::shape::{Aabb, AabbForm, Triangle, Vec3};

/// `true` only if the shapes are disjoint.
#[inline(always)]
pub(super) fn disjoint<S: Scalar + InWord<i128>>(triangle: &Triangle<S>, aabb: &Aabb<S>) -> bool {
    let [a, b, c] = triangle.vertices();
    let (AabbForm::Center { center: p, half: q } | AabbForm::Corners { min: p, max: q }) =
        aabb.form();
    let (a, rows) = (raw(a), [raw(b), raw(c), raw(p), raw(q)]);
    // A half-extent is no position.
    let from = match aabb.form() {
        AabbForm::Center { .. } => [a, a, a, [0; 3]],
        AabbForm::Corners { .. } => [a; 4],
    };
    let (short, grown) = cut_down(&rows, &from);
    let [b, c, p, q] = short;
    let form = match aabb.form() {
        AabbForm::Center { .. } => BoxForm::Center(p, [q[0] + grown, q[1] + grown, q[2] + grown]),
        AabbForm::Corners { .. } => BoxForm::Corners(p, q, [grown; 3]),
    };
    any_axis(&Frame::<Int16>::new(&[[0; 3], b, c], &form)) == Some(true)
}

/// The differences `rows` − `from`, shifted down until 18 bits hold them, and by how much
/// a box must grow.
#[inline(always)]
fn cut_down(rows: &[[i64; 3]; 4], from: &[[i64; 3]; 4]) -> ([[i32; 3]; 4], i32) {
    let mut differences = [[0_i64; 3]; 4];
    let (mut size, mut overflow) = (0, 0);
    for k in 0..4 {
        for i in 0..3 {
            let (x, y) = (rows[k][i], from[k][i]);
            let d = x.wrapping_sub(y);
            // Negative where operands of different signs gave the sign of the second.
            overflow |= (x ^ y) & (x ^ d);
            // For d below zero, !d: one less than the magnitude.
            size |= d ^ (d >> 63);
            differences[k][i] = d;
        }
    }
    if overflow < 0 {
        return cut_down_far(rows, from);
    }
    let shift = (i64::BITS - size.leading_zeros()).saturating_sub(18);
    let mut short = [[0; 3]; 4];
    for k in 0..4 {
        for i in 0..3 {
            short[k][i] = (differences[k][i] >> shift) as i32;
        }
    }
    (short, if shift > 0 { 2 } else { 0 })
}

/// The same where a difference needs 65 bits: 46 of them are cut off, and 19 with the sign
/// are left.
#[cold]
#[inline(never)]
fn cut_down_far(rows: &[[i64; 3]; 4], from: &[[i64; 3]; 4]) -> ([[i32; 3]; 4], i32) {
    let mut short = [[0; 3]; 4];
    for k in 0..4 {
        for i in 0..3 {
            short[k][i] = ((i128::from(rows[k][i]) - i128::from(from[k][i])) >> 46) as i32;
        }
    }
    (short, 2)
}

/// The raw bits.
#[inline(always)]
fn raw<S: InWord<i128> + Copy>(v: &Vec3<S>) -> [i64; 3] {
    let bits = |x: S| x.in_word() as i64;
    [bits(v.x), bits(v.y), bits(v.z)]
}
