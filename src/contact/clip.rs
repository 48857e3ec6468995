//! The overlap of two faces, seen along the normal of a contact.

use super::body::{Vec64, dot};
use super::faces::{CORNERS, Face};
use super::feature::Part;
use super::points::{Pair, Pairs};
use super::sides::side;
use super::view::{Corner, View, across, along, flat, is_crossed, minus};
use crate::arithmetic::{REGISTERS_ARE_WIDE, greatest};

/// How many sides are known in floats. Cores that compute floats by functions have words.
const KNOWN: usize = if REGISTERS_ARE_WIDE { CORNERS } else { 0 };

/// The corners of a face as seen from another.
struct Seen<'a> {
    view: &'a View,
    from: &'a Face,
    face: &'a Face,
    /// The signed distance of each corner from each edge, times the edge's length.
    sides: [[f64; KNOWN]; KNOWN],
    /// The square of such a number from which its sign is certain, for each edge. The margin is twice
    /// the tolerance, and the distances err by less than a third of the tolerance.
    margins: [f64; KNOWN],
}

impl<'a> Seen<'a> {
    #[inline(always)]
    fn new(view: &'a View, from: &'a Face, face: &'a Face) -> Self {
        let (mut sides, mut margins) = ([[0.0; KNOWN]; KNOWN], [0.0; KNOWN]);
        let margin = 4.0 * (view.tolerance * view.tolerance);
        for (n, (sides, of_edge)) in sides.iter_mut().zip(&mut margins).enumerate() {
            let [p, q] = from.ends(n);
            let along = flat(q, p);
            *of_edge = margin * (along[0] * along[0] + along[1] * along[1]);
            for (side, to) in sides.iter_mut().zip(&face.corners) {
                *side = across(along, flat(to, p));
            }
        }
        Self { view, from, face, sides, margins }
    }

    /// The side of edge n on which corner m certainly lies; zero if it may meet the edge.
    #[inline(always)]
    fn side(&self, n: usize, m: usize) -> i8 {
        let (n, m) = (n % CORNERS, m % CORNERS);
        if REGISTERS_ARE_WIDE {
            let side = self.sides[n][m];
            let is_clear = side * side > self.margins[n];
            return i8::from(is_clear && side > 0.0) - i8::from(is_clear && side < 0.0);
        }
        let (Some(from), Some(to)) = (&self.from.words, &self.face.words) else { return 0 };
        side(&from[n], &from[self.from.next(n) % CORNERS], &to[m])
    }

    /// Whether edge m of the face may cross the line of edge n.
    #[inline(always)]
    fn may_cross(&self, n: usize, m: usize) -> bool {
        let ends = [m, self.face.next(m)];
        if REGISTERS_ARE_WIDE {
            return is_crossed(ends.map(|m| self.sides[n % CORNERS][m % CORNERS]));
        }
        let [a, b] = ends.map(|m| self.side(n, m));
        a != b || a == 0
    }

    /// Whether corner m lies within the other face; `None` if it is so near an edge that it may meet
    /// it.
    ///
    /// The lines of all edges have a point of the face on the same side.
    fn within(&self, m: usize) -> Option<bool> {
        let (mut left, mut right) = (0, 0);
        for n in 0..self.from.count() {
            let side = self.side(n, m);
            left += usize::from(side > 0);
            right += usize::from(side < 0);
        }
        if left > 0 && right > 0 {
            return Some(false);
        }
        (left == self.from.count() || right == self.from.count()).then_some(true)
    }

    /// The point of the other face that meets corner m across the normal, if there is one. Edges come
    /// first, and of those the edge farthest against `outward`: a face seen edge-on has several such
    /// points. If that edge lies beyond the corner, a point within the face may not.
    fn meets(&self, m: usize, outward: &Vec64) -> Option<Corner> {
        let (view, from, to) = (self.view, self.from, self.face.corner(m));
        let is_within = self.within(m);
        if is_within == Some(false) {
            return None;
        }
        if is_within.is_none() {
            let mut lowest: Option<Corner> = None;
            for edge in from.edges() {
                let at = edge.nearest(to);
                let is_lower = |other: &Corner| dot(&at.at, outward) < dot(&other.at, outward);
                if view.allows(&at, to) && lowest.as_ref().is_none_or(is_lower) {
                    lowest = Some(at);
                }
            }
            if lowest.is_some_and(|at| dot(&minus(&to.at, &at.at), outward) >= -view.tolerance) {
                return lowest;
            }
        }
        let [base, a, b] = [0, 1, from.count() - 1].map(|n| from.corner(n));
        let [s, t] = parts(flat(a, base), flat(b, base), flat(to, base))?;
        let is_within = s >= 0.0 && t >= 0.0;
        let is_within =
            is_within && if from.count() == 3 { s + t <= 1.0 } else { s <= 1.0 && t <= 1.0 };
        if !is_within {
            return None;
        }
        let at = along(&base.at, s, &minus(&a.at, &base.at));
        let at = view.corner(along(&at, t, &minus(&b.at, &base.at)), base.vertex);
        view.allows(&at, to).then_some(at)
    }
}

/// The corners of the overlap of two faces seen along the normal: corners of one face within the
/// other, and crossings of edges. Points above the reference face are dropped.
pub(super) fn clip(
    view: &View,
    [reference, incident]: [&Face; 2],
    outward: &Vec64,
    found: &mut Pairs,
) {
    let back = outward.map(|x| -x);
    let mut add = |[below, at]: [&Corner; 2], parts: [Part; 2]| {
        let depth = dot(&minus(&below.at, &at.at), outward);
        if depth >= -view.tolerance {
            found.add(Pair { at: [below.at, at.at], depth, parts }, view.tolerance);
        }
    };
    let of_incident = Seen::new(view, reference, incident);
    let of_reference = Seen::new(view, incident, reference);
    for (m, at) in incident.corners().enumerate() {
        if let Some(below) = of_incident.meets(m, &back) {
            add([&below, at], [Part::Face(reference.number), Part::Vertex(at.vertex)]);
        }
    }
    for (n, below) in reference.corners().enumerate() {
        if let Some(at) = of_reference.meets(n, outward) {
            add([below, &at], [Part::Vertex(below.vertex), Part::Face(incident.number)]);
        }
    }
    for n in 0..reference.count() {
        for m in 0..incident.count() {
            if !of_incident.may_cross(n, m) || !of_reference.may_cross(m, n) {
                continue;
            }
            let (below, at) = (reference.edge(n), incident.edge(m));
            if let Some([x, y]) = below.crossing(&at, view) {
                add([&x, &y], [Part::Edge(below.number), Part::Edge(at.number)]);
            }
        }
    }
}

/// Solves s·a + t·b = c for s and t; `None` if a and b are parallel. The greatest coefficient is
/// the pivot, so that the residual is small even if a and b are nearly parallel.
fn parts(a: [f64; 2], b: [f64; 2], c: [f64; 2]) -> Option<[f64; 2]> {
    let top = |v: [f64; 2]| greatest(v[0].abs(), v[1].abs());
    if top(a) < top(b) {
        return parts(b, a, c).map(|[t, s]| [s, t]);
    }
    if a[0].abs() < a[1].abs() {
        return parts([a[1], a[0]], [b[1], b[0]], [c[1], c[0]]);
    }
    let factor = a[1] / a[0];
    let t = (c[1] - factor * c[0]) / (b[1] - factor * b[0]);
    let s = (c[0] - t * b[0]) / a[0];
    (s.is_finite() && t.is_finite()).then_some([s, t])
}
