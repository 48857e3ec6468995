//! A pair in floats: the first look, in registers, and out of line what that leaves in doubt: which
//! axes may separate, and whether rounding has any part in it.

use super::error_bound::error_bound;
use super::offsets::{self, ForOffsets, InRows};
use super::rows::{Clear, Doubt, Edge, InFrame, Rows, by_form, in_registers, row};
use crate::arithmetic::{Filtered, Float, InFloat, Number, Quad, THREE, two_difference};
use crate::robust::{Stage, Uncertain, note};
use crate::scalar::Scalar;
use crate::shape::{Aabb, Triangle};

/// Whether one of the 13 axes separates, if floats decide it.
#[inline(always)]
pub(super) fn pair<S: Scalar + InFloat<F>, F: Float>(
    triangle: &Triangle<S>,
    aabb: &Aabb<S>,
) -> Option<bool> {
    let clear = if <S as InFloat<F>>::OFFSETS_FIRST && ForOffsets::IS_VECTOR {
        offsets::pair(triangle, aabb, offsets::apart)
    } else {
        let of_center = Rows::<F::Quad>::in_frame_of_center;
        let of_corners = Rows::<F::Quad>::in_frame_of_corners;
        by_form(
            triangle,
            aabb,
            move |t, p, q| look::<S, F>(t, p, q, of_center, offsets::of_center),
            move |t, p, q| look::<S, F>(t, p, q, of_corners, offsets::of_corners),
        )
    };
    // By value, for the reason given in `overlaps`.
    match clear {
        Ok(apart) => Some(apart),
        Err(doubt) => pair_in_doubt::<S, F>(triangle, *aabb, doubt),
    }
}

/// The first look at a box in one form: with its coordinates, or with offsets if they were rounded.
#[inline(always)]
fn look<S: Scalar + InFloat<F>, F: Float>(
    triangle: &Triangle<S>,
    p: [S; 3],
    q: [S; 3],
    in_frame: impl Fn(&Rows<F::Quad>, F::Quad, F::Quad) -> InFrame<F::Quad>,
    in_offsets: impl Fn(&Triangle<S>, [S; 3], [S; 3]) -> InRows + Copy,
) -> Clear {
    let (rows, first, second) = (Rows::<F::Quad>::of(triangle), row(&p.into()), row(&q.into()));
    if !rows.are_within(S::LIMIT, first, second) {
        let apart = move |t: &_, p, q| offsets::if_held(t, p, q, in_offsets, offsets::apart);
        return in_registers(triangle, p[0], p[1], p[2], q[0], q[1], q[2], apart);
    }
    rows.apart(&in_frame(&rows, first, second))
}

/// [`pair`] where the first look leaves a doubt.
///
/// An axis parallel to a face normal, or zero, separates only if that face does. That includes the
/// normal of a triangle parallel to a coordinate plane, and the axes of an edge parallel to a
/// coordinate axis. Without this rule every box-shaped mesh would be in doubt.
#[inline(never)]
fn pair_in_doubt<S: Scalar + InFloat<F>, F: Float>(
    triangle: &Triangle<S>,
    aabb: Aabb<S>,
    doubt: Doubt,
) -> Option<bool> {
    note(Stage::Look);
    if doubt == Doubt::SeemsToMeet && offsets::are_exact(triangle, &aabb) {
        return Some(false);
    }
    let rows = Rows::<F::Quad>::of(triangle);
    let (p, q, is_by_center) = aabb.numbers();
    let (p, q) = (row(&p.into()), row(&q.into()));
    if !rows.are_within(S::LIMIT, p, q) {
        return None;
    }
    let frame =
        if is_by_center { rows.in_frame_of_center(p, q) } else { rows.in_frame_of_corners(p, q) };
    if frame.apart != 0 {
        return Some(true);
    }
    let bound = error_bound::<Filtered<F>>(frame.size.most())?;
    let (plane, edges) = (rows.plane(&frame), rows.edges(&frame));
    let most = edges[0].greatest(edges[1]).greatest(edges[2]);
    let edge_bound = F::Quad::splat(bound.edge);
    if plane > bound.plane || most.exceeds(edge_bound) & THREE != 0 {
        return Some(true);
    }

    let in_plane = Uncertain::above(plane, bound.plane).possible
        && rows.high.exceeds(rows.low) & THREE == THREE;
    let mut doubt = in_plane;
    for k in 0..3 {
        doubt |= edges[k].may_be_above(edge_bound) & slanted(&rows.e[k]) != 0;
    }
    // Of copies: a reference would keep the numbers above in memory.
    if doubt && !in_plane && are_settled(rows, InFrame { ..frame }) {
        doubt = false;
    }
    let meets = if doubt {
        let seems_apart = most.exceeds(F::Quad::splat(F::ZERO)) & THREE != 0 || plane > F::ZERO;
        // On a grid "yes" would be certain too, but not every machine has this kernel, and
        // `may_overlap` must be the same on all.
        !seems_apart && is_on_grid(&rows, &frame, p, q)
    } else {
        frame.meets == THREE || gaps_are_exact(&rows, p, q)
    };
    meets.then_some(false)
}

/// Which products of an edge with coordinate axes, as they come out, have no zero for a component.
#[inline(always)]
fn slanted<Q: Quad<Lane: Float>>(edge: &Edge<Q>) -> u32 {
    let zero = Q::splat(Q::Lane::ZERO);
    edge.e.magnitude().exceeds(zero) & edge.turned.magnitude().exceeds(zero) & THREE
}

/// Whether the two other axes of the same edge decide each edge axis in doubt.
///
/// An edge that is parallel to a coordinate axis x_i up to rounding, as after a quarter turn, makes
/// e × x_i so short that its gap never exceeds the bound. Seen along e the triangle is a segment
/// with normal n. Flatten the box by h_i = 0. If neither n nor the products of e with the two other
/// axes separate the segment from it, the two projections meet. So does the projection of the whole
/// box, and e × x_i does not separate. The bounds also hold for smaller half-extents.
#[cold]
#[inline(never)]
fn are_settled<Q: Quad<Lane: Float>>(rows: Rows<Q>, frame: InFrame<Q>) -> bool {
    let Some(bound) = error_bound::<Filtered<Q::Lane>>(frame.size.most()) else {
        return false;
    };
    let below = Q::splat(-bound.edge);
    let edges = rows.edges(&frame);
    (0..3).all(|k| {
        let near = !below.exceeds(edges[k]) & slanted(&rows.e[k]);
        (0..3).filter(|q| near >> q & 1 == 1).all(|q| {
            // Products come out as (z, x, y).
            let mut half = frame.half.three();
            if let Some(h) = half.get_mut((q + 2) % 3) {
                *h = Q::Lane::ZERO;
            }
            let flattened = InFrame { half: Q::of_three(half), ..frame };
            let clear = below.exceeds(rows.edges(&flattened)[k]) | 1 << q;
            rows.plane(&flattened) < -bound.plane && clear & THREE == THREE
        })
    })
}

/// Whether every gap of zero between a triangle and a box given by its centre is exact: the
/// difference that gave it was not rounded.
fn gaps_are_exact<Q: Quad<Lane: Float>>(rows: &Rows<Q>, center: Q, half: Q) -> bool {
    let zero = Q::splat(Q::Lane::ZERO);
    let ([low, low_lost], [high, high_lost]) =
        (two_difference(rows.low, center), two_difference(rows.high, center));
    let is_rounded = |lost: Q| lost.magnitude().exceeds(zero);
    let (above, below) = (half.exceeds(low), high.exceeds(zero - half));
    (is_rounded(low_lost) & !above | is_rounded(high_lost) & !below) & THREE == 0
}

/// Whether the coordinates of a triangle and of a box, given by `p` and `q`, are multiples of a
/// unit so great that no sum of products of three differences up to the pair's size is rounded.
fn is_on_grid<Q: Quad<Lane: Float>>(rows: &Rows<Q>, frame: &InFrame<Q>, p: Q, q: Q) -> bool {
    let size = frame.size.most();
    let shifter = Q::splat(size.power_of_two_below() * Q::Lane::GRID_SHIFTER);
    let mut off = 0;
    for x in [rows.v[0], rows.v[1], rows.v[2], p, q] {
        let whole = (x + shifter) - shifter;
        off |= whole.exceeds(x) | x.exceeds(whole);
    }
    off & THREE == 0
}
