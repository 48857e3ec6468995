//! The kernel in floats: the same 13 axes, with x, y and z of a point side by side.
//!
//! The cross product of two rows turns (rotates the lanes of) each row once, a × b =
//! turned(a·turned(b) − turned(a)·b), and before the last turn it comes out as (z, x, y). So do the
//! radii. All nine edge axes stay in this order, and nothing is transposed: one row holds the three
//! axes of an edge.

use super::error_bound::{ErrorBound, error_bound};
use crate::arithmetic::{Filtered, Float, InFloat, Number, Quad, THREE, greatest};
use crate::scalar::Scalar;
use crate::shape::{Triangle, Vec3};

mod rounded;

pub(super) use rounded::disjoint as disjoint_rounded;

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
    Q::of_three([v.x.in_float(), v.y.in_float(), v.z.in_float()])
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
        let [a, b, c] = triangle.vertices();
        let point = |v: &Vec3<S>| [v.x.in_float(), v.y.in_float(), v.z.in_float()];
        Self::new([point(a), point(b), point(c)])
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
            middle: half_of(product),
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
        let from = |v: Q| half_of((v - min) + (v - max));
        let half = half_of(max - min);
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
        sum(self.n * frame.v[0]).magnitude() - sum(self.n.magnitude() * frame.half)
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
        match error_bound(largest(frame.size)) {
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
}

/// An upper bound of every coordinate in the frame of the box, if no face separates, and of every
/// edge and half-extent.
#[inline(always)]
pub(in crate::query) fn size<Q: Quad>(half: Q, extent: Q) -> Q::Lane {
    largest(half + extent)
}

/// The greatest of the first three lanes.
#[inline(always)]
pub(super) fn largest<Q: Quad>(row: Q) -> Q::Lane {
    let [x, y, z] = row.three();
    greatest(greatest(x, y), z)
}

#[inline(always)]
pub(in crate::query) fn half_of<Q: Quad<Lane: Float>>(x: Q) -> Q {
    x * Q::splat(Q::Lane::HALF)
}

/// The sum of the first three lanes, in order.
#[inline(always)]
pub(in crate::query) fn sum<Q: Quad>(row: Q) -> Q::Lane {
    let [x, y, z] = row.three();
    x + y + z
}
