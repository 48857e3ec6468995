//! Faces of two shapes, seen along the normal of their contact.
//!
//! Each corner has two more coordinates, across the normal. Points of two shapes meet if these
//! coordinates agree within [`View::tolerance`]. Each point is computed as a convex combination of
//! the corners of its part, and therefore lies on that part even if its coordinates across the
//! normal have an error.

use super::body::{Rough, Vec64, cross, dot};
use super::sides::{Flat, Unit, side};
use crate::arithmetic::{REGISTERS_ARE_WIDE, greatest, largest, pick, three, turn};

/// The most corners that a face has.
const CORNERS: usize = 4;

pub(super) fn minus(a: &Vec64, b: &Vec64) -> Vec64 {
    [a[0] - b[0], a[1] - b[1], a[2] - b[2]]
}

/// a + t·b.
fn along(a: &Vec64, t: f64, b: &Vec64) -> Vec64 {
    [a[0] + t * b[0], a[1] + t * b[1], a[2] + t * b[2]]
}

/// The number of a vertex of a box.
fn vertex_of_box(upper: [bool; 3]) -> u8 {
    u8::from(upper[0]) + 2 * u8::from(upper[1]) + 4 * u8::from(upper[2])
}

/// The number of the edge of a box along axis i.
pub(super) fn edge_of_box(i: usize, upper: [bool; 3]) -> u8 {
    let (i, j, k) = turn(i);
    4 * i as u8 + u8::from(upper[j]) + 2 * u8::from(upper[k])
}

/// A shape in floats: its centre or its vertices, and its half-edges.
pub(super) struct Solid {
    is_triangle: bool,
    at: [Vec64; 3],
    sides: [Vec64; 3],
    reach: [Vec64; 3],
    /// An upper bound of the coordinates of all corners.
    pub(super) size: f64,
}

impl Solid {
    pub(super) fn new(rough: &Rough) -> Self {
        let reach = three(|k| pick(&rough.sides, k).map(|x| pick(&rough.half, k) * x));
        let [a, b, c] = rough.at.each_ref().map(largest);
        let farthest = greatest(a, greatest(b, c));
        let size = reach.iter().fold(farthest, |size, reach| size + largest(reach));
        Self { is_triangle: rough.is_triangle, at: rough.at, sides: rough.sides, reach, size }
    }

    /// The numbers of its faces.
    pub(super) fn faces(&self) -> core::ops::Range<u8> {
        0..if self.is_triangle { 1 } else { 6 }
    }

    /// How far the shape extends in a direction, from the origin.
    pub(super) fn reach_along(&self, direction: &Vec64) -> f64 {
        let at = self.at.each_ref().map(|at| dot(at, direction));
        let reach = self.reach.each_ref().map(|reach| dot(reach, direction).abs());
        greatest(greatest(at[0], at[1]), at[2]) + (reach[0] + reach[1] + reach[2])
    }

    fn corner(&self, upper: [bool; 3]) -> Vec64 {
        (0..3).fold(self.at[0], |at, k| {
            let reach = &self.reach[k];
            three(|i| if upper[k] { at[i] + reach[i] } else { at[i] - reach[i] })
        })
    }

    /// The faces turned against `outward`, the normal of another shape's face. The first returned
    /// face is the most nearly antiparallel face that satisfies `is_first`. A triangle is its only
    /// face.
    pub(super) fn faces_against(
        &self,
        outward: &Vec64,
        is_first: impl Fn(u8) -> bool,
    ) -> impl Iterator<Item = u8> {
        // Divided by their greatest coordinates.
        let unit = |side: Vec64| side.map(|x| x / largest(&side));
        let axes = if self.is_triangle { self.sides } else { self.sides.map(unit) };
        let is_triangle = self.is_triangle;
        let facing = move |n: u8| if is_triangle { 1.0 } else { facing(&axes, n, outward) };
        let (mut first, mut best) = (0, f64::NEG_INFINITY);
        for number in self.faces().filter(|&n| is_first(n)) {
            let value = facing(number);
            if value > best {
                (first, best) = (number, value);
            }
        }
        let rest = self.faces().filter(move |&n| n != first && facing(n) > 0.0);
        core::iter::once(first).chain(rest)
    }
}

/// The signed square of the cosine between the outward normal of a face of a box and −`outward`.
fn facing(axes: &[Vec64; 3], number: u8, outward: &Vec64) -> f64 {
    let (k, i, j) = turn(usize::from(number / 2));
    let w = cross(pick(axes, i), pick(axes, j));
    let cosine = dot(&w, outward);
    let square = cosine * cosine / dot(&w, &w);
    let is_outward = (dot(&w, pick(axes, k)) > 0.0) == (number % 2 == 1);
    if is_outward == (cosine < 0.0) { square } else { -square }
}

/// Two directions across a normal, and the tolerance of coordinates along them.
pub(super) struct View {
    across: [Vec64; 2],
    pub(super) tolerance: f64,
    unit: Option<Unit>,
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
const TOLERANCE: f64 = f64::from_bits((1023 - 45) << 52);

impl View {
    pub(super) fn new(normal: &Vec64, size: f64, unit: Option<Unit>) -> Self {
        let sizes = normal.map(f64::abs);
        let least = usize::from(sizes[1] < sizes[0]);
        let (k, i, j) = turn(if sizes[2] < sizes[least] { 2 } else { least });
        // n × e_k has no rounding of its own.
        let mut first = [0.0; 3];
        (first[k], first[i], first[j]) = (0.0, normal[j], -normal[i]);
        Self { across: [first, cross(normal, &first)], tolerance: TOLERANCE * size, unit }
    }

    fn corner(&self, at: Vec64, vertex: u8) -> Corner {
        Corner { at, flat: self.across.each_ref().map(|b| dot(b, &at)), vertex }
    }

    fn allows(&self, a: &Corner, b: &Corner) -> bool {
        let d = flat(a, b);
        d[0] * d[0] + d[1] * d[1] <= self.tolerance * self.tolerance
    }
}

/// A point of a shape with its coordinates across the normal. `vertex` counts only for vertices.
#[derive(Clone, Copy)]
pub(super) struct Corner {
    pub(super) at: Vec64,
    flat: [f64; 2],
    pub(super) vertex: u8,
}

/// From b to a, across the normal.
fn flat(a: &Corner, b: &Corner) -> [f64; 2] {
    [a.flat[0] - b.flat[0], a.flat[1] - b.flat[1]]
}

fn across([a, b]: [f64; 2], [c, d]: [f64; 2]) -> f64 {
    a * d - b * c
}

/// An edge, from one vertex to the next.
pub(super) struct Edge {
    pub(super) ends: [Corner; 2],
    pub(super) number: u8,
}

impl Edge {
    /// The point at parameter t, clamped to the ends.
    fn point(&self, t: f64) -> Corner {
        let [p, q] = &self.ends;
        // NaN becomes the first end.
        let t = if t > 0.0 { if t < 1.0 { t } else { 1.0 } } else { 0.0 };
        let [dx, dy] = flat(q, p);
        let flat = [p.flat[0] + t * dx, p.flat[1] + t * dy];
        Corner { at: along(&p.at, t, &minus(&q.at, &p.at)), flat, vertex: p.vertex }
    }

    /// The point of the edge nearest to `to` across the normal.
    fn nearest(&self, to: &Corner) -> Corner {
        let (d, e) = (flat(to, &self.ends[0]), flat(&self.ends[1], &self.ends[0]));
        let square = e[0] * e[0] + e[1] * e[1];
        self.point((d[0] * e[0] + d[1] * e[1]) / square)
    }

    /// The signed distances of the ends of another edge from this one, times this edge's length.
    fn sides(&self, other: &Self) -> [f64; 2] {
        let [p, q] = &self.ends;
        other.ends.each_ref().map(|end| across(flat(q, p), flat(end, p)))
    }

    /// A point on each edge, at their crossing; if they do not cross, two points near each other.
    pub(super) fn meet(&self, other: &Self) -> [Corner; 2] {
        let [a, b] = self.sides(other);
        let here = self.nearest(&other.point(a / (a - b)));
        [here, other.nearest(&here)]
    }

    /// A point on each edge, at their crossing, if they cross.
    pub(super) fn crossing(&self, other: &Self, view: &View) -> Option<[Corner; 2]> {
        let is_crossed = |[a, b]: [f64; 2]| (a < 0.0 && b > 0.0) || (a > 0.0 && b < 0.0);
        if !is_crossed(self.sides(other)) || !is_crossed(other.sides(self)) {
            return None;
        }
        let [a, b] = self.meet(other);
        view.allows(&a, &b).then_some([a, b])
    }
}

/// The squared distance of two points across the normal.
pub(super) fn distance(a: &Corner, b: &Corner) -> f64 {
    let [x, y] = flat(a, b);
    x * x + y * y
}

/// A triangle, or a face of a box.
pub(super) struct Face {
    corners: [Corner; CORNERS],
    edges: [u8; CORNERS],
    count: usize,
    pub(super) number: u8,
    /// The corners in words, if the view has a unit.
    words: Option<[Flat; CORNERS]>,
}

impl Face {
    /// The triangle, or face `number` of the box.
    pub(super) fn new(view: &View, shape: &Solid, number: u8) -> Self {
        let corners = [Corner { at: [0.0; 3], flat: [0.0; 2], vertex: 0 }; CORNERS];
        let mut face = Self { corners, edges: [0, 1, 2, 2], count: 3, number, words: None };
        if shape.is_triangle {
            for (k, corner) in face.corners.iter_mut().enumerate() {
                let k = k.min(2);
                *corner = view.corner(*pick(&shape.at, k), k as u8);
            }
        } else {
            face.count = CORNERS;
            let (i, j, k) = turn(usize::from(number / 2));
            for n in 0..CORNERS {
                let mut upper = [false; 3];
                (upper[i], upper[j], upper[k]) = (number % 2 == 1, n == 1 || n == 2, n >= 2);
                // The edge runs along j if this corner and the next differ in j.
                face.edges[n] = edge_of_box(if n % 2 == 0 { j } else { k }, upper);
                face.corners[n] = view.corner(shape.corner(upper), vertex_of_box(upper));
            }
        }
        if let Some(unit) = view.unit {
            let words = face.words.insert([[0; 2]; CORNERS]);
            for (word, corner) in words.iter_mut().zip(&face.corners) {
                *word = unit.flat(&corner.flat);
            }
        }
        face
    }

    /// The corner after corner n.
    fn next(&self, n: usize) -> usize {
        if n + 1 < self.count { n + 1 } else { 0 }
    }

    /// The sides of edge n, in words, on which the ends of an edge of another face lie.
    fn sides_of(&self, n: usize, other: &Self, m: usize) -> [i8; 2] {
        let (Some(words), Some(others)) = (&self.words, &other.words) else { return [0; 2] };
        let (p, q) = (&words[n % CORNERS], &words[self.next(n) % CORNERS]);
        [m, other.next(m)].map(|m| side(p, q, &others[m % CORNERS]))
    }

    /// Whether edge n certainly does not cross edge m of another face.
    pub(super) fn is_clear_of(&self, n: usize, other: &Self, m: usize) -> bool {
        let are_same = |[a, b]: [i8; 2]| a == b && a != 0;
        are_same(self.sides_of(n, other, m)) || are_same(other.sides_of(m, self, n))
    }

    pub(super) fn corners(&self) -> impl Iterator<Item = &Corner> {
        self.corners.iter().take(self.count)
    }

    pub(super) fn edges(&self) -> impl Iterator<Item = Edge> {
        (0..self.count).map(|n| self.edge(n))
    }

    /// How many corners and edges it has.
    pub(super) fn count(&self) -> usize {
        self.count
    }

    pub(super) fn edge(&self, n: usize) -> Edge {
        let ends = [self.corners[n % CORNERS], self.corners[self.next(n) % CORNERS]];
        Edge { ends, number: self.edges[n % CORNERS] }
    }

    /// Whether a point lies within the face as seen along the normal; `None` if it is so near an
    /// edge that it may meet it.
    ///
    /// The lines of all edges have a point of the face on the same side. The margin is twice the
    /// tolerance, and the distances err by less than a third of the tolerance.
    fn within(&self, to: &Corner, view: &View) -> Option<bool> {
        let margin = 4.0 * (view.tolerance * view.tolerance);
        let (mut left, mut right) = (0, 0);
        for edge in self.edges() {
            let [p, q] = &edge.ends;
            let along = flat(q, p);
            let side = across(along, flat(to, p));
            let is_clear = side * side > margin * (along[0] * along[0] + along[1] * along[1]);
            left += usize::from(is_clear && side > 0.0);
            right += usize::from(is_clear && side < 0.0);
        }
        if left > 0 && right > 0 {
            return Some(false);
        }
        (left == self.count || right == self.count).then_some(true)
    }

    /// The same where words are certain.
    fn within_words(&self, to: &Corner, view: &View) -> Option<bool> {
        let (unit, words) = (view.unit?, self.words.as_ref()?);
        let to = unit.flat(&to.flat);
        let (mut left, mut right) = (0, 0);
        for n in 0..self.count {
            let side = side(&words[n % CORNERS], &words[self.next(n) % CORNERS], &to);
            left += usize::from(side > 0);
            right += usize::from(side < 0);
        }
        if left > 0 && right > 0 {
            return Some(false);
        }
        (left == self.count || right == self.count).then_some(true)
    }

    /// The point of the face that meets `to` across the normal, if there is one. Edges come first,
    /// and of those the edge farthest against `outward`: a face seen edge-on has several such
    /// points. If that edge lies beyond `to`, a point within the face may not.
    pub(super) fn meets(&self, to: &Corner, view: &View, outward: &Vec64) -> Option<Corner> {
        let is_within =
            if REGISTERS_ARE_WIDE { self.within(to, view) } else { self.within_words(to, view) };
        if is_within == Some(false) {
            return None;
        }
        let mut lowest: Option<Corner> = None;
        for edge in self.edges().filter(|_| is_within.is_none()) {
            let at = edge.nearest(to);
            let is_lower = |other: &Corner| dot(&at.at, outward) < dot(&other.at, outward);
            if view.allows(&at, to) && lowest.as_ref().is_none_or(is_lower) {
                lowest = Some(at);
            }
        }
        if lowest.is_some_and(|at| dot(&minus(&to.at, &at.at), outward) >= -view.tolerance) {
            return lowest;
        }
        let [a, b] = [&self.corners[1], &self.corners[(self.count - 1) % CORNERS]];
        let base = &self.corners[0];
        let [s, t] = parts(flat(a, base), flat(b, base), flat(to, base))?;
        let is_within = s >= 0.0 && t >= 0.0;
        let is_within =
            is_within && if self.count == 3 { s + t <= 1.0 } else { s <= 1.0 && t <= 1.0 };
        if !is_within {
            return None;
        }
        let at = along(&base.at, s, &minus(&a.at, &base.at));
        let at = view.corner(along(&at, t, &minus(&b.at, &base.at)), base.vertex);
        view.allows(&at, to).then_some(at)
    }

    /// The corner farthest against a direction.
    pub(super) fn lowest(&self, outward: &Vec64) -> Corner {
        let mut lowest = self.corners[0];
        for corner in self.corners() {
            if dot(outward, &corner.at) < dot(outward, &lowest.at) {
                lowest = *corner;
            }
        }
        lowest
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

/// The edges of a shape farthest in a direction and perpendicular to it; for a box, those along
/// axis i. `is_end` marks the farthest vertices of a triangle, or the farthest ends of a box's
/// axes.
pub(super) fn support_edges(
    view: &View,
    shape: &Solid,
    i: usize,
    is_across: [bool; 3],
    is_end: [bool; 3],
) -> impl Iterator<Item = Edge> {
    (0..4_u8).filter_map(move |n| {
        // Within the closure, where a compiler sees that they are below three.
        let (i, j, k) = turn(i);
        if shape.is_triangle {
            let (from, to, _) = turn(n.into());
            let is_edge = *pick(&is_across, from) && *pick(&is_end, from) && *pick(&is_end, to);
            let corner = |k: usize| view.corner(*pick(&shape.at, k), k as u8);
            let edge = || Edge { ends: [corner(from), corner(to)], number: n };
            return (n < 3 && is_edge).then(edge);
        }
        let mut upper = [false; 3];
        (upper[j], upper[k]) = (n & 1 == 1, n & 2 == 2);
        // No loop over j and k: for size, compilers check their bounds.
        let fits = |k| *pick(&is_across, k) || pick(&upper, k) == pick(&is_end, k);
        let is_edge = fits(j) && fits(k);
        let mut corner = |is_upper: bool| {
            upper[i] = is_upper;
            view.corner(shape.corner(upper), vertex_of_box(upper))
        };
        is_edge.then(|| Edge { ends: [corner(false), corner(true)], number: 4 * i as u8 + n })
    })
}
