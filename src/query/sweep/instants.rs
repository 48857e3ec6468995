//! The 13 axes of triangle and box at one time of the motion, four at once.
//!
//! If no axis separates for certain at some time, the shapes meet. If exactly one axis separates
//! for certain at some time, and no second may, the rest have closed before, so this is the axis
//! that closes last for shapes that meet. Quotients without error bounds propose such times; the
//! axes are then evaluated there with bounds.

use crate::arithmetic::{Float, Number, Quad, THREE, greatest, least};
use crate::query::Axis;

/// Four axes, one in each lane. Along each the triangle moves by `way`. At the start it lies above
/// the box by `above` or below it by `below`; both are below zero where the shapes overlap.
#[derive(Clone, Copy)]
pub(super) struct Moving<Q> {
    pub(super) above: Q,
    pub(super) below: Q,
    pub(super) way: Q,
    pub(super) error: Q,
}

/// All 13 axes: three edges, each with the coordinate axes; the faces; and the plane, in all lanes
/// alike. The lanes of an edge are in the order (z, x, y), as the products come out.
#[derive(Clone, Copy)]
pub(super) struct Instants<Q> {
    pub(super) edges: [Moving<Q>; 3],
    pub(super) faces: Moving<Q>,
    pub(super) plane: Moving<Q>,
    /// The edges as vectors, and in the order of the products.
    pub(super) e: [[Q; 2]; 3],
    pub(super) extent: Q,
}

/// The part 1/`PART` of a bound, added to a divisor, keeps the quotient finite.
const PART: u16 = 1 << 12;

impl<Q: Quad<Lane: Float>> Moving<Q> {
    #[inline(always)]
    pub(super) fn new(middle: Q, radius: Q, way: Q, error: Q) -> Self {
        let zero = Q::splat(Q::Lane::ZERO);
        Self { above: middle - radius, below: zero - middle - radius, way, error }
    }

    /// The gap at a time, below zero where the shapes overlap.
    #[inline(always)]
    fn gap(self, t: Q) -> Q {
        let way = self.way * t;
        (self.above + way).greatest(self.below - way)
    }

    /// The least gap over the whole motion.
    #[inline(always)]
    pub(super) fn least_gap(self) -> Q {
        let zero = Q::splat(Q::Lane::ZERO);
        (self.above + self.way.least(zero)).greatest(self.below - self.way.greatest(zero))
    }

    /// About when the axis starts to be in doubt, and when it stops.
    #[inline(always)]
    fn times(self) -> [Q; 2] {
        let (zero, one) = (Q::splat(Q::Lane::ZERO), Q::splat(Q::Lane::from(1)));
        let (part, twice) = (one / Q::splat(Q::Lane::from(PART)), self.error + self.error);
        let inverse = one / (self.way + self.error * part);
        let (a, b) = ((self.above - twice) * (zero - inverse), (self.below - twice) * inverse);
        [a.least(b), a.greatest(b)]
    }
}

impl<Q: Quad<Lane: Float>> Instants<Q> {
    /// About when the triangle meets the box and leaves it within the motion; in reverse order if
    /// it never does.
    #[inline(always)]
    pub(super) fn times(self) -> [Q::Lane; 2] {
        let (mut first, mut last) = (Q::splat(Q::Lane::ZERO), Q::splat(Q::Lane::from(1)));
        let [a, b, c] = self.edges;
        let mut narrow = |[begin, end]: [Q; 2]| {
            (first, last) = (first.greatest(begin), last.least(end));
        };
        narrow(a.times());
        narrow(b.times());
        narrow(c.times());
        narrow(self.faces.times());
        narrow(self.plane.times());
        let ([a, b, c], [x, y, z]) = (first.three(), last.three());
        [greatest(greatest(a, b), c), least(least(x, y), z)]
    }

    /// Whether it is certain that no axis separates at a time.
    #[inline(always)]
    pub(super) fn overlap_at(self, t: Q::Lane) -> bool {
        let at = Q::splat(t);
        let [a, b, c] = self.edges;
        let most = a.gap(at).greatest(b.gap(at)).greatest(c.gap(at));
        let near = most.may_be_above(a.error)
            | self.faces.gap(at).may_be_above(self.faces.error)
            | self.plane.gap(at).may_be_above(self.plane.error);
        near & THREE == 0 || self.near(t) & own(self.e, self.extent) == 0
    }

    /// The only axis that may separate at a time, if it separates for certain.
    #[inline(always)]
    pub(super) fn only_axis_at(self, t: Q::Lane) -> Option<Axis> {
        let mut near = self.near(t);
        if !near.is_power_of_two() {
            near &= own(self.e, self.extent);
        }
        let is_one = near.is_power_of_two() && near & self.beyond(t) != 0;
        let place = near.trailing_zeros() as u8;
        is_one.then_some(match place {
            // (z, x, y)
            0..9 => Axis::Edge { axis: (place + 2) % 3, edge: place / 3 },
            9..12 => Axis::Face(place - 9),
            _ => Axis::Normal,
        })
    }

    /// The axes that may separate at a time, one bit each: edges, faces, plane.
    #[inline(always)]
    fn near(self, t: Q::Lane) -> u32 {
        let t = Q::splat(t);
        self.bits(|moving| moving.gap(t).may_be_above(moving.error))
    }

    /// The axes that separate at a time for certain.
    #[inline(always)]
    fn beyond(self, t: Q::Lane) -> u32 {
        let t = Q::splat(t);
        self.bits(|moving| moving.gap(t).exceeds(moving.error))
    }

    #[inline(always)]
    fn bits(self, of: impl Fn(Moving<Q>) -> u32) -> u32 {
        let [a, b, c] = self.edges;
        let edges = of(a) & THREE | (of(b) & THREE) << 3 | (of(c) & THREE) << 6;
        edges | (of(self.faces) & THREE) << 9 | (of(self.plane) & 1) << 12
    }
}

/// The axes with a direction of their own; all remaining axes are zero or along a face normal.
///
/// By value, and out of line: see `rows`.
#[inline(never)]
fn own<Q: Quad<Lane: Float>>(e: [[Q; 2]; 3], extent: Q) -> u32 {
    let zero = Q::splat(Q::Lane::ZERO);
    let is_nonzero = |x: Q| x.magnitude().exceeds(zero) & THREE;
    let slanted = |k: usize| is_nonzero(e[k][0]) & is_nonzero(e[k][1]);
    let plane = u32::from(extent.exceeds(zero) & THREE == THREE);
    slanted(0) | slanted(1) << 3 | slanted(2) << 6 | THREE << 9 | plane << 12
}
