//! The 13 axes of triangle and box at one time of the way, four at once.
//!
//! A time at which no axis separates for certain says that the shapes meet. One at which a single
//! axis does for certain, and no other may, says more of shapes that meet: the others have closed
//! before, so that this is the axis that closes last. About where such times are quotients tell,
//! which need no bound: what they lead to is looked at.

use crate::arithmetic::{Float, Number, Quad, THREE, greatest, least};
use crate::query::Axis;

/// An axis in each lane. Along it the triangle moves by `way`. At the start it is above the box by
/// `above`, or below it by `below`; these are below zero where it is not.
#[derive(Clone, Copy)]
pub(super) struct Moving<Q> {
    pub(super) above: Q,
    pub(super) below: Q,
    pub(super) way: Q,
    pub(super) error: Q,
}

/// All of them: three edges, each across the coordinate axes; the faces; and the plane, in all
/// lanes alike. Those across the coordinate axes come out as products do, as (z, x, y).
pub(super) struct Instants<Q> {
    pub(super) edges: [Moving<Q>; 3],
    pub(super) faces: Moving<Q>,
    pub(super) plane: Moving<Q>,
    /// The edges as vectors, and as products come out.
    pub(super) e: [[Q; 2]; 3],
    pub(super) extent: Q,
}

/// What part of a bound keeps a quotient finite.
const PART: u16 = 1 << 12;

impl<Q: Quad<Lane: Float>> Moving<Q> {
    #[inline(always)]
    pub(super) fn new(middle: Q, radius: Q, way: Q, error: Q) -> Self {
        let zero = Q::splat(Q::Lane::ZERO);
        Self { above: middle - radius, below: zero - middle - radius, way, error }
    }

    /// How far the shapes are apart at a time, below zero if they are not.
    #[inline(always)]
    fn gap(&self, t: Q) -> Q {
        let way = self.way * t;
        (self.above + way).greatest(self.below - way)
    }

    /// The same all of the way, at the least.
    #[inline(always)]
    pub(super) fn least_gap(&self) -> Q {
        let zero = Q::splat(Q::Lane::ZERO);
        (self.above + self.way.least(zero)).greatest(self.below - self.way.greatest(zero))
    }

    /// About when they begin to be in doubt, and cease to be.
    #[inline(always)]
    fn times(&self) -> [Q; 2] {
        let (zero, one) = (Q::splat(Q::Lane::ZERO), Q::splat(Q::Lane::from(1)));
        let (part, twice) = (one / Q::splat(Q::Lane::from(PART)), self.error + self.error);
        let inverse = one / (self.way + self.error * part);
        let (a, b) = ((self.above - twice) * (zero - inverse), (self.below - twice) * inverse);
        [a.least(b), a.greatest(b)]
    }
}

/// What is known of a time: the axes that may separate, and whether those do for certain.
struct Near {
    edges: [u32; 3],
    faces: u32,
    plane: u32,
    is_certain: bool,
}

impl<Q: Quad<Lane: Float>> Instants<Q> {
    /// About when the triangle meets the box and leaves it, within the way; in disorder if never.
    #[inline(always)]
    pub(super) fn times(&self) -> [Q::Lane; 2] {
        let (mut first, mut last) = (Q::splat(Q::Lane::ZERO), Q::splat(Q::Lane::from(1)));
        let [a, b, c] = &self.edges;
        for moving in [a, b, c, &self.faces, &self.plane] {
            let [begin, end] = moving.times();
            (first, last) = (first.greatest(begin), last.least(end));
        }
        let ([a, b, c], [x, y, z]) = (first.three(), last.three());
        [greatest(greatest(a, b), c), least(least(x, y), z)]
    }

    /// Which axes are whose own: others are along the normal of a face, or zero.
    #[inline(always)]
    fn slanted(&self, k: usize) -> u32 {
        let zero = Q::splat(Q::Lane::ZERO);
        let [e, turned] = self.e[k];
        e.magnitude().exceeds(zero) & turned.magnitude().exceeds(zero) & THREE
    }

    #[inline(always)]
    fn near(&self, t: Q::Lane) -> Option<Near> {
        let (zero, t) = (Q::splat(Q::Lane::ZERO), Q::splat(t));
        let [a, b, c] = &self.edges;
        let (edge_error, below) = (a.error, zero - a.error);
        let gaps = [a.gap(t), b.gap(t), c.gap(t)];
        let most = gaps[0].greatest(gaps[1]).greatest(gaps[2]);
        let (face, plane) = (self.faces.gap(t), self.plane.gap(t));
        let faces = face.exceeds(zero - self.faces.error) & THREE;
        let planes = plane.exceeds(zero - self.plane.error) & 1;
        if (most.exceeds(below) & THREE) | faces | planes == 0 {
            return None;
        }
        let edge = |k: usize| gaps[k].exceeds(below) & self.slanted(k);
        let edges = [edge(0), edge(1), edge(2)];
        let has_extent = self.extent.exceeds(zero) & THREE == THREE;
        let planes = if has_extent { planes } else { 0 };
        let open = |k: usize| edges[k] & !gaps[k].exceeds(edge_error);
        let in_doubt = open(0)
            | open(1)
            | open(2)
            | (faces & !face.exceeds(self.faces.error))
            | (planes & !plane.exceeds(self.plane.error));
        Some(Near { edges, faces, plane: planes, is_certain: in_doubt == 0 })
    }

    /// Whether no axis separates at a time, for certain.
    #[inline(always)]
    pub(super) fn overlap_at(&self, t: Q::Lane) -> bool {
        let all = |near: Near| {
            near.edges[0] | near.edges[1] | near.edges[2] | near.faces | near.plane == 0
        };
        self.near(t).is_none_or(all)
    }

    /// The only axis that may separate at a time, and does so.
    #[inline(always)]
    pub(super) fn only_axis_at(&self, t: Q::Lane) -> Option<Axis> {
        let Near { edges, faces, plane, is_certain } = self.near(t)?;
        let bits = edges[0] | edges[1] << 3 | edges[2] << 6 | faces << 9 | plane << 12;
        if !is_certain || bits.count_ones() != 1 {
            return None;
        }
        let place = bits.trailing_zeros() as u8;
        Some(match place {
            // (z, x, y)
            0..9 => Axis::Edge { axis: (place % 3 + 2) % 3, edge: place / 3 },
            9..12 => Axis::Face(place - 9),
            _ => Axis::Normal,
        })
    }
}
