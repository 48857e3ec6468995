//! A triangle in a grid: the places of its vertices and the voxels of its bounding box.

use core::cmp::Ordering;

use super::grid::Grid;
use super::place::{AxisMarks, Marks, Place, Span, locate};
use super::sign::turn;
use crate::arithmetic::{Each, greatest, least, three};
use crate::scalar::Scalar;
use crate::shape::Triangle;

/// A triangle in cells of a grid, approximately.
#[derive(Clone, Copy, Debug)]
pub(super) struct Near<S> {
    pub(super) points: [[S; 3]; 3],
    /// The vertices in cells, from the first planes.
    pub(super) near: [[f64; 3]; 3],
    /// The error bound of a number of `near` and of a plane; infinite if floats have no bound.
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

    /// Finds the place of `x` among the limits of an axis, given its approximate place `near`.
    #[inline(always)]
    fn place(&self, grid: &Grid<S>, i: usize, marks: Marks, near: f64, x: impl Fn() -> S) -> Place {
        let end = Place::before(marks.limits(grid.resolution()[i]));
        locate(near - marks.shift(), self.error, Place::before(0), end, |limit| {
            grid.compare(i, marks.limit(limit), x())
        })
    }

    /// Finds the places of the least and of the greatest coordinate on an axis.
    #[inline(always)]
    pub(super) fn ends(&self, grid: &Grid<S>, i: usize, marks: Marks) -> [Place; 2] {
        // Rounding is monotone: the least coordinate has the least place.
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

/// The voxels of a triangle's bounding box in the grid.
#[derive(Clone, Copy, Debug)]
pub(super) struct Bounds {
    /// Their range on each axis; empty on every axis if there are none.
    pub(super) bounds: [Span; 3],
    /// Whether every one is marked.
    pub(super) is_full: bool,
    /// Whether the grid holds the whole bounding box.
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
        // A bounding box one voxel wide on two axes: the triangle meets every voxel of the row.
        Self { bounds, is_full: narrow >= 2, is_within }
    }
}

/// A triangle in a grid, with the exact places of its vertices for the marks of each axis.
#[derive(Clone, Copy, Debug)]
pub(super) struct Placed<S, M> {
    pub(super) marks: M,
    pub(super) points: [[S; 3]; 3],
    pub(super) near: [[f64; 3]; 3],
    pub(super) error: f64,
    /// The exact places of the vertices among the limits of the marks.
    pub(super) at: [[Place; 3]; 3],
    /// The least and the greatest place on each axis.
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

    /// The sign of component i of (b − a) × (c − a), where i, j, k is a rotation of the axes.
    #[cold]
    #[inline(never)]
    pub(super) fn sign_of_normal(&self, j: usize, k: usize) -> Ordering {
        let [a, b, c] = self.points.each(|p| [p[j], p[k]]);
        turn(a, b, c, c)
    }
}
