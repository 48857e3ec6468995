//! The kernel in floats: the same 19 axes, with x, y and z of a point side by side, as in
//! `triangle_aabb::rows`.

use super::Passing;
use super::error_bound::{Along, FACE, along};
use crate::arithmetic::{Filtered, Float, InFloat, Number, Quad, THREE, greatest};
use crate::query::triangle_aabb::rows::{Edge, Rows, half_of, row, sum};
use crate::scalar::Scalar;
use crate::shape::AabbForm;

/// A triangle in the frame of a box, and its way.
struct Course<Q> {
    rows: Rows<Q>,
    /// The vertices in the frame.
    v: [Q; 3],
    half: Q,
    d: Q,
    /// The axes on which a face may separate all of the way.
    open_faces: u32,
}

/// Whether the triangle misses the box all of the way, if floats can tell.
#[inline(always)]
pub(super) fn misses<S: Scalar + InFloat<F>, F: Float>(passing: &Passing<'_, S>) -> Option<bool> {
    match passing.aabb.form() {
        AabbForm::Center { .. } => misses_in::<S, F, true>(passing),
        AabbForm::Corners { .. } => misses_in::<S, F, false>(passing),
    }
}

#[inline(never)]
fn misses_in<S: Scalar + InFloat<F>, F: Float, const BY_CENTER: bool>(
    passing: &Passing<'_, S>,
) -> Option<bool> {
    let Passing { triangle, aabb, motion } = passing;
    let (AabbForm::Center { center: p, half: q } | AabbForm::Corners { min: p, max: q }) =
        aabb.form();
    let (p, q) = (row::<S, F::Quad>(p), row::<S, F::Quad>(q));
    let (from, to) = (row::<S, F::Quad>(&motion.from()), row::<S, F::Quad>(&motion.to()));
    let rows = Rows::of::<S>(triangle);
    if !(rows.are_within(S::LIMIT, p, q) && rows.are_within(S::LIMIT, from, to)) {
        return None;
    }
    match Course::new::<BY_CENTER>(rows, p, q, to - from) {
        Some(course) => course.misses(),
        None => Some(true),
    }
}

impl<Q: Quad<Lane: Float>> Course<Q> {
    /// Nothing where a face separates all of the way.
    #[inline(always)]
    fn new<const BY_CENTER: bool>(rows: Rows<Q>, p: Q, q: Q, d: Q) -> Option<Self> {
        let zero = Q::splat(Q::Lane::ZERO);
        // To either side of the box, below zero where they overlap. See `Frame`: the sign of what
        // is not zero is right, and that of zero with two corners.
        let (above, below, half) = if BY_CENTER {
            let (low, high) = (rows.low - p, rows.high - p);
            (low - q, zero - high - q, q)
        } else {
            (rows.low - q, p - rows.high, half_of(q - p))
        };
        let gap = above.greatest(below);
        let left = (above + d.least(zero)).greatest(below - d.greatest(zero));
        let size = above.magnitude() + below.magnitude() + half + d.magnitude();
        let error = size * Q::splat(Q::Lane::from(FACE) * Q::Lane::ROUNDOFF);
        // A gap that the way does not lead across stays.
        let stays = above.exceeds(zero) & !zero.exceeds(d) | below.exceeds(zero) & !d.exceeds(zero);
        if (left.exceeds(error) | stays) & THREE != 0 {
            return None;
        }
        let is_gap = if BY_CENTER { !zero.exceeds(gap) } else { gap.exceeds(zero) };
        let open_faces = is_gap & left.exceeds(zero - error) & THREE;
        let v = rows.v;
        let in_frame = |v: Q| if BY_CENTER { v - p } else { half_of((v - p) + (v - q)) };
        let v = [in_frame(v[0]), in_frame(v[1]), in_frame(v[2])];
        Some(Self { rows, v, half, d, open_faces })
    }

    /// See `triangle_aabb::frame`.
    #[inline(always)]
    fn size(&self) -> Q::Lane {
        let spans = self.half + (self.rows.high - self.rows.low) + self.d.magnitude();
        let [x, y, z] = spans.three();
        greatest(greatest(x, y), z)
    }

    /// See `kernel`: names and order of the operations are those.
    #[inline(always)]
    fn misses(&self) -> Option<bool> {
        let Self { rows, v, half, d, .. } = self;
        let error: Along<Filtered<Q::Lane>> = along(self.size())?;
        let zero = Q::splat(Q::Lane::ZERO);
        let (way, half_turned) = (Edge::new(*d), half.turned());

        let half_way = sum(rows.n * *d).half();
        let apart = |middle: Q::Lane, n: Q| {
            middle.magnitude() - (half_way.magnitude() + sum(n.magnitude() * *half))
        };
        let plane = apart(sum(rows.n * v[0]) + half_way, rows.n);
        if plane > error.volume {
            return Some(true);
        }

        let radius = rows.middle.magnitude();
        let beyond = |k: usize| {
            let Edge { e, turned } = rows.e[k];
            let q = e * way.turned - turned * *d;
            let p = e * v[k].turned() - turned * v[k];
            let r = *half * turned.magnitude() + half_turned * e.magnitude();
            let half_way = half_of(q);
            let edge =
                (p + rows.middle + half_way).magnitude() - (radius + half_way.magnitude() + r);
            (edge, q.turned())
        };
        let [(a, p), (b, q), (c, r)] = [beyond(0), beyond(1), beyond(2)];
        let (edges, q) = ([a, b, c], [p, q, r]);
        let most = edges[0].greatest(edges[1]).greatest(edges[2]);
        if most.exceeds(Q::splat(error.area)) & THREE != 0 {
            return Some(true);
        }

        let on_way = |v: Q| *d * v.turned() - way.turned * v;
        let [a, b, c] = [on_way(v[0]), on_way(v[1]), on_way(v[2])];
        let r = *half * way.turned.magnitude() + half_turned * d.magnitude();
        let (low, high) = (a.least(b).least(c), a.greatest(b).greatest(c));
        let across = low.greatest(zero - high) - r;
        if across.exceeds(Q::splat(error.area)) & THREE != 0 {
            return Some(true);
        }

        let cross = |k: usize| apart(sum(q[k] * v[k]) - half_way, q[k]);
        let crosses = [cross(0), cross(1), cross(2)];
        let furthest = greatest(greatest(crosses[0], crosses[1]), crosses[2]);
        if furthest > error.volume {
            return Some(true);
        }

        // Nothing separates for certain. What else may?
        let least = Q::splat(-error.area);
        let is_near = (most.greatest(across).exceeds(least) & THREE != 0)
            | (greatest(plane, furthest) >= -error.volume)
            | (self.open_faces != 0);
        if is_near && self.may_miss(&error, plane, &edges, across, crosses) {
            return None;
        }
        Some(false)
    }

    /// Whether an axis of those near contact is one that is not along a face normal or another
    /// axis.
    #[inline(never)]
    fn may_miss(
        &self,
        error: &Along<Filtered<Q::Lane>>,
        plane: Q::Lane,
        edges: &[Q; 3],
        across: Q,
        crosses: [Q::Lane; 3],
    ) -> bool {
        let (Self { rows, d, .. }, zero) = (self, Q::splat(Q::Lane::ZERO));
        let least = Q::splat(-error.area);
        let is_nonzero = |x: Q| x.magnitude().exceeds(zero) & THREE;
        let has_extent = rows.high.exceeds(rows.low) & THREE == THREE;
        let mut doubt = (self.open_faces != 0) | ((plane >= -error.volume) & has_extent);
        let moves = is_nonzero(*d);
        let slanted = |e: Q| is_nonzero(e) & is_nonzero(e.turned());
        doubt |= across.exceeds(least) & slanted(*d) != 0;
        for k in 0..3 {
            let e = rows.e[k].e;
            doubt |= edges[k].exceeds(least) & slanted(e) != 0;
            let has_two = |bits: u32| bits & (bits - 1) != 0;
            let leads = is_nonzero(e);
            let is_own = leads != 0 && moves != 0 && has_two(leads) && has_two(moves);
            doubt |= (crosses[k] >= -error.volume) & is_own & (leads | moves == THREE);
        }
        doubt
    }
}
