//! Whether a point lies farther than a radius from a point, a segment or a triangle.
//!
//! A vector d goes from the shape to the point. The squared distance is d·d at a vertex, |e × d|²/e·e
//! along an edge e, and (n·d)²/n·n over the face with normal n = e × f. Multiplied out, it compares
//! with r² in products of two, four and six lengths. Other signs say which of these is the distance:
//! - A point farther than r from the line of an edge is farther from the edge. If it is nearer, the
//!   distance is the one to the line between the ends, and the one to an end beyond it.
//! - A point farther than r from the plane of a triangle is farther from the triangle. If it is
//!   nearer, it is over the face if it lies inside of all edges, by n·(e × d) > 0. Else the nearest
//!   point is on an edge outside of which it lies (C. Ericson, *Real-Time Collision Detection*,
//!   2005, section 5.1.5). The same holds of a parallelogram.
//!
//! A normal of zero leaves no point inside of any edge, and all edges are asked.

use super::error_bound::{Errors, PRODUCT, SQUARE, SQUARES};
use crate::arithmetic::{Arithmetic, Number, cross, dot, greatest, largest, least, part, three};
use crate::query::orientation::{Vector, from};
use crate::robust::Uncertain;

/// The points within a radius of a point or a segment.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(in crate::query) enum Ball {
    /// With those at a distance of the radius.
    Closed,
    /// Without them. The radius is above zero.
    Open,
}

impl Ball {
    /// Whether points lie outside, from a squared distance less the square of the radius. Both may
    /// have a common factor above zero.
    #[inline(always)]
    pub(in crate::query) fn excludes<T: Number>(self, gap: T, error: T) -> Uncertain {
        match self {
            Self::Closed => Uncertain::above(gap, error),
            Self::Open => Uncertain::not_below(gap, error),
        }
    }
}

/// A radius, and its square.
pub(in crate::query) struct Reach<N: Arithmetic> {
    pub(in crate::query) radius: N::Length,
    pub(super) square: N::Area,
    pub(in crate::query) ball: Ball,
}

/// A number, and a bound on its error.
pub(super) struct Near<T> {
    pub(super) value: T,
    pub(super) error: T,
}

/// a·b.
// Not inlined on s390x: see `scalar::axes::faces_in_double`.
#[cfg_attr(not(target_arch = "s390x"), inline(always))]
#[cfg_attr(target_arch = "s390x", inline(never))]
pub(crate) fn product<N: Arithmetic>(a: &Vector<N>, b: &Vector<N>) -> N::Area {
    part(|| N::area(a[0], b[0]) + N::area(a[1], b[1]) + N::area(a[2], b[2]))
}

/// a·b, of areas.
#[inline(always)]
pub(crate) fn along<N: Arithmetic>(a: &[N::Area; 3], b: &[N::Area; 3]) -> N::Quartic {
    part(|| N::quartic(a[0], b[0]) + N::quartic(a[1], b[1]) + N::quartic(a[2], b[2]))
}

/// a × b.
#[inline(always)]
pub(in crate::query) fn minors<N: Arithmetic>(a: &Vector<N>, b: &Vector<N>) -> [N::Area; 3] {
    part(|| cross::<N>(a, b))
}

/// a·b, of areas and lengths.
#[inline(always)]
pub(in crate::query) fn volume<N: Arithmetic>(a: &[N::Area; 3], b: &Vector<N>) -> N::Volume {
    part(|| dot::<N>(a, b))
}

/// v·v, if each component errs by up to `error`.
#[inline(always)]
pub(super) fn squared<N: Arithmetic>(v: &[N::Area; 3], error: N::Area) -> Near<N::Quartic> {
    let value = along::<N>(v, v);
    if N::CERTAIN {
        return Near { value, error: N::Quartic::ZERO };
    }
    let sum = v[0].magnitude() + v[1].magnitude() + v[2].magnitude();
    let most = sum + sum + (error + error + error);
    Near { value, error: N::quartic(error, most) + value.error(SQUARES) }
}

impl<N: Arithmetic> Reach<N> {
    // Not inlined on s390x: see `scalar::axes::faces_in_double`.
    #[cfg_attr(not(target_arch = "s390x"), inline(always))]
    #[cfg_attr(target_arch = "s390x", inline(never))]
    pub(in crate::query) fn new(radius: N::Length, ball: Ball) -> Self {
        Self { radius, square: N::area(radius, radius), ball }
    }

    /// Whether a coordinate alone keeps all points to which these vectors go beyond the radius.
    /// That is certain in all systems, because rounding a difference keeps order.
    #[inline(always)]
    pub(in crate::query) fn is_beyond<const K: usize>(&self, vectors: &[Vector<N>; K]) -> bool {
        self.is_beyond_by(vectors, N::Length::ZERO)
    }

    /// The same for vectors whose coordinates err by up to `margin`.
    #[inline(always)]
    pub(in crate::query) fn is_beyond_by<const K: usize>(
        &self,
        vectors: &[Vector<N>; K],
        margin: N::Length,
    ) -> bool {
        let mut ends = [vectors[0]; 2];
        for v in &vectors[1..] {
            for i in 0..3 {
                (ends[0][i], ends[1][i]) = (least(ends[0][i], v[i]), greatest(ends[1][i], v[i]));
            }
        }
        let [low, high] = ends;
        let is_beyond = |x: N::Length| {
            let x = if N::CERTAIN { x } else { x - margin };
            x > self.radius
        };
        (0..3).any(|i| is_beyond(low[i]) || is_beyond(-high[i]))
    }

    /// Whether a point at `d` lies beyond the radius. The components of `d` err by a roundoff of
    /// themselves and of `slack`.
    #[inline(always)]
    pub(super) fn excludes(&self, d: &Vector<N>, slack: N::Length) -> Uncertain {
        let square = product::<N>(d, d);
        let gap = square - self.square;
        if N::CERTAIN {
            return self.ball.excludes(gap, N::Area::ZERO);
        }
        let sum = d[0].magnitude() + d[1].magnitude() + d[2].magnitude();
        let error = (square + self.square + N::area(slack, sum + slack)).error(SQUARE);
        self.ball.excludes(gap, error + N::Area::UNDERFLOW)
    }

    /// The same for a point alone; `None` in doubt, and out of range.
    #[inline(always)]
    pub(in crate::query) fn excludes_if_in_range(
        &self,
        d: &Vector<N>,
        slack: N::Length,
    ) -> Option<bool> {
        let size = greatest(greatest(largest(d), slack), self.radius);
        let is_known = N::CERTAIN || N::area(size, size).in_range();
        if is_known { self.excludes(d, slack).verdict() } else { None }
    }

    /// Whether a segment along `e` lies beyond, with vectors from both ends to the point. Out of
    /// line, because a triangle asks it three times.
    #[inline(never)]
    pub(super) fn excludes_edge(
        &self,
        [start, end]: [&Vector<N>; 2],
        e: &Vector<N>,
        c: &[N::Area; 3],
        slack: N::Length,
        errors: &Errors<N>,
    ) -> Uncertain {
        let at_start = self.excludes(start, slack);
        if !at_start.possible || largest(e) == N::Length::ZERO {
            return at_start;
        }
        let at_end = self.excludes(end, slack);
        if !at_end.possible {
            return at_end;
        }
        let is_before = Uncertain::not_below(-product::<N>(start, e), errors.dot);
        let is_after = Uncertain::not_below(product::<N>(end, e), errors.dot);
        let by_ends = is_before.and(at_start).or(is_after.and(at_end));
        if by_ends.certain {
            return by_ends;
        }
        let from_line = squared::<N>(c, errors.minor);
        let square = N::quartic(product::<N>(e, e), self.square);
        let error = from_line.error + square.error(PRODUCT);
        by_ends.or(self.ball.excludes(from_line.value - square, error)).and(at_start).and(at_end)
    }

    /// Whether a segment lies beyond; `None` in doubt.
    #[inline(always)]
    pub(in crate::query) fn excludes_segment(
        &self,
        ends: &[Vector<N>; 2],
        e: &Vector<N>,
        slack: N::Length,
    ) -> Option<bool> {
        let [start, end] = ends;
        if slack == N::Length::ZERO && self.is_beyond(ends) {
            return Some(true);
        }
        let size = greatest(greatest(largest(start), largest(end)), greatest(largest(e), slack));
        let errors = Errors::<N>::new(size, self.radius)?;
        let c = cross::<N>(e, start);
        self.excludes_edge([start, end], e, &c, slack, &errors).verdict()
    }
}

/// The greatest magnitude in vectors. No kernel asks how large numbers of several words are. LLVM 22
/// also fails to compile the question for a Cortex-M0.
#[inline(always)]
pub(in crate::query) fn largest_of<N: Arithmetic, const K: usize>(v: &[Vector<N>; K]) -> N::Length {
    if N::LARGE {
        return N::Length::ZERO;
    }
    v[1..].iter().fold(largest(&v[0]), |size, v| greatest(size, largest(v)))
}

/// The vectors from three vertices to a point, and along the edges.
#[inline(always)]
pub(in crate::query) fn around<N: Arithmetic>(
    point: &Vector<N>,
    vertices: &[Vector<N>; 3],
) -> [[Vector<N>; 3]; 2] {
    [
        three(|k| from::<N>(point, &vertices[k])),
        three(|k| from::<N>(&vertices[(k + 1) % 3], &vertices[k])),
    ]
}

/// The vectors from a point to both extreme corners of a box; by the numbers of its form.
#[inline(always)]
pub(in crate::query) fn to_corners<N: Arithmetic>(
    point: &Vector<N>,
    [p, q]: [&Vector<N>; 2],
    is_by_center: bool,
) -> [Vector<N>; 2] {
    let d = from::<N>(p, point);
    if is_by_center { [from::<N>(&d, q), three(|i| d[i] + q[i])] } else { [d, from::<N>(q, point)] }
}

/// The vectors from both ends of a segment to a point, and along the segment; by the numbers of its
/// form.
#[inline(always)]
pub(super) fn to_ends<N: Arithmetic>(
    point: &Vector<N>,
    [a, b]: [&Vector<N>; 2],
    is_by_center: bool,
) -> ([Vector<N>; 2], Vector<N>) {
    let d = from::<N>(point, a);
    if is_by_center {
        ([three(|i| d[i] + b[i]), from::<N>(&d, b)], three(|i| b[i] + b[i]))
    } else {
        ([d, from::<N>(point, b)], from::<N>(b, a))
    }
}
