//! The view of a triangle along an axis, slab by slab: the cells that it meets between two
//! neighbouring planes of the grid.
//!
//! A slab of v is cut into cells by planes of u. The triangle meets a cell exactly if its part in
//! the slab, which is convex, has a point in the cell's width. The ends of that part are vertices
//! in the slab, and points where an edge crosses one of the slab's two planes.
//!
//! # Error bound
//!
//! Lengths are in cells; u and η as in `Plane`, and e = 4η. An edge from (u₀, v₀) to (u₁, v₁)
//! with dv = v₁ − v₀ ≥ 8e, as computed, crosses the line v = q at U, and
//! û = u₀ + (q − v₀)·ŝ with ŝ = du/dv.
//!
//! 1. Move the ends to their computed places, by at most η in u and in v. The point of the moved
//!    edge at height q is within η, in u and in v, of the point of the exact edge with the same
//!    parameter. (The parameter may leave the edge by 2η/dv ≤ 1/16: 9/8·η then.) The plane of the
//!    grid moves by η too. Therefore the moved edge crosses within 9/8·η + (17/8)·η·|s| of U,
//!    where s is the exact slope.
//! 2. |s| ≤ (|du| + 2η)/(dv − 2η) ≤ 1.07·|ŝ| + 0.07 for the computed du and dv.
//! 3. û takes two differences, a quotient, a product and a sum. Each rounding is at most
//!    u·(|u₀| + |u₁|) ≤ η/4: less than 1.5·η together.
//! 4. The plane to compare with U errs by η. The sum is less than 4·η + 2.4·η·|ŝ|; the code
//!    takes 8·η·(1 + |ŝ|).

use super::grid::Grid;
use super::place::{AxisMarks, Marks, Place, Span, locate};
use super::placed::Placed;
use super::sign::turn;
use crate::arithmetic::Each;
use crate::scalar::Scalar;

/// The number of slabs that are computed together.
pub(super) const BLOCK: usize = 8;

/// For each interval of axis `v`, beginning with `first`: the intervals of axis `u` that the
/// triangle meets in it, seen along the third axis.
#[cfg_attr(not(feature = "small"), inline(always))]
#[cfg_attr(feature = "small", inline(never))]
pub(super) fn spans<S: Scalar, M: AxisMarks>(
    placed: &Placed<S, M>,
    grid: &Grid<S>,
    axes: [usize; 2],
    first: i32,
    out: &mut [Span],
) {
    out.fill(Span::EMPTY);
    let [u, v] = axes;
    let [along, across] = [placed.marks.of(u), placed.marks.of(v)];
    let end = first + out.len() as i32;
    let mut include = |slab: i32, place: Place, is_open: bool| {
        if let Some(span) = out.get_mut((slab - first) as usize) {
            *span = span.joined(along.at(place, is_open));
        }
    };
    // A point on the greatest plane of a half-open slab is a limit of points of the slab.
    let is_open = across == Marks::HalfOpen;

    for vertex in &placed.at {
        let (place, slab) = (vertex[u], vertex[v]);
        let is_on_limit = slab.at != slab.above;
        if across.are_cells() {
            include(slab.above - 1, place, false);
        }
        if is_on_limit {
            let slab = if across.are_cells() { slab.at - 1 } else { slab.at };
            include(slab, place, is_open);
        }
    }
    for k in 0..3 {
        let ends = rising(placed, v, k);
        // The limits of these slabs that lie between the ends.
        let (from, to) = (placed.at[ends[0]][v].above, placed.at[ends[1]][v].at);
        let (from, to) = (from.max(first), to.min(end + 1));
        if from >= to {
            continue;
        }
        let edge = Edge::new(placed, axes, ends);
        for limit in from..to {
            let place = edge.place(placed, grid, axes, limit);
            include(limit, place, false);
            if across.are_cells() {
                include(limit - 1, place, is_open);
            }
        }
    }
}

/// The same for consecutive intervals of `v` as one slab. If the marks are middles, the slab has
/// all numbers between the first and the last.
pub(super) fn span<S: Scalar, M: AxisMarks>(
    placed: &Placed<S, M>,
    grid: &Grid<S>,
    axes: [usize; 2],
    slab: Span,
) -> Span {
    let [u, v] = axes;
    let [along, across] = [placed.marks.of(u), placed.marks.of(v)];
    let [first, last] = across.ends(slab).each(|limit| limit.from);
    let mut span = Span::EMPTY;
    let mut include = |place: Place, is_open| span = span.joined(along.at(place, is_open));
    // A point on the greatest plane of a half-open slab is a limit of points of the slab.
    let is_open = |limit: i32| across == Marks::HalfOpen && limit == last;
    for vertex in &placed.at {
        let Place { at, above } = vertex[v];
        if above > first && at <= last {
            include(vertex[u], at < above && is_open(at));
        }
    }
    for k in 0..3 {
        let ends = rising(placed, v, k);
        let (from, to) = (placed.at[ends[0]][v].above, placed.at[ends[1]][v].at);
        for limit in [first, last] {
            if (from..to).contains(&limit) {
                let edge = Edge::new(placed, axes, ends);
                include(edge.place(placed, grid, axes, limit), is_open(limit));
            }
        }
    }
    span
}

/// The ends of edge k, the lower along v first.
#[inline(always)]
pub(super) fn rising<S: Scalar, M: AxisMarks>(
    placed: &Placed<S, M>,
    v: usize,
    k: usize,
) -> [usize; 2] {
    let next = if k == 2 { 0 } else { k + 1 };
    if placed.points[k][v] < placed.points[next][v] { [k, next] } else { [next, k] }
}

/// An edge that rises along v.
pub(super) struct Edge<S> {
    ends: [[S; 2]; 2],
    from: [f64; 2],
    slope: f64,
    error: f64,
    low: Place,
    high: Place,
}

impl<S: Scalar> Edge<S> {
    #[cfg_attr(not(feature = "small"), inline(always))]
    #[cfg_attr(feature = "small", inline(never))]
    pub(super) fn new<M: AxisMarks>(
        placed: &Placed<S, M>,
        [u, v]: [usize; 2],
        [a, b]: [usize; 2],
    ) -> Self {
        let [p, q] = [a, b].each(|k| [placed.near[k][u], placed.near[k][v]]);
        let (du, dv) = (q[0] - p[0], q[1] - p[1]);
        let slope = du / dv;
        let error = 8.0 * placed.error * (1.0 + slope.abs());
        Self {
            ends: [a, b].each(|k| [placed.points[k][u], placed.points[k][v]]),
            from: p,
            slope,
            error: if dv >= 32.0 * placed.error { error } else { f64::INFINITY },
            low: placed.at[a][u].least(placed.at[b][u]),
            high: placed.at[a][u].greatest(placed.at[b][u]),
        }
    }

    /// Finds the place where the edge crosses a limit of v, not above its higher end.
    #[cfg_attr(not(feature = "small"), inline(always))]
    #[cfg_attr(feature = "small", inline(never))]
    pub(super) fn place<M: AxisMarks>(
        &self,
        placed: &Placed<S, M>,
        grid: &Grid<S>,
        [u, v]: [usize; 2],
        limit: i32,
    ) -> Place {
        let [along, across] = [placed.marks.of(u), placed.marks.of(v)];
        let up = f64::from(limit) + across.shift() - self.from[1];
        let x = self.from[0] + up * self.slope - along.shift();
        locate(x, self.error, self.low, self.high, |k| {
            let [p, q] = [grid.planes(u, along.limit(k)), grid.planes(v, across.limit(limit))];
            let [a, b] = self.ends;
            // A point left of the rising edge is before it on u.
            turn(a, b, [p[0], q[0]], [p[1], q[1]]).reverse()
        })
    }
}
