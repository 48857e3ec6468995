//! A triangle in a grid: the places of its vertices, the voxels of its bounding box, and the point
//! where a line along x meets its plane.
//!
//! # Error bound of the plane
//!
//! Lengths are in cells. u is the roundoff of `f64`. η is the error of `Placed`, which bounds the
//! errors of vertices and planes and 8·u times any coordinate. D is the greatest extent of the
//! triangle. R = D + 2 exceeds any distance between a vertex and a corner of a voxel of its
//! bounding box.
//!
//! 1. A difference of two vertices errs by 2η and by its rounding, u·D ≤ η/4: by less than 3η.
//!    A component of the normal is a difference of two products of such. It errs by
//!    2·(2·3η·D + 9η²) and by three roundings of at most 2·D², 6u·D² ≤ 1.5·η·D. For D ≥ 16η
//!    that is less than 16·η·D; for D below, the component itself is below 32·η·D, and so is
//!    any computed one. So beyond 32·η·D its sign is right. Else the sign is asked exactly.
//! 2. f(P) = n·(P − a) at a corner P of the grid errs by Σ|δn|·R = 48·η·D·R, by
//!    Σ|n|·2η ≤ 12·η·D² for a and for P, and by the roundings of x̂ below, together less than
//!    64·η·D·R.
//! 3. x̂ = a_x + (−n_z/n_x)·(z − a_z) + (−n_y/n_x)·(y − a_y) is a zero of f without that error,
//!    up to 8 roundings of terms of at most R·(|n_y| + |n_z|)/|n_x| and two roundings of
//!    u·|a_x| ≤ η/8. Times |n_x| they are less than 8·u·R·4·D² + 0.5·η·D² < 9·η·D·R.
//! 4. So |f| at x̂ ± 128·η·D·R/|n_x| is more than its error: X, where f is zero, is within.
//!    If that is half a cell or more, floats say nothing.

use core::cmp::Ordering;

use super::grid::Grid;
use super::place::{AxisMarks, Level, Marks, Place, Span, locate};
use super::sign::{self, side};
use crate::arithmetic::{Each, exp2, greatest, least, three, turn};
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
        sign::turn(a, b, c, c)
    }
}

/// Longer edges, in cells, may have products that overflow.
const LONGEST: f64 = exp2(500);

/// The plane of a triangle that is not parallel to x, oriented so that its normal points to
/// greater x.
#[derive(Clone, Copy, Debug)]
pub(super) struct Plane {
    from: [f64; 3],
    /// The slopes dx/dy and dx/dz.
    slopes: [f64; 2],
    error: f64,
    /// The signs of the normal's y and z.
    pub(super) signs: [Ordering; 2],
    is_turned: bool,
}

impl Plane {
    /// `None` if the plane is parallel to x or the triangle is degenerate.
    #[cfg_attr(not(feature = "small"), inline(always))]
    #[cfg_attr(feature = "small", inline(never))]
    pub(super) fn new<S: Scalar, M: AxisMarks>(placed: &Placed<S, M>) -> Option<Self> {
        let [a, b, c] = placed.near;
        let (e, f) = (three(|i| b[i] - a[i]), three(|i| c[i] - a[i]));
        let mut size = 0.0;
        for i in 0..3 {
            for length in [e[i].abs(), f[i].abs(), (c[i] - b[i]).abs()] {
                size = if length <= size { size } else { length };
            }
        }
        // Where products may overflow, floats say nothing.
        let error = if size < LONGEST { placed.error } else { f64::INFINITY };
        let doubt = 32.0 * error * size;
        let mut normal = [0.0; 3];
        let mut signs = [Ordering::Equal; 3];
        for i in 0..3 {
            let (i, j, k) = turn(i);
            normal[i] = e[j] * f[k] - e[k] * f[j];
            signs[i] = if normal[i] > doubt {
                Ordering::Greater
            } else if normal[i] < -doubt {
                Ordering::Less
            } else {
                placed.sign_of_normal(j, k)
            };
        }
        let is_turned = match signs[0] {
            Ordering::Equal => return None,
            Ordering::Less => true,
            Ordering::Greater => false,
        };
        let facing = |sign: Ordering| if is_turned { sign.reverse() } else { sign };
        let per_x = 1.0 / normal[0];
        Some(Self {
            from: a,
            slopes: [-normal[1] * per_x, -normal[2] * per_x],
            error: 128.0 * error * size * (size + 2.0) * per_x.abs(),
            signs: [facing(signs[1]), facing(signs[2])],
            is_turned,
        })
    }

    /// Finds the place where the line along x through (y, z) meets the plane. It is not before
    /// `low` and not behind `high`.
    #[cfg_attr(not(feature = "small"), inline(always))]
    #[cfg_attr(feature = "small", inline(never))]
    pub(super) fn place<S: Scalar, M: AxisMarks>(
        &self,
        placed: &Placed<S, M>,
        grid: &Grid<S>,
        [y, z]: [Level; 2],
        low: Place,
        high: Place,
    ) -> Place {
        let [from_x, from_y, from_z] = self.from;
        let [slope_y, slope_z] = self.slopes;
        let marks = placed.marks.of(0);
        let x = from_x + slope_z * (z.middle() - from_z) + slope_y * (y.middle() - from_y);
        locate(x - marks.shift(), self.error, low, high, |k| {
            let planes = [grid.planes(0, marks.limit(k)), grid.planes(1, y), grid.planes(2, z)];
            let order = side(&placed.points, planes.each(|p| p[0]), planes.each(|p| p[1]));
            if self.is_turned { order.reverse() } else { order }
        })
    }
}
