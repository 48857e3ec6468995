//! A triangle seen along an axis, slab by slab: which cells it meets between two neighbouring
//! planes of the grid.
//!
//! A cell of the plane is met exactly if the part of the triangle in its slab has a point in
//! its width: both are convex. The ends of that part are vertices in the slab, and points where
//! an edge crosses one of the slab's two lines.
//!
//! # Error bound
//!
//! Lengths are in cells; u and η as in `plane`, and e = 4η. An edge from (u₀, v₀) to (u₁, v₁)
//! with dv = v₁ − v₀ ≥ 8e, as computed, crosses the line v = q at U, and
//! û = u₀ + (q − v₀)·ŝ with ŝ = du/dv.
//!
//! 1. Move the ends to where they were computed, by η at most in u and in v: the point of the
//!    moved edge at height q is within η, in u and in v, of a point of the edge itself, for the
//!    same share of the way. (The share may leave the edge by 2η/dv ≤ 1/16: 9/8·η then.) The
//!    plane of the grid is moved by η too. So the moved edge crosses within 9/8·η + (17/8)·η·|s|
//!    of U, with s the true slope.
//! 2. |s| ≤ (|du| + 2η)/(dv − 2η) ≤ 1.07·|ŝ| + 0.07 for the computed du and dv.
//! 3. The roundings of û are those of two differences, a quotient, a product and a sum, each of
//!    at most u·(|u₀| + |u₁|) ≤ η/4: less than 1.5·η.
//! 4. The plane that U is compared with errs by η. Together less than 4·η + 2.4·η·|ŝ|, and
//!    8·η·(1 + |ŝ|) is given.

use super::Rule;
use super::grid::Grid;
use super::place::{Place, locate};
use super::placed::Placed;
use super::sign::turn;
use crate::scalar::Scalar;

/// How many slabs are worked out at a time.
pub(super) const BLOCK: usize = 32;

/// A range of cells, both ends included; empty where the first is above the last.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Span {
    pub(super) first: i32,
    pub(super) last: i32,
}

impl Span {
    pub(super) const EMPTY: Self = Self { first: i32::MAX, last: i32::MIN };

    #[inline(always)]
    fn include(&mut self, first: i32, last: i32) {
        self.first = self.first.min(first);
        self.last = self.last.max(last);
    }
}

/// The slabs from `first` on, of the axis `v`, with the cells of the axis `u`.
#[inline(always)]
pub(super) fn spans<S: Scalar>(
    placed: &Placed<S>,
    grid: &Grid<S>,
    rule: Rule,
    [u, v]: [usize; 2],
    first: i32,
    out: &mut [Span],
) {
    out.fill(Span::EMPTY);
    let end = first + out.len() as i32;
    let mut include = |slab: i32, from: i32, to: i32| {
        if let Some(span) = out.get_mut((slab - first) as usize) {
            span.include(from, to);
        }
    };
    // What lies on the line below a slab, and in it: with a half-open cell both count in full.
    // What lies on the line above it is a limit of points in it then.
    let low = |place: Place| if rule == Rule::HalfOpen { place.above - 1 } else { place.at - 1 };
    let high = |place: Place| place.above - 1;
    let limit = |place: Place| if rule == Rule::HalfOpen { place.at - 1 } else { place.above - 1 };

    for vertex in &placed.at {
        let (at, slab) = (vertex[u], vertex[v]);
        include(slab.above - 1, low(at), high(at));
        if slab.at != slab.above {
            include(slab.at - 1, low(at), limit(at));
        }
    }
    for k in 0..3 {
        let (a, b) = (k, if k == 2 { 0 } else { k + 1 });
        let rises = placed.points[a][v] < placed.points[b][v];
        let (a, b) = if rises { (a, b) } else { (b, a) };
        // The lines between the ends, and those of them that belong to these slabs.
        let (from, to) = (placed.at[a][v].above, placed.at[b][v].at);
        let (from, to) = (from.max(first), to.min(end + 1));
        if from >= to {
            continue;
        }
        let edge = Edge::new(placed, [u, v], [a, b]);
        for line in from..to {
            let at = edge.place(grid, [u, v], line);
            include(line, low(at), high(at));
            include(line - 1, low(at), limit(at));
        }
    }
}

/// An edge that rises along v.
struct Edge<S> {
    ends: [[S; 2]; 2],
    from: [f64; 2],
    slope: f64,
    error: f64,
    low: Place,
    high: Place,
}

impl<S: Scalar> Edge<S> {
    #[inline(always)]
    fn new(placed: &Placed<S>, [u, v]: [usize; 2], [a, b]: [usize; 2]) -> Self {
        let [p, q] = [a, b].map(|k| [placed.near[k][u], placed.near[k][v]]);
        let (du, dv) = (q[0] - p[0], q[1] - p[1]);
        let slope = du / dv;
        let error = 8.0 * placed.error * (1.0 + slope.abs());
        Self {
            ends: [a, b].map(|k| [placed.points[k][u], placed.points[k][v]]),
            from: p,
            slope,
            error: if dv >= 32.0 * placed.error { error } else { f64::INFINITY },
            low: placed.at[a][u].least(placed.at[b][u]),
            high: placed.at[a][u].greatest(placed.at[b][u]),
        }
    }

    /// Where the edge crosses a line of v.
    #[inline(always)]
    fn place(&self, grid: &Grid<S>, [u, v]: [usize; 2], line: i32) -> Place {
        let x = self.from[0] + (f64::from(line) - self.from[1]) * self.slope;
        locate(x, self.error, self.low, self.high, |plane| {
            let point = [grid.plane(u, plane as u32), grid.plane(v, line as u32)];
            let [a, b] = self.ends;
            // Left of the edge, seen along it, is before it.
            turn(a, b, point, point).reverse()
        })
    }
}
