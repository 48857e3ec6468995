//! A triangle or a box, and a segment, in one number system.

use core::cmp::Ordering;

use super::mesh::InteriorEdges;
use crate::arithmetic::{
    Arithmetic, Each, Number, compare, cross, dot, greatest, pick, sign, three, turn,
};
use crate::query::{Vector, along, from, product};

/// The most corners of a shape.
pub(super) const CORNERS: usize = 8;

/// The way from a point of the solid to a point of the segment.
pub(super) enum Way<N: Arithmetic> {
    /// Between two corners.
    Points(Vector<N>),
    /// Across a line along `e`: from it or to it, by a vector `d` that is not across it.
    Line { d: Vector<N>, e: Vector<N> },
    /// Along a normal; the solid extends beyond the segment by n·overlap/|n|², or less than to it.
    Normal { n: [N::Area; 3], overlap: N::Volume },
}

/// A triangle or a box, and a segment, which may be a point.
pub(super) struct Scene<N: Arithmetic> {
    corners: [Vector<N>; CORNERS],
    pub(super) is_box: bool,
    pub(super) ends: [Vector<N>; 2],
    /// From the first end to the second.
    pub(super) e: Vector<N>,
    pub(super) one: N::Length,
}

impl<N: Arithmetic> Way<N> {
    /// The sign of the way along a vector.
    #[inline(never)]
    fn sign_along(&self, v: &Vector<N>) -> Ordering {
        match self {
            Self::Points(d) => sign(product::<N>(d, v)),
            Self::Line { d, e } => compare(
                N::quartic(product::<N>(d, v), product::<N>(e, e)),
                N::quartic(product::<N>(e, v), product::<N>(d, e)),
            ),
            Self::Normal { n, .. } => sign(dot::<N>(n, v)),
        }
    }

    pub(super) fn is_zero(&self) -> bool {
        match self {
            Self::Points(d) => d.iter().all(Number::is_zero),
            Self::Line { d, e } => cross::<N>(e, d).iter().all(Number::is_zero),
            Self::Normal { n, .. } => n.iter().all(Number::is_zero),
        }
    }
}

impl<N: Arithmetic> Scene<N> {
    /// A triangle by its vertices.
    pub(super) fn of_triangle(
        vertices: &[Vector<N>; 3],
        ends: [Vector<N>; 2],
        one: N::Length,
    ) -> Self {
        let corners = core::array::from_fn(|k| *pick(vertices, if k < 3 { k } else { 0 }));
        let e = from::<N>(&ends[1], &ends[0]);
        Self { corners, is_box: false, ends, e, one }
    }

    /// A box by its least and its greatest corner.
    pub(super) fn of_box(
        [low, high]: &[Vector<N>; 2],
        ends: [Vector<N>; 2],
        one: N::Length,
    ) -> Self {
        let corner = |k: usize| three(|i| if k >> i & 1 == 1 { high[i] } else { low[i] });
        let e = from::<N>(&ends[1], &ends[0]);
        Self { corners: core::array::from_fn(corner), is_box: true, ends, e, one }
    }

    pub(super) fn corner(&self, k: usize) -> &Vector<N> {
        &self.corners[k % CORNERS]
    }

    pub(super) fn corners(&self) -> usize {
        if self.is_box { CORNERS } else { 3 }
    }

    /// The numbers of the ends. A point has one.
    pub(super) fn ends(&self) -> core::ops::Range<usize> {
        0..if self.e.iter().all(Number::is_zero) { 1 } else { 2 }
    }

    /// The edges of the solid: the number of each, and its ends.
    pub(super) fn edges(&self) -> impl Iterator<Item = (u8, [usize; 2])> + use<N> {
        let is_box = self.is_box;
        (0..if is_box { 12 } else { 3 }).map(move |k: usize| {
            if !is_box {
                return (k as u8, [k, turn(k).1]);
            }
            let (i, next, after) = turn(k / 4);
            let start = (k & 1) << next | (k >> 1 & 1) << after;
            (k as u8, [start, start | 1 << i])
        })
    }

    /// The corners that lie farthest along the way from a point of the solid; `None` if others lie
    /// farther than the point.
    pub(super) fn farthest(&self, way: &Way<N>, from_point: &Vector<N>) -> Option<[bool; CORNERS]> {
        let mut farthest = [false; CORNERS];
        for (k, is) in farthest.iter_mut().enumerate().take(self.corners()) {
            match way.sign_along(&from::<N>(self.corner(k), from_point)) {
                Ordering::Greater => return None,
                order => *is = order.is_eq(),
            }
        }
        Some(farthest)
    }

    /// Whether the segment goes on from this end along the way, or across it.
    pub(super) fn goes_on(&self, way: &Way<N>, end: usize) -> bool {
        let order = way.sign_along(&self.e);
        order != if end == 0 { Ordering::Less } else { Ordering::Greater }
    }

    /// A face: a corner of it, and its normal outward.
    pub(super) fn face(&self, number: u8) -> (usize, [N::Area; 3]) {
        if self.is_box {
            let (i, is_upper) = (usize::from(number / 2), number % 2 == 1);
            let unit = N::area(self.one, self.one);
            let normal = three(|k| match (k == i, is_upper) {
                (false, _) => N::Area::ZERO,
                (true, true) => unit,
                (true, false) => -unit,
            });
            return (if is_upper { CORNERS - 1 } else { 0 }, normal);
        }
        let n = self.normal();
        (0, if number == 0 { n } else { n.each(|x| -x) })
    }

    /// The normal of a triangle.
    pub(super) fn normal(&self) -> [N::Area; 3] {
        let edge = |k: usize| from::<N>(self.corner(turn(k).1), self.corner(k));
        cross::<N>(&edge(0), &edge(1))
    }

    /// Whether the foot of a point on the plane of a face lies in the face.
    pub(super) fn is_over_face(&self, number: u8, n: &[N::Area; 3], point: &Vector<N>) -> bool {
        if self.is_box {
            let [low, high] = [self.corner(0), self.corner(CORNERS - 1)];
            let is_within = |i: usize| point[i] >= low[i] && point[i] <= high[i];
            return (0..3).all(|i| i == usize::from(number / 2) || is_within(i));
        }
        let n = if number == 0 { *n } else { n.each(|x| -x) };
        (0..3).all(|k| {
            let (edge, to_point) = (
                from::<N>(self.corner(turn(k).1), self.corner(k)),
                from::<N>(point, self.corner(k)),
            );
            sign(along::<N>(&n, &cross::<N>(&edge, &to_point))).is_ge()
        })
    }

    /// Whether the way leads across an interior edge of a triangle: across the edge that lies
    /// farthest along it, or over an edge of the vertex that does.
    pub(super) fn leads_across(
        &self,
        way: &Way<N>,
        farthest: [bool; CORNERS],
        interior: InteriorEdges,
    ) -> bool {
        let is_farthest = |k: usize| farthest[k % CORNERS];
        let of_edges = |is: &dyn Fn(usize) -> bool| (0..3).any(|k| interior.contains(k) && is(k));
        match (0..3).filter(|&k| is_farthest(k)).count() {
            1 => of_edges(&|k| {
                let is_at = is_farthest(k) || is_farthest(turn(k).1);
                is_at && self.is_beyond_edge(way, k)
            }),
            2 => of_edges(&|k| is_farthest(k) && is_farthest(turn(k).1)),
            _ => false,
        }
    }

    /// Whether the way from a vertex leads beyond an edge there, as seen along the triangle's normal.
    fn is_beyond_edge(&self, way: &Way<N>, k: usize) -> bool {
        let (n, f) = (self.normal(), from::<N>(self.corner(turn(k).1), self.corner(k)));
        let beyond = |v: &Vector<N>| along::<N>(&cross::<N>(v, &f), &n);
        match way {
            Way::Points(d) => beyond(d).is_positive(),
            Way::Line { d, e } => {
                let (ee, de) = (product::<N>(e, e), product::<N>(d, e));
                N::sextic_of_areas(beyond(d), ee) > N::sextic_of_areas(beyond(e), de)
            }
            // A normal that a single vertex is farthest along is of no triangle.
            Way::Normal { .. } => false,
        }
    }

    /// A vector across the line on which both shapes lie; `None` if they lie on none.
    pub(super) fn across_line(&self) -> Option<[N::Area; 3]> {
        let is_zero = |v: &[N::Area; 3]| v.iter().all(Number::is_zero);
        let of_solid = (1..CORNERS).map(|k| from::<N>(self.corner(k), self.corner(0)));
        let mut sides = core::iter::once(self.e).chain(of_solid);
        let Some(line) = sides.find(|v| !v.iter().all(Number::is_zero)) else {
            return Some([N::Area::ZERO, N::Area::ZERO, N::area(self.one, self.one)]);
        };
        if !sides.all(|side| is_zero(&cross::<N>(&line, &side))) {
            return None;
        }
        let axis = |i: usize| three(|k| if i == k { self.one } else { N::Length::ZERO });
        let mut across = (0..3).map(|i| cross::<N>(&line, &axis(i)));
        across.find(|v| !is_zero(v))
    }

    /// How far the triangle extends beyond the segment along a direction.
    pub(super) fn overlap(&self, n: &[N::Area; 3]) -> N::Volume {
        let beyond = |end: usize| dot::<N>(n, &from::<N>(self.corner(0), &self.ends[end]));
        greatest(beyond(0), beyond(1))
    }
}
