//! Shapes seen along the normal of their contact, and the pairs of points that meet there.
//!
//! Each corner has two more coordinates, across the normal. Points of two shapes meet if these
//! coordinates agree within [`View::tolerance`]. Each point is computed as a convex combination of
//! the corners of its part, and therefore lies on that part even if its coordinates across the
//! normal have an error.

use super::answer::{MOST, Part};
use super::body::{Vec64, along, cross, dot, minus};
use super::sides::Unit;
use crate::arithmetic::{
    Each, Float, OfFour, Quad, REGISTERS_ARE_WIDE, greatest, largest, turn, two,
};

/// A number of each of four points.
pub(super) type Four = <f64 as OfFour>::Quad;

/// Two directions across a normal, and the tolerance of coordinates along them.
pub(super) struct View {
    pub(super) across: [Vec64; 2],
    pub(super) size: f64,
    pub(super) tolerance: f64,
    pub(super) unit: Option<Unit>,
}

/// The tolerance relative to the size of the shapes.
///
/// # The error
///
/// To first order in the unit roundoff u. Let S be the size of the shapes: an upper bound of all
/// coordinates from the origin, and of the partial sums that lead to them.
///
/// * A place is a mean of two differences of at most 2·S: 3·u·S. Half-extent, axis and product have
///   a rounding each, and a corner takes three sums: 3·u·S + 3·u·S + 3·u·S = 9·u·S.
/// * The normal errs by u in each coordinate. The first vector across has two coordinates, so a
///   coordinate along it errs by √2·(9 + 3)·u·S = 17·u·S. The second is a cross product of the
///   two, off by 3·u, with three coordinates: √3·(9 + 6)·u·S = 26·u·S.
/// * A convex combination of corners adds 6·u·S. If points of two shapes meet exactly, their
///   computed coordinates differ by up to √((2·23)² + (2·32)²)·u·S = 79·u·S.
///
/// The tolerance is 2^-45, that is 256·u.
///
/// S is at most 2.5·R, with R the greatest difference in a coordinate between two corners: R for
/// the centre, and half of R for each half-edge. A point is off its part by 9·u·S for the corners
/// and 6·u·S for the combination: 37.5·u·R, below 2^-47·R. Two points that meet are off the normal
/// by the tolerance divided by the length of the directions, at least √(2/3), and by 79·u·S:
/// (1.23·256 + 79)·2.5·u·R = 985·u·R. The depth is clamped at zero from −256·u·S = −640·u·R.
/// Together: √(985² + 640²)·u·R = 1175·u·R, below 2^-42·R = 2048·u·R.
///
/// `view.g` proves that some places certainly meet, and that some points are deep.
const TOLERANCE: f64 = ROUNDOFFS as f64 * f64::ROUNDOFF;

/// The tolerance in unit roundoffs.
const ROUNDOFFS: u16 = 256;

impl View {
    pub(super) fn new(normal: &Vec64, size: f64, unit: Option<Unit>) -> Self {
        let sizes = normal.each(f64::abs);
        let least = usize::from(sizes[1] < sizes[0]);
        let (k, i, j) = turn(if sizes[2] < sizes[least] { 2 } else { least });
        // n × e_k has no rounding of its own.
        let mut first = [0.0; 3];
        (first[k], first[i], first[j]) = (0.0, normal[j], -normal[i]);
        Self { across: [first, cross(normal, &first)], size, tolerance: TOLERANCE * size, unit }
    }

    pub(super) fn corner(&self, at: Vec64) -> Corner {
        Corner { at, flat: two(|n| dot(&self.across[n], &at)) }
    }

    /// The coordinates of four points across the normal.
    #[inline(always)]
    pub(super) fn flats(&self, [x, y, z]: [Four; 3]) -> [Four; 2] {
        let same = |x: f64| <Four as Quad>::splat(x);
        let dot = |a: &Vec64| same(a[0]) * x + same(a[1]) * y + same(a[2]) * z;
        two(|n| dot(&self.across[n]))
    }

    pub(super) fn allows(&self, a: &Corner, b: &Corner) -> bool {
        let d = flat(&a.flat, &b.flat);
        d[0] * d[0] + d[1] * d[1] <= self.tolerance * self.tolerance
    }
}

/// A point of a shape with its coordinates across the normal.
#[derive(Clone, Copy)]
pub(super) struct Corner {
    pub(super) at: Vec64,
    pub(super) flat: [f64; 2],
}

/// From b to a, across the normal.
pub(super) fn flat(a: &[f64; 2], b: &[f64; 2]) -> [f64; 2] {
    [a[0] - b[0], a[1] - b[1]]
}

fn across([a, b]: [f64; 2], [c, d]: [f64; 2]) -> f64 {
    a * d - b * c
}

/// The parameter of a point on an edge. NaN becomes the first end.
fn clamped(t: f64) -> f64 {
    // One after the other, without a branch.
    let t = if t > 0.0 { t } else { 0.0 };
    if t < 1.0 { t } else { 1.0 }
}

/// An edge, from one vertex to the next.
pub(super) struct Edge<'a> {
    pub(super) ends: [&'a Corner; 2],
    pub(super) number: u8,
}

impl Edge<'_> {
    /// The point at parameter t, across the normal.
    fn flat(&self, t: f64) -> [f64; 2] {
        let [p, q] = self.ends;
        let [dx, dy] = flat(&q.flat, &p.flat);
        [p.flat[0] + t * dx, p.flat[1] + t * dy]
    }

    /// The point of the edge nearest to `to` across the normal.
    pub(super) fn nearest(&self, to: &[f64; 2]) -> Corner {
        let (t, at) = self.nearest_at(to);
        Corner { at, flat: self.flat(t) }
    }

    /// Its parameter, and where it is.
    fn nearest_at(&self, to: &[f64; 2]) -> (f64, Vec64) {
        let [p, q] = self.ends;
        let (d, e) = (flat(to, &p.flat), flat(&q.flat, &p.flat));
        let square = e[0] * e[0] + e[1] * e[1];
        let t = clamped((d[0] * e[0] + d[1] * e[1]) / square);
        (t, along(&p.at, t, &minus(&q.at, &p.at)))
    }

    /// The signed distances of the ends of another edge from this one, times this edge's length.
    pub(super) fn sides(&self, other: &Self) -> [f64; 2] {
        let [p, q] = self.ends;
        two(|n| across(flat(&q.flat, &p.flat), flat(&other.ends[n].flat, &p.flat)))
    }

    /// A point on each edge, at their crossing; if they do not cross, two points near each other.
    /// The ends of the other edge have these signed distances.
    #[inline]
    pub(super) fn meet(&self, other: &Self, [a, b]: [f64; 2]) -> [Corner; 2] {
        let here = self.nearest(&other.flat(clamped(a / (a - b))));
        [here, other.nearest(&here.flat)]
    }

    /// A point on each edge, at their crossing, if they cross. If that is known, `sides` has the
    /// distances of the other edge's ends; on small cores it is known for certain.
    ///
    /// # The error
    ///
    /// With the sizes of [`View`]. Edges across the normal are at most D = 2·√3·S long, and so are the ways
    /// between their ends. A signed distance errs by 4·u·D, times this edge's length, and t has two roundings.
    /// The place on the other edge is off this edge's line by less than 6·u·D, below 21·u·S, and errs by
    /// 9·u·S more. Words are certain only if all ends are off the lines by more than 2^25·u·S. Then the place
    /// lies between the ends of this edge. The parameter of the nearest place on this edge errs by 9·u, which
    /// is 9·u·D along the edge, and the place by 9·u·S. The nearest place on the other edge errs as much.
    /// All together is below 110·u·S, less than half the tolerance. `view.g` proves it.
    #[inline]
    pub(super) fn crossing(
        &self,
        other: &Self,
        view: &View,
        sides: Option<[f64; 2]>,
    ) -> Option<[Vec64; 2]> {
        let is_certain = !REGISTERS_ARE_WIDE && sides.is_some();
        let [a, b] = match sides {
            Some(sides) => sides,
            None => {
                let sides = self.sides(other);
                let is_crossing = is_crossed(sides) && is_crossed(other.sides(self));
                is_crossing.then_some(sides)?
            }
        };
        let here = self.nearest(&other.flat(clamped(a / (a - b))));
        let (t, at) = other.nearest_at(&here.flat);
        let allows = || view.allows(&here, &Corner { at, flat: other.flat(t) });
        (is_certain || allows()).then_some([here.at, at])
    }
}

/// Whether two numbers differ in sign.
pub(super) fn is_crossed([a, b]: [f64; 2]) -> bool {
    (a < 0.0 && b > 0.0) || (a > 0.0 && b < 0.0)
}

/// The squared distance of two points across the normal.
pub(super) fn distance(a: &Corner, b: &Corner) -> f64 {
    let [x, y] = flat(&a.flat, &b.flat);
    x * x + y * y
}

/// A pair of points in floats from an origin: on the reference face, on the incident face.
#[derive(Clone, Copy)]
pub(super) struct Pair {
    pub(super) at: [Vec64; 2],
    pub(super) depth: f64,
}

/// Pairs of points. No two pairs are within twice the tolerance of each other.
pub(super) struct Pairs {
    pub(super) pairs: [Pair; MOST],
    /// Beside the pairs, which have no padding then. That would be copied with them.
    pub(super) parts: [[Part; 2]; MOST],
    pub(super) count: usize,
}

impl Pairs {
    pub(super) const NONE: Self = {
        let none = Pair { at: [[0.0; 3]; 2], depth: 0.0 };
        Self { pairs: [none; MOST], parts: [[Part::Face(0); 2]; MOST], count: 0 }
    };

    pub(super) fn iter(&self) -> impl Iterator<Item = &Pair> {
        self.pairs.iter().take(self.count)
    }

    /// A depth below zero is a rounding error. Returns the place for the parts of a new pair.
    #[inline]
    pub(super) fn add(&mut self, pair: Pair, tolerance: f64) -> Option<&mut [Part; 2]> {
        let is_near = |other: &Pair| {
            let apart = |n: usize| largest(&minus(&pair.at[n], &other.at[n]));
            apart(0) <= 2.0 * tolerance && apart(1) <= 2.0 * tolerance
        };
        let n = self.count;
        if n >= MOST || self.iter().any(is_near) {
            return None;
        }
        self.pairs[n] = Pair { depth: greatest(pair.depth, 0.0), ..pair };
        self.count = n + 1;
        Some(&mut self.parts[n])
    }

    pub(super) fn deepest(&self) -> f64 {
        self.iter().fold(f64::NEG_INFINITY, |deepest, pair| greatest(deepest, pair.depth))
    }
}
