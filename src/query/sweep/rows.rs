//! The kernel in floats. It has the same 19 axes, with x, y and z of a point side by side as in
//! `triangle_aabb::rows`.

use super::error_bound::{Along, FACE, along};
use super::instants::{Instants, Moving};
use super::{Instant, Last, Passing};
use crate::arithmetic::{Filtered, Float, InFloat, Number, Quad, THREE, greatest, out_of_line};
use crate::query::triangle_aabb::rows::{Edge, Rows, row};
use crate::robust::Uncertain;
use crate::scalar::Scalar;
use crate::shape::AabbForm;

/// A triangle in the frame of a box, and its motion.
#[derive(Clone, Copy)]
struct Course<Q> {
    rows: Rows<Q>,
    /// The vertices in the frame.
    v: [Q; 3],
    half: Q,
    d: Q,
    faces: Moving<Q>,
    /// The axes on which a face may separate all the way.
    open_faces: u32,
}

/// Whether the triangle misses the box all the way, if floats decide it.
#[inline(always)]
pub(super) fn misses<S: Scalar + InFloat<F>, F: Float>(passing: &Passing<'_, S>) -> Option<bool> {
    match passing.aabb.form() {
        AabbForm::Center { .. } => out_of_line(|| misses_in::<S, F>(passing, true)),
        AabbForm::Corners { .. } => out_of_line(|| misses_in::<S, F>(passing, false)),
    }
}

/// The knowledge of floats about the time of contact.
#[inline(always)]
pub(super) fn when<S: Scalar + InFloat<F>, F: Float>(passing: &Passing<'_, S>) -> Option<Instant> {
    match passing.aabb.form() {
        AabbForm::Center { .. } => out_of_line(|| when_in::<S, F>(passing, true)),
        AabbForm::Corners { .. } => out_of_line(|| when_in::<S, F>(passing, false)),
    }
}

// Inlined, so that each form of the box has code of its own.
#[inline(always)]
fn misses_in<S: Scalar + InFloat<F>, F: Float>(
    passing: &Passing<'_, S>,
    by_center: bool,
) -> Option<bool> {
    // By `match`: the compiler does not inline the closure of `map_or`.
    match Course::<F::Quad>::of(passing, by_center)? {
        Some(course) => course.misses(),
        None => Some(true),
    }
}

#[inline(always)]
fn when_in<S: Scalar + InFloat<F>, F: Float>(
    passing: &Passing<'_, S>,
    by_center: bool,
) -> Option<Instant> {
    match Course::<F::Quad>::of(passing, by_center)? {
        Some(course) => course.when(S::PLACE),
        None => Some(Instant::Misses),
    }
}

impl<Q: Quad<Lane: Float>> Course<Q> {
    /// `None` where coordinates were rounded; `Some(None)` where a face separates all the way.
    #[inline(always)]
    fn of<S: Scalar + InFloat<Q::Lane>>(
        passing: &Passing<'_, S>,
        by_center: bool,
    ) -> Option<Option<Self>> {
        let (AabbForm::Center { center: p, half: q } | AabbForm::Corners { min: p, max: q }) =
            passing.aabb.form();
        let (p, q) = (row::<S, Q>(p), row::<S, Q>(q));
        let [from, to] = passing.ends();
        let (from, to) = (row::<S, Q>(&from), row::<S, Q>(&to));
        let rows = Rows::of::<S>(passing.triangle);
        let are_exact = rows.are_within(S::LIMIT, p, q) && rows.are_within(S::LIMIT, from, to);
        are_exact.then(|| Self::new(rows, p, q, to - from, by_center))
    }

    /// `None` where a face separates all the way.
    #[inline(always)]
    fn new(rows: Rows<Q>, p: Q, q: Q, d: Q, by_center: bool) -> Option<Self> {
        let zero = Q::splat(Q::Lane::ZERO);
        // The gaps on both sides of the box, below zero where the shapes overlap. The sign of a gap
        // that is not zero is right, and with two corners a zero is too: see `Frame`.
        let (above, below, half) = if by_center {
            let (low, high) = (rows.low - p, rows.high - p);
            (low - q, zero - high - q, q)
        } else {
            (rows.low - q, p - rows.high, (q - p).halved())
        };
        let gap = above.greatest(below);
        let left = (above + d.least(zero)).greatest(below - d.greatest(zero));
        let size = above.magnitude() + below.magnitude() + half + d.magnitude();
        let error = size * Q::splat(Q::Lane::from(FACE) * Q::Lane::ROUNDOFF);
        // A gap stays open if the motion does not lead across it.
        let stays = above.exceeds(zero) & !zero.exceeds(d) | below.exceeds(zero) & !d.exceeds(zero);
        if (left.exceeds(error) | stays) & THREE != 0 {
            return None;
        }
        let is_gap = if by_center { !zero.exceeds(gap) } else { gap.exceeds(zero) };
        let open_faces = is_gap & left.may_be_above(error) & THREE;
        let v = rows.v;
        let in_frame = |v: Q| if by_center { v - p } else { ((v - p) + (v - q)).halved() };
        let v = [in_frame(v[0]), in_frame(v[1]), in_frame(v[2])];
        // Underflow in a part of the motion can lose more than a roundoff of a tiny size.
        let error = error + Q::splat(Q::Lane::UNDERFLOW);
        let faces = Moving { above, below, way: d, error };
        Some(Self { rows, v, half, d, faces, open_faces })
    }

    /// See `triangle_aabb::frame`.
    #[inline(always)]
    fn size(self) -> Q::Lane {
        let spans = self.half + (self.rows.high - self.rows.low) + self.d.magnitude();
        spans.most()
    }

    /// The axes of triangle and box. `None` where the plane separates all the way.
    #[inline(always)]
    fn instants(self, error: &Along<Filtered<Q::Lane>>) -> Option<Instants<Q>> {
        let Self { rows, v, half, d, faces, .. } = &self;
        let [area, volume] = [Q::splat(error.area), Q::splat(error.volume)];
        let plane = Moving::new(
            Q::splat(rows.n.dot(v[0])),
            Q::splat(rows.n.magnitude().dot(*half)),
            Q::splat(rows.n.dot(*d)),
            volume,
        );
        if plane.least_gap().exceeds(volume) & THREE != 0 {
            return None;
        }
        let (way, half_turned, radius) = (Edge::new(*d), half.turned(), rows.middle.magnitude());
        let edge = |k: usize| {
            let Edge { e, turned } = rows.e[k];
            let p = e * v[k].turned() - turned * v[k];
            let r = *half * turned.magnitude() + half_turned * e.magnitude();
            let q = e * way.turned - turned * *d;
            Moving::new(p + rows.middle, radius + r, q, area)
        };
        let e = |k: usize| [rows.e[k].e, rows.e[k].turned];
        Some(Instants {
            edges: [edge(0), edge(1), edge(2)],
            faces: *faces,
            plane,
            e: [e(0), e(1), e(2)],
            extent: rows.high - rows.low,
        })
    }

    /// Whether the triangle misses the box all the way, if floats decide it.
    #[inline(always)]
    fn misses(self) -> Option<bool> {
        let error = along(self.size())?;
        let Some(instants) = self.instants(&error) else { return Some(true) };
        let [first, last] = instants.times();
        if first <= last && instants.overlap_at((first + last).half()) {
            return Some(false);
        }
        self.misses_on_axes(error, instants)
    }

    /// When the triangle meets the box, as far as floats decide it. `place` is how much earlier
    /// than the first contact the other axes must have closed, so that they also close earlier in
    /// the scalar.
    #[inline(always)]
    fn when(self, place: Q::Lane) -> Option<Instant> {
        let error = along(self.size())?;
        let Some(instants) = self.instants(&error) else { return Some(Instant::Misses) };
        let [first, last] = instants.times();
        if first <= last {
            if first == Q::Lane::ZERO {
                if instants.overlap_at(first) {
                    return Some(Instant::AtStart);
                }
            } else if instants.overlap_at((first + last).half()) {
                // By more than a number of the scalar loses in `f64` too: see `Last`.
                let after = greatest(first - first.error(256) - place, Q::Lane::ZERO);
                let last = instants.only_axis_at(after);
                return Some(Instant::Meets(last.map(|axis| Last { axis, after: after.into() })));
            }
        }
        Some(match self.misses_on_axes(error, instants) {
            Some(true) => Instant::Misses,
            Some(false) => Instant::Meets(None),
            None => Instant::Unknown,
        })
    }

    /// Whether one of the 19 axes separates all the way. The plane is known not to.
    ///
    /// By value. An argument behind a reference stays in memory, and a vector load of it waits
    /// until its parts are stored.
    #[inline(never)]
    fn misses_on_axes(
        self,
        error: Along<Filtered<Q::Lane>>,
        instants: Instants<Q>,
    ) -> Option<bool> {
        let Self { rows, v, half, d, .. } = &self;
        let zero = Q::splat(Q::Lane::ZERO);
        let (way, half_turned) = (Edge::new(*d), half.turned());
        let half_way = rows.n.dot(*d).half();
        let apart = |middle: Q::Lane, n: Q| {
            middle.magnitude() - (half_way.magnitude() + n.magnitude().dot(*half))
        };
        let [plane, ..] = instants.plane.least_gap().to_array();
        let [a, b, c] = &instants.edges;
        let q = [a.way.turned(), b.way.turned(), c.way.turned()];
        let edges = [a.least_gap(), b.least_gap(), c.least_gap()];
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

        let cross = |k: usize| apart(q[k].dot(v[k]) - half_way, q[k]);
        let crosses = [cross(0), cross(1), cross(2)];
        let furthest = greatest(greatest(crosses[0], crosses[1]), crosses[2]);
        if furthest > error.volume {
            return Some(true);
        }

        // Nothing separates for certain. Which axes still may?
        let area = Q::splat(error.area);
        let is_near = (most.greatest(across).may_be_above(area) & THREE != 0)
            | Uncertain::above(greatest(plane, furthest), error.volume).possible
            | (self.open_faces != 0);
        if is_near && self.may_miss(&error, plane, &edges, across, crosses) {
            return None;
        }
        Some(false)
    }

    /// Whether an axis near contact differs in direction from every face normal and from the other
    /// axes.
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
        let area = Q::splat(error.area);
        let is_nonzero = |x: Q| x.magnitude().exceeds(zero) & THREE;
        let has_extent = rows.high.exceeds(rows.low) & THREE == THREE;
        let mut doubt =
            (self.open_faces != 0) | (Uncertain::above(plane, error.volume).possible & has_extent);
        let moves = is_nonzero(*d);
        let slanted = |e: Q| is_nonzero(e) & is_nonzero(e.turned());
        doubt |= across.may_be_above(area) & slanted(*d) != 0;
        for k in 0..3 {
            let e = rows.e[k].e;
            doubt |= edges[k].may_be_above(area) & slanted(e) != 0;
            let has_two = |bits: u32| bits & (bits - 1) != 0;
            let leads = is_nonzero(e);
            let is_own = leads != 0 && moves != 0 && has_two(leads) && has_two(moves);
            doubt |= Uncertain::above(crosses[k], error.volume).possible
                & is_own
                & (leads | moves == THREE);
        }
        doubt
    }
}
