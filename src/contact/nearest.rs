//! Where a segment and a triangle or a box are nearest to each other, or in each other least deep.
//!
//! Two convex shapes that are apart have a pair of nearest points. One pair is of these kinds: a
//! corner of one shape and any part of the other, or two edges that cross. It is the nearest if and
//! only if the plane through each point, across the way between them, has its shape behind it: a
//! local minimum of a convex function is the global one.
//!
//! If the shapes have a point in common, the least way out leads through a face of the hull of all
//! differences of their points. It has the normal of a face, or is the cross product of two edges;
//! the foot of the origin lies on that face, so that only pairs that meet along the normal count.
//!
//! All signs are of products of two to four lengths, in exact numbers.

use super::answer::Part;
use super::scene::{CORNERS, Scene, Way};
use crate::arithmetic::{Arithmetic, Each, Number, Soft, cross, dot, sign};
use crate::query::{Vector, along, from, product};

/// A point of the solid.
pub(super) enum Place<N: Arithmetic> {
    Corner(Vector<N>),
    /// Beyond a point by e·along/length.
    Edge {
        from: Vector<N>,
        e: Vector<N>,
        along: N::Quartic,
        length: N::Quartic,
    },
    /// The foot of a point, if the plane lies beyond it by n·height/|n|².
    Face {
        of: Vector<N>,
        n: [N::Area; 3],
        height: N::Volume,
    },
}

/// A pair of points, of the solid and of the segment.
pub(super) struct Pair<N: Arithmetic> {
    pub(super) way: Way<N>,
    /// The corners of the solid that lie farthest along the way.
    pub(super) farthest: [bool; CORNERS],
    pub(super) parts: [Part; 2],
    pub(super) place: Place<N>,
}

/// A depth, as the square of overlap/|n|; `None` for zero.
fn squared_depth<N: Arithmetic>(way: &Way<N>) -> Option<Soft> {
    let Way::Normal { n, overlap } = way else { return None };
    let ((_, overlap), (_, square)) = (overlap.sign_and_size()?, along::<N>(n, n).sign_and_size()?);
    Some(overlap.times(overlap).over(square))
}

impl<N: Arithmetic> Scene<N> {
    /// The way along a face's normal from the face to an end of the segment.
    fn face_to_end(&self, number: u8, end: usize) -> Option<Pair<N>> {
        let (corner, n) = self.face(number);
        let y = self.ends[end % 2];
        let height = dot::<N>(&n, &from::<N>(self.corner(corner), &y));
        let way = Way::Normal { n, overlap: height };
        let is_end = !way.is_zero() && self.goes_on(&way, end);
        if !is_end || !self.is_over_face(number, &n, &y) {
            return None;
        }
        let farthest = self.farthest(&way, self.corner(corner))?;
        let face = if self.is_box { number } else { 0 };
        let parts = [Part::Face(face), Part::Vertex(end as u8)];
        Some(Pair { way, farthest, parts, place: Place::Face { of: y, n, height } })
    }

    /// The ways from an edge to the segment where both cross: along their common normal, and against
    /// it.
    fn edge_to_segment(&self, (number, [start, end]): (u8, [usize; 2])) -> [Option<Pair<N>>; 2] {
        let x = self.corner(start);
        let f = from::<N>(self.corner(end), x);
        let n = cross::<N>(&self.e, &f);
        if n.iter().all(Number::is_zero) {
            return [None, None];
        }
        let w = from::<N>(&self.ends[0], x);
        let length = along::<N>(&n, &n);
        let [of_segment, of_edge] = [&f, &self.e].each(|v| along::<N>(&cross::<N>(v, &w), &n));
        let is_within = |t: N::Quartic| t >= N::Quartic::ZERO && t <= length;
        if !is_within(of_segment) || !is_within(of_edge) {
            return [None, None];
        }
        [n, n.each(|x| -x)].each(|n| {
            let way = Way::Normal { n, overlap: -dot::<N>(&n, &w) };
            let farthest = self.farthest(&way, x)?;
            let parts = [Part::Edge(number), Part::Edge(0)];
            let place = Place::Edge { from: *x, e: f, along: of_edge, length };
            Some(Pair { way, farthest, parts, place })
        })
    }

    /// The ways along normals that are candidates.
    fn along_normals(&self) -> impl Iterator<Item = Pair<N>> + '_ {
        let faces = 0..if self.is_box { 6 } else { 2 };
        let by_faces = faces.flat_map(|face| self.ends().map(move |end| (face, end)));
        by_faces
            .filter_map(|(face, end)| self.face_to_end(face, end))
            .chain(self.edges().flat_map(|edge| self.edge_to_segment(edge)).flatten())
    }

    /// The pairs of a corner or an edge of the solid and the segment with one way between them that
    /// has the shapes behind it.
    fn across(&self) -> impl Iterator<Item = Pair<N>> + '_ {
        let corners = (0..self.corners()).flat_map(|k| self.ends().map(move |end| (k, end)));
        let by_corners = corners.filter_map(|(k, end)| {
            let x = self.corner(k);
            let way = Way::Points(from::<N>(&self.ends[end % 2], x));
            let parts = [Part::Vertex(k as u8), Part::Vertex(end as u8)];
            self.if_nearest(way, x, Some(end), parts, Place::Corner(*x))
        });
        let edges = self.edges().flat_map(|edge| self.ends().map(move |end| (edge, end)));
        let by_edges = edges.filter_map(|((number, [start, other]), end)| {
            let x = self.corner(start);
            let (d, e) = (from::<N>(&self.ends[end % 2], x), from::<N>(self.corner(other), x));
            let (de, ee) = (product::<N>(&d, &e), product::<N>(&e, &e));
            if !de.is_positive() || de >= ee {
                return None;
            }
            let unit = N::area(self.one, self.one);
            let [along, length] = [de, ee].each(|x| N::quartic(x, unit));
            let parts = [Part::Edge(number), Part::Vertex(end as u8)];
            let place = Place::Edge { from: *x, e, along, length };
            self.if_nearest(Way::Line { d, e }, x, Some(end), parts, place)
        });
        let by_segment = (0..self.corners()).filter_map(|k| {
            let x = self.corner(k);
            let (d, e) = (from::<N>(&self.ends[0], x), self.e);
            let (back, ee) = (-product::<N>(&d, &e), product::<N>(&e, &e));
            if !back.is_positive() || back >= ee {
                return None;
            }
            let parts = [Part::Vertex(k as u8), Part::Edge(0)];
            self.if_nearest(Way::Line { d, e }, x, None, parts, Place::Corner(*x))
        });
        by_corners.chain(by_edges).chain(by_segment)
    }

    fn if_nearest(
        &self,
        way: Way<N>,
        x: &Vector<N>,
        end: Option<usize>,
        parts: [Part; 2],
        place: Place<N>,
    ) -> Option<Pair<N>> {
        if !end.is_none_or(|end| self.goes_on(&way, end)) {
            return None;
        }
        let farthest = self.farthest(&way, x)?;
        Some(Pair { way, farthest, parts, place })
    }

    /// The nearest pair, or that of the least way out; of equal ones the first.
    #[inline(never)]
    pub(super) fn nearest(&self) -> Option<Pair<N>> {
        let mut best: Option<(Option<Soft>, Pair<N>)> = None;
        for pair in self.along_normals() {
            if let Way::Normal { overlap, .. } = pair.way {
                if sign(overlap).is_lt() {
                    return Some(pair);
                }
            }
            let depth = squared_depth(&pair.way);
            let is_less = |best: &Option<Soft>| match (depth, best) {
                (Some(depth), Some(best)) => depth.is_less_than(*best),
                (depth, best) => depth.is_none() && best.is_some(),
            };
            if best.as_ref().is_none_or(|(best, _)| is_less(best)) {
                best = Some((depth, pair));
            }
        }
        let mut common = None;
        for pair in self.across() {
            if !pair.way.is_zero() {
                return Some(pair);
            }
            common = common.or(Some(pair));
        }
        // Shapes in one line with a common point: any way across the line leads out.
        if let (Some((Some(_), _)) | None, Some(pair)) = (&best, common) {
            if let Some(n) = self.across_line() {
                return Some(Pair { way: Way::Normal { n, overlap: N::Volume::ZERO }, ..pair });
            }
        }
        Some(best?.1)
    }
}
