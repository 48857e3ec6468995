//! A line among the planes of a grid: in which order it meets them.
//!
//! # Error bound
//!
//! Lengths are in cells; η is the error of a place, as in `placed`, for places no farther than
//! the anchor a and the grid. A component of the direction, d, is a difference times a
//! reciprocal: it errs by less than 6u·|d|. The line meets plane k at t = (k − a)/d. The
//! difference errs by 2η and its rounding, at most η/8; t by that over |d|, and by eight roundings
//! of itself, each u·|k − a|/|d| ≤ η/(4·|d|). Together less than 5·η/|d|. Beyond [`LONGEST`] a length or
//! its inverse may have fewer digits or be infinite, and there is no bound.

use core::cmp::Ordering;

use super::grid::Grid;
use super::place::{Level, Marks, Place, locate};
use super::sign::{against_point, line_turn};
use crate::arithmetic::{Each, Parts, compare, exp2};
use crate::robust::certain_sign;
use crate::scalar::Scalar;

/// The greatest length, and the inverse of the least, with an error bound.
const LONGEST: f64 = exp2(1000);

/// The ends of a line.
#[derive(Clone, Copy, Debug)]
pub(super) enum Limit {
    /// At t = 0.
    Anchor,
    /// At t = 1, where the line is `to`: `from` is the anchor.
    To,
    /// At this t.
    Times(Parts),
}

/// The line anchor + t·(to − from).
#[derive(Clone, Copy, Debug)]
pub(super) struct Line<S> {
    pub(super) anchor: [S; 3],
    pub(super) from: [S; 3],
    pub(super) to: [S; 3],
    /// The anchor in cells, 1/(to − from) in cells, and the error bound of a t.
    near: [f64; 3],
    per_step: [f64; 3],
    error: [f64; 3],
}

impl<S: Scalar> Line<S> {
    pub(super) fn new(grid: &Grid<S>, anchor: [S; 3], [from, to]: [[S; 3]; 2]) -> Self {
        let (mut near, mut per_step) = ([0.0; 3], [0.0; 3]);
        let mut error = [f64::INFINITY; 3];
        if S::HAS_PLACES {
            let [nx, ny, nz] = grid.resolution();
            let mut farthest = f64::from(nx.max(ny).max(nz));
            for i in 0..3 {
                near[i] = grid.place(i, anchor[i]);
                per_step[i] = 1.0 / grid.length(i, from[i], to[i]);
                let size = near[i].abs();
                farthest = if size <= farthest { farthest } else { size };
            }
            let place_error = grid.place_error(farthest);
            let has_bound = |d: f64| (1.0 / LONGEST..=LONGEST).contains(&d.abs());
            error = per_step
                .each(|d| if has_bound(d) { 5.0 * place_error * d.abs() } else { f64::INFINITY });
        }
        Self { anchor, from, to, near, per_step, error }
    }

    /// Returns the direction of the line along an axis: `Greater` if it rises.
    pub(super) fn way(&self, axis: usize) -> Ordering {
        compare(self.to[axis], self.from[axis])
    }

    /// Returns approximately the t at which the line meets plane k of an axis.
    #[inline(always)]
    fn time(&self, axis: usize, k: i32) -> f64 {
        (f64::from(k) - self.near[axis]) * self.per_step[axis]
    }

    /// Compares the t of two planes of different axes, exactly. The line is parallel to neither.
    #[inline(always)]
    pub(super) fn order(&self, grid: &Grid<S>, a: (usize, i32), b: (usize, i32)) -> Ordering {
        let gap = self.time(a.0, a.1) - self.time(b.0, b.1);
        let error = self.error[a.0] + self.error[b.0];
        // A time may overflow where its error does not.
        let sign = if gap.is_finite() { certain_sign(gap, error) } else { 0 };
        match sign {
            0 => self.exact_order(grid, a, b),
            sign => sign.cmp(&0),
        }
    }

    #[cold]
    #[inline(never)]
    fn exact_order(&self, grid: &Grid<S>, (i, k): (usize, i32), (j, l): (usize, i32)) -> Ordering {
        let pick = |p: &[S; 3]| [p[i], p[j]];
        let point = [grid.plane(i, k as u32), grid.plane(j, l as u32)];
        let order = line_turn(pick(&self.anchor), [pick(&self.from), pick(&self.to)], point);
        // If both axes rise, a point left of the line has the lesser t on the first axis.
        if self.way(i) == self.way(j) { order.reverse() } else { order }
    }

    /// Returns the place of one end of the line on an axis.
    pub(super) fn at_limit(&self, grid: &Grid<S>, axis: usize, limit: Limit) -> Place {
        let place = |compare: &dyn Fn(i32) -> Ordering| search(grid, axis, compare);
        match limit {
            Limit::Anchor => place(&|k| grid.compare(axis, Level::plane(k), self.anchor[axis])),
            Limit::To => place(&|k| grid.compare(axis, Level::plane(k), self.to[axis])),
            Limit::Times(t) => place(&|k| {
                let way = [self.from[axis], self.to[axis]];
                against_point(grid.plane(axis, k as u32), self.anchor[axis], way, t)
            }),
        }
    }

    /// Returns the place of the line on an axis at the point where it meets a plane of another.
    pub(super) fn at_plane(&self, grid: &Grid<S>, axis: usize, plane: (usize, i32)) -> Place {
        search(grid, axis, &|k| match self.way(axis) {
            Ordering::Equal => grid.compare(axis, Level::plane(k), self.anchor[axis]),
            Ordering::Greater => self.order(grid, (axis, k), plane),
            Ordering::Less => self.order(grid, (axis, k), plane).reverse(),
        })
    }
}

/// Finds a place by bisection; `plane(k)` compares plane k with the point.
fn search<S: Scalar>(grid: &Grid<S>, axis: usize, plane: &dyn Fn(i32) -> Ordering) -> Place {
    let end = Place::before(Marks::Closed.limits(grid.resolution()[axis]));
    locate(0.0, f64::INFINITY, Place::before(0), end, plane)
}
