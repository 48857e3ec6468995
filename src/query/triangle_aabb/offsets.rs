//! The first look at a pair, in vectors of `f32` for every scalar: coordinates in the frame of the
//! box, each rounded once.
//!
//! It is as accurate far from the origin as near it. `f64` would fill half as many lanes, and
//! integers longer than the digits of `f32` have no vectors wide enough for their products.

use super::error_bound::{coarse_bound, offset_bound};
use super::rows::{Clear, Doubt, InFrame, Rows, by_form};
use crate::arithmetic::{Each, Float, OfFour, Quad, THREE};
use crate::scalar::Scalar;
use crate::shape::{Aabb, Triangle};

/// The number type of this stage.
pub(super) type ForOffsets = <f32 as OfFour>::Quad;

/// Whether one of the 13 axes separates by [`apart`] or [`coarsely_apart`], if that is clear.
#[inline(always)]
pub(super) fn pair<S: Scalar>(
    triangle: &Triangle<S>,
    aabb: &Aabb<S>,
    apart: impl Fn(InRows) -> Clear + Copy,
) -> Clear {
    let of_center = move |t: &_, p, q| if_held(t, p, q, of_center, apart);
    let of_corners = move |t: &_, p, q| if_held(t, p, q, of_corners, apart);
    by_form(triangle, aabb, of_center, of_corners)
}

/// The same of a box in one form, whose vectors `in_rows` takes.
#[inline(always)]
pub(super) fn if_held<S: Scalar>(
    triangle: &Triangle<S>,
    p: [S; 3],
    q: [S; 3],
    in_rows: impl Fn(&Triangle<S>, [S; 3], [S; 3]) -> InRows,
    apart: impl Fn(InRows) -> Clear,
) -> Clear {
    let [a, b, c] = triangle.points();
    if !S::have_offsets(&[a, b, c, p, q]) {
        return Err(Doubt::Unknown);
    }
    apart(in_rows(triangle, p, q))
}

/// Whether the coordinates are multiples of a unit so great that nothing above was rounded.
///
/// Lengths are below 2·P, with P the power of two below their size. In units of P/32, which
/// [`Offset::are_multiples`](crate::arithmetic::Offset::are_multiples) checks, the greatest sum of six products of three lengths is below
/// 48·P³, 2^20.6 units, and half of an area needs one more bit.
#[inline(always)]
pub(super) fn are_exact<S: Scalar>(triangle: &Triangle<S>, aabb: &Aabb<S>) -> bool {
    let [a, b, c] = triangle.points();
    let (p, q, _) = aabb.numbers();
    // If the size underflows, the unit would be zero, and every number a multiple of it.
    let Some(size) = size_in_range(&in_rows(triangle, aabb).1) else { return false };
    S::are_multiples(&[a, b, c, p, q], size.power_of_two_below() * 0.0625)
}

pub(super) type InRows = (Rows<ForOffsets>, InFrame<ForOffsets>);

#[inline(always)]
pub(super) fn in_rows<S: Scalar>(triangle: &Triangle<S>, aabb: &Aabb<S>) -> InRows {
    let (p, q, is_by_center) = aabb.numbers();
    if is_by_center { of_center(triangle, p, q) } else { of_corners(triangle, p, q) }
}

#[inline(always)]
pub(super) fn of_center<S: Scalar>(triangle: &Triangle<S>, center: [S; 3], half: [S; 3]) -> InRows {
    let from = |p: [S; 3]| row(|i| p[i].offset(center[i]));
    in_frame(triangle.points().each(from), row(|i| half[i].offset(S::ZERO)))
}

/// All lengths are doubled.
#[inline(always)]
pub(super) fn of_corners<S: Scalar>(triangle: &Triangle<S>, min: [S; 3], max: [S; 3]) -> InRows {
    let from = |p: [S; 3]| row(|i| p[i].offset_of_two(min[i], max[i]));
    in_frame(triangle.points().each(from), row(|i| max[i].offset(min[i])))
}

#[inline(always)]
pub(super) fn row(component: impl Fn(usize) -> f32) -> ForOffsets {
    ForOffsets::of_three([component(0), component(1), component(2)])
}

#[inline(always)]
fn in_frame(v: [ForOffsets; 3], half: ForOffsets) -> InRows {
    let rows = Rows::of_rows(v);
    // Rounding is monotonic, so a computed gap is a gap, but zero may be rounded.
    let gap = gap(&rows);
    let frame = InFrame {
        v,
        half,
        size: half + (rows.high - rows.low),
        apart: gap.exceeds(half) & THREE,
        meets: half.exceeds(gap) & THREE,
    };
    (rows, frame)
}

/// The size of the shapes, if `f32` can represent products of it. An offset out of range is
/// infinite, and the difference of two is a NaN.
#[inline(always)]
pub(super) fn size_in_range(frame: &InFrame<ForOffsets>) -> Option<f32> {
    let (least, most) = <f32 as Float>::RANGE;
    let size = frame.size.most();
    let are_below = ForOffsets::splat(most).exceeds(frame.size) & THREE == THREE;
    (are_below & (size > least)).then_some(size)
}

/// The distance of a triangle in the frame of a box from the box's centre, on each axis.
#[inline(always)]
fn gap(rows: &Rows<ForOffsets>) -> ForOffsets {
    rows.low.greatest(ForOffsets::splat(0.0) - rows.high)
}

/// Whether an axis separates.
#[inline(always)]
pub(super) fn apart((rows, frame): InRows) -> Clear {
    let Some(size) = size_in_range(&frame) else { return Err(Doubt::Unknown) };
    let bound = offset_bound(size);
    rows.apart_by_bounds(&frame, bound, bound, false)
}

/// Whether an axis separates that still does so after the truncation of coordinates
/// (`conservative.rs`).
#[inline(always)]
pub(super) fn coarsely_apart((rows, mut frame): InRows) -> Clear {
    let Some(size) = size_in_range(&frame) else { return Err(Doubt::Unknown) };
    let (face, beyond) = coarse_bound(size);
    frame.apart = gap(&rows).exceeds(frame.half + ForOffsets::splat(face)) & THREE;
    rows.apart_by_bounds(&frame, beyond, offset_bound(size), false)
}
