//! A triangle in a grid: where its vertices are.

use core::cmp::Ordering;

use super::grid::Grid;
use super::marks::{AxisMarks, Marks};
use super::place::{Place, Span, locate};
use super::sign::turn;
use crate::arithmetic::{greatest, least, three};
use crate::scalar::Scalar;
use crate::shape::Triangle;

/// A triangle in units of a grid, nearly.
#[derive(Clone, Copy, Debug)]
pub(super) struct Near<S> {
    pub(super) points: [[S; 3]; 3],
    /// The vertices in units of the grid.
    pub(super) near: [[f64; 3]; 3],
    /// No number of `near` is farther from the truth, and no plane; an infinity where floats
    /// cannot say.
    pub(super) error: f64,
}

impl<S: Scalar> Near<S> {
    #[cfg_attr(not(feature = "small"), inline(always))]
    #[cfg_attr(feature = "small", inline(never))]
    pub(super) fn new(triangle: &Triangle<S>, grid: &Grid<S>) -> Self {
        let points = triangle.points();
        let mut near = [[0.0; 3]; 3];
        let mut error = f64::INFINITY;
        if S::HAS_PLACES {
            let mut farthest = 1.0;
            for k in 0..3 {
                for i in 0..3 {
                    near[k][i] = grid.place(i, points[k][i]);
                    let size = near[k][i].abs();
                    farthest = if size <= farthest { farthest } else { size };
                }
            }
            error = grid.place_error(farthest);
        }
        Self { points, near, error }
    }

    /// Where a number, of which about the place is known, is among the limits of an axis.
    #[inline(always)]
    fn place(&self, grid: &Grid<S>, i: usize, marks: Marks, near: f64, x: impl Fn() -> S) -> Place {
        let end = Place::before(marks.limits(grid.resolution()[i]));
        locate(near - marks.shift(), self.error, Place::before(0), end, |limit| {
            grid.compare(i, marks.limit(limit), x())
        })
    }

    /// Where the least and the greatest coordinate on an axis are.
    #[inline(always)]
    pub(super) fn ends(&self, grid: &Grid<S>, i: usize, marks: Marks) -> [Place; 2] {
        // Rounding keeps order, so that the least place is that of the least coordinate.
        let [a, b, c] = &self.near;
        let low = least(least(a[i], b[i]), c[i]);
        let high = greatest(greatest(a[i], b[i]), c[i]);
        let [a, b, c] = &self.points;
        [
            self.place(grid, i, marks, low, || least(least(a[i], b[i]), c[i])),
            self.place(grid, i, marks, high, || greatest(greatest(a[i], b[i]), c[i])),
        ]
    }
}

/// The voxels in question.
#[derive(Clone, Copy, Debug)]
pub(super) struct Bounds {
    /// On each axis; on none, if there are none.
    pub(super) bounds: [Span; 3],
    /// Whether all of them are marked.
    pub(super) is_full: bool,
    /// Whether the triangle ends where the grid ends, or before.
    pub(super) is_within: bool,
}

impl Bounds {
    #[cfg_attr(not(feature = "small"), inline(always))]
    #[cfg_attr(feature = "small", inline(never))]
    pub(super) fn new<S: Scalar, M: AxisMarks>(near: &Near<S>, grid: &Grid<S>, marks: M) -> Self {
        let size = grid.resolution();
        let mut bounds = [Span::EMPTY; 3];
        let (mut narrow, mut is_within) = (0, true);
        for i in 0..3 {
            let marks = marks.of(i);
            let [least, greatest] = near.ends(grid, i, marks);
            let Span { first, last } = marks.span(least, greatest);
            narrow += u32::from(first == last && marks.are_cells());
            let end = size[i] as i32 - 1;
            is_within &= first >= 0 && last <= end;
            bounds[i] = Span { first: first.max(0), last: last.min(end) };
        }
        if bounds.iter().any(|span| span.is_empty()) {
            bounds = [Span { first: 0, last: -1 }; 3];
        }
        // A triangle whose box is one voxel wide on two axes: all of it is in their row.
        Self { bounds, is_full: narrow >= 2, is_within }
    }
}

/// A triangle in a grid, to be asked about the marks of each axis.
#[derive(Clone, Copy, Debug)]
pub(super) struct Placed<S, M> {
    pub(super) marks: M,
    pub(super) points: [[S; 3]; 3],
    pub(super) near: [[f64; 3]; 3],
    pub(super) error: f64,
    /// Where the vertices are among the limits of the marks, exactly.
    pub(super) at: [[Place; 3]; 3],
    /// The least and the greatest of them, on each axis.
    pub(super) least: [Place; 3],
    pub(super) greatest: [Place; 3],
}

impl<S: Scalar, M: AxisMarks> Placed<S, M> {
    #[cfg_attr(not(feature = "small"), inline(always))]
    #[cfg_attr(feature = "small", inline(never))]
    pub(super) fn new(near: &Near<S>, grid: &Grid<S>, marks: M) -> Self {
        let mut at = [[Place::before(0); 3]; 3];
        for k in 0..3 {
            for i in 0..3 {
                let x = || near.points[k][i];
                at[k][i] = near.place(grid, i, marks.of(i), near.near[k][i], x);
            }
        }
        let over = |of: fn(Place, Place) -> Place| three(|i| of(of(at[0][i], at[1][i]), at[2][i]));
        let (least, greatest) = (over(Place::least), over(Place::greatest));
        let Near { points, near, error } = *near;
        Self { marks, points, near, error, at, least, greatest }
    }

    /// The sign of the component of (b − a) × (c − a) that comes before axes j and k in turn.
    #[cold]
    #[inline(never)]
    pub(super) fn sign_of_normal(&self, j: usize, k: usize) -> Ordering {
        let [a, b, c] = self.points.map(|p| [p[j], p[k]]);
        turn(a, b, c, c)
    }
}
