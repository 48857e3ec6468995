//! The kernel in floats: the same 13 axes, with x, y and z of a point side by side.
//!
//! The cross product of two rows turns (rotates the lanes of) each row once, a × b =
//! turned(a·turned(b) − turned(a)·b), and before the last turn it comes out as (z, x, y). So do the
//! radii. All nine edge axes stay in this order, and nothing is transposed: one row holds the three
//! axes of an edge.

use super::error_bound::{ErrorBound, error_bound};
use crate::arithmetic::{
    Each, Filtered, FirstFloat, Float, InFloat, Number, OfFour, Quad, THREE, three_in_float,
};
use crate::scalar::Scalar;
use crate::shape::{Aabb, AabbForm, Triangle, Vec3};

/// The values of a triangle that are the same for every box.
#[derive(Clone, Copy, Debug)]
pub(in crate::query) struct Rows<Q> {
    /// The vertices.
    pub(in crate::query) v: [Q; 3],
    /// The least and the greatest coordinates of the vertices.
    pub(in crate::query) low: Q,
    pub(in crate::query) high: Q,
    /// The edges, each from a vertex to the next.
    pub(in crate::query) e: [Edge<Q>; 3],
    /// The normal.
    pub(in crate::query) n: Q,
    /// Half the normal, in the lane order of products.
    pub(in crate::query) middle: Q,
}

#[derive(Clone, Copy, Debug)]
pub(in crate::query) struct Edge<Q> {
    pub(in crate::query) e: Q,
    pub(in crate::query) turned: Q,
}

impl<Q: Quad> Edge<Q> {
    #[inline(always)]
    pub(in crate::query) fn new(e: Q) -> Self {
        Self { e, turned: e.turned() }
    }
}

#[inline(always)]
pub(in crate::query) fn row<S: InFloat<Q::Lane>, Q: Quad>(v: &Vec3<S>) -> Q {
    Q::of_three(three_in_float(v.to_array()))
}

/// Whether an axis separates, or the reason why the first look cannot decide.
pub(super) type Clear = Result<bool, Doubt>;

/// The reason for a doubt.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Doubt {
    /// No axis separates, but numbers may have been rounded.
    SeemsToMeet,
    Unknown,
}

/// A triangle in the frame of a box.
pub(super) struct InFrame<Q> {
    /// The vertices.
    pub(super) v: [Q; 3],
    /// The half-extents.
    pub(super) half: Q,
    /// The sum of the half-extents and the extents of the triangle.
    pub(super) size: Q,
    /// The axes on which the triangle lies beyond the box, and those on which it meets the box, as
    /// bits. On an axis with neither bit, rounding leaves it open.
    pub(super) apart: u32,
    pub(super) meets: u32,
}

impl<Q: Quad<Lane: Float>> Rows<Q> {
    #[inline(always)]
    pub(in crate::query) fn of<S: Scalar + InFloat<Q::Lane>>(triangle: &Triangle<S>) -> Self {
        Self::new(triangle.points().each(three_in_float))
    }

    #[inline(always)]
    pub(super) fn new([[px, py, pz], [qx, qy, qz], [rx, ry, rz]]: [[Q::Lane; 3]; 3]) -> Self {
        // Four at a time, as they lie in memory; nothing follows the last vertex.
        let before = Q::new([qz, rx, ry, rz]).to_array();
        let v = [
            Q::new([px, py, pz, qx]),
            Q::new([qx, qy, qz, rx]),
            Q::new([before[1], before[2], before[3], before[3]]),
        ];
        Self::of_rows(v)
    }

    /// From vertices that are rows already.
    #[inline(always)]
    pub(super) fn of_rows(v: [Q; 3]) -> Self {
        let e = [Edge::new(v[1] - v[0]), Edge::new(v[2] - v[1]), Edge::new(v[0] - v[2])];
        let product = e[0].e * e[1].turned - e[0].turned * e[1].e;
        Self {
            v,
            low: v[0].least(v[1]).least(v[2]),
            high: v[0].greatest(v[1]).greatest(v[2]),
            e,
            n: product.turned(),
            middle: product.halved(),
        }
    }

    /// Whether all coordinates became floats without rounding.
    #[inline(always)]
    pub(in crate::query) fn are_within(&self, limit: Option<Q::Lane>, p: Q, q: Q) -> bool {
        let Some(limit) = limit else { return true };
        let most = self.low.magnitude().greatest(self.high.magnitude());
        let most = most.greatest(p.magnitude()).greatest(q.magnitude());
        Q::splat(limit).exceeds(most) & THREE == THREE
    }

    /// The triangle in the frame of the box with this centre and these half-extents.
    #[inline(always)]
    pub(super) fn in_frame_of_center(&self, center: Q, half: Q) -> InFrame<Q> {
        let (above, below) = (self.low - center, center - self.high);
        // A computed gap of zero may be rounded. The sign of any other is right, because rounding
        // is monotonic.
        let gap = above.greatest(below);
        InFrame {
            v: [self.v[0] - center, self.v[1] - center, self.v[2] - center],
            half,
            size: half - (above + below),
            apart: gap.exceeds(half) & THREE,
            meets: half.exceeds(gap) & THREE,
        }
    }

    /// The same for the box with these corners.
    #[inline(always)]
    pub(super) fn in_frame_of_corners(&self, min: Q, max: Q) -> InFrame<Q> {
        let apart = (self.low.exceeds(max) | min.exceeds(self.high)) & THREE;
        // Not v − (min + max)/2: rounding the sum errs by the distance from the origin, rounding
        // the differences only by the distance from the box.
        let [a, b, c] = self.v;
        let from = |v: Q| ((v - min) + (v - max)).halved();
        let half = (max - min).halved();
        InFrame {
            v: [from(a), from(b), from(c)],
            half,
            size: half + (self.high - self.low),
            apart,
            meets: apart ^ THREE,
        }
    }

    /// The gap on the normal.
    #[inline(always)]
    pub(super) fn plane(&self, frame: &InFrame<Q>) -> Q::Lane {
        self.n.dot(frame.v[0]).magnitude() - self.n.magnitude().dot(frame.half)
    }

    /// The gaps on the edge axes.
    #[inline(always)]
    pub(super) fn edges(&self, frame: &InFrame<Q>) -> [Q; 3] {
        let InFrame { v, half, .. } = frame;
        let (radius, half, half_turned) = (self.middle.magnitude(), *half, half.turned());
        let gap = |k: usize| {
            let Edge { e, turned } = self.e[k];
            let p = e * v[k].turned() - turned * v[k];
            let r = half * turned.magnitude() + half_turned * e.magnitude();
            (p + self.middle).magnitude() - (radius + r)
        };
        [gap(0), gap(1), gap(2)]
    }

    #[inline(always)]
    pub(super) fn apart(&self, frame: &InFrame<Q>) -> Clear {
        if !Q::IS_VECTOR && frame.apart != 0 {
            return Ok(true);
        }
        match error_bound(frame.size.most()) {
            Some(bound) => self.apart_by_bounds(frame, bound, bound, false),
            None => Err(Doubt::Unknown),
        }
    }

    /// `Ok(true)` if some axis exceeds `beyond`, `Ok(false)` if every axis is below −`below`, else
    /// `Err`.
    ///
    /// With vectors there is no branch except the one on doubt: which axis separates is almost
    /// random, and a mispredicted branch costs as much as half of all axes. `is_foreseeable` is for
    /// callers that test one box after another along a row, where the plane misses long runs of
    /// boxes.
    #[inline(always)]
    pub(super) fn apart_by_bounds(
        &self,
        frame: &InFrame<Q>,
        beyond: ErrorBound<Filtered<Q::Lane>>,
        below: ErrorBound<Filtered<Q::Lane>>,
        is_foreseeable: bool,
    ) -> Clear {
        // Four bits each: three for axes, and the last for the plane.
        let (mut apart, mut meets) = (frame.apart, frame.meets);
        // Most boxes near a triangle are missed by its plane.
        let plane = self.plane(frame);
        apart |= u32::from(plane > beyond.plane) << 3;
        meets |= u32::from(plane < -below.plane) << 3;
        if (is_foreseeable || !Q::IS_VECTOR) && apart != 0 {
            return Ok(true);
        }

        let [a, b, c] = self.edges(frame);
        let most = a.greatest(b).greatest(c);
        apart |= most.exceeds(Q::splat(beyond.edge)) & THREE;
        meets &= Q::splat(-below.edge).exceeds(most) | !THREE;

        // One comparison, because the compiler turns a condition with two into two branches.
        if meets + (apart << 4) < 0b1111 {
            let zero = Q::Lane::ZERO;
            let seems_apart = plane > zero || most.exceeds(Q::splat(zero)) & THREE != 0;
            Err(if seems_apart { Doubt::Unknown } else { Doubt::SeemsToMeet })
        } else {
            Ok(apart != 0)
        }
    }

    /// Whether an axis separates as it is rounded: the operations of `kernel.rs`, and so its answer.
    #[inline(always)]
    fn seem_apart(&self, frame: &InFrame<Q>) -> bool {
        let zero = Q::splat(Q::Lane::ZERO);
        let [a, b, c] = self.edges(frame);
        // Not the greatest of the three, which may be a NaN after an overflow.
        let edges = (a.exceeds(zero) | b.exceeds(zero) | c.exceeds(zero)) & THREE;
        let plane = u32::from(self.plane(frame) > Q::Lane::ZERO);
        frame.apart | edges | plane != 0
    }
}

/// Whether one of the 13 axes separates, as the scalar's first float rounds.
#[inline(always)]
pub(super) fn disjoint_rounded<S: Scalar>(triangle: &Triangle<S>, aabb: &Aabb<S>) -> bool {
    let rows = |t: &Triangle<S>| Rows::<First<S>>::new(t.points().each(|p| p.each(S::first)));
    let row = |p: [S; 3]| First::<S>::of_three(p.each(S::first));
    by_form(
        triangle,
        aabb,
        move |t, center, half| {
            let rows = rows(t);
            rows.seem_apart(&rows.in_frame_of_center(row(center), row(half)))
        },
        move |t, min, max| {
            let rows = rows(t);
            let frame = rows.in_frame_of_corners(row(min), row(max));
            // Of the vertices in the frame, as in `kernel.rs`, and not of the given vertices.
            let InFrame { v: [a, b, c], half, .. } = frame;
            let (low, high) = (a.least(b).least(c), a.greatest(b).greatest(c));
            let gap = low.greatest(First::<S>::splat(S::SeptumFirst::ZERO) - high);
            rows.seem_apart(&InFrame { apart: gap.exceeds(half) & THREE, ..frame })
        },
    )
}

type First<S> = <<S as FirstFloat>::SeptumFirst as OfFour>::Quad;

/// The answer of one of two functions of a triangle and the two vectors of a box, by the form of the
/// box.
#[inline(always)]
pub(super) fn by_form<S: Scalar, T>(
    triangle: &Triangle<S>,
    aabb: &Aabb<S>,
    of_center: impl Fn(&Triangle<S>, [S; 3], [S; 3]) -> T,
    of_corners: impl Fn(&Triangle<S>, [S; 3], [S; 3]) -> T,
) -> T {
    match *aabb.form() {
        AabbForm::Center { center: c, half: h } => {
            in_registers(triangle, c.x, c.y, c.z, h.x, h.y, h.z, of_center)
        }
        AabbForm::Corners { min: a, max: b } => {
            in_registers(triangle, a.x, a.y, a.z, b.x, b.y, b.z, of_corners)
        }
    }
}

/// The answer of a function without captures, out of line, with each number of the box in a register.
#[allow(clippy::too_many_arguments)]
#[inline(never)]
pub(super) fn in_registers<S: Scalar, T>(
    triangle: &Triangle<S>,
    px: S,
    py: S,
    pz: S,
    qx: S,
    qy: S,
    qz: S,
    answer: impl Fn(&Triangle<S>, [S; 3], [S; 3]) -> T,
) -> T {
    answer(triangle, [px, py, pz], [qx, qy, qz])
}
