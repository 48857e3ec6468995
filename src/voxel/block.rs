//! A block of voxels: the voxels of a triangle's bounding box, and the triangle in `f32`.

use core::cmp::Ordering;

use super::place::Span;
use super::placed::{Bounds, Near};
use super::sign::exact_area;
use crate::arithmetic::{Each, OfFour, Quad, compare, greatest, least, three};
use crate::scalar::Scalar;
use crate::shape::Triangle;

/// The most voxels along an axis of a block.
const MOST: i64 = 1 << 10;

/// The greatest error of a place. Below it doubts are rare, and extents are below 2^11.
const MOST_ERROR: f32 = 1.0 / 8192.0;

/// The roundoff of `f32`.
const ROUNDOFF: f32 = f32::EPSILON / 2.0;

/// A number for each vertex, or for each edge, by its first vertex.
pub(super) type ForEach = <f32 as OfFour>::Quad;

/// A block of voxels.
#[derive(Clone, Copy, Debug)]
pub(super) struct Block {
    pub(super) first: [i32; 3],
    pub(super) widths: [u32; 3],
}

/// A triangle on an axis of a block.
#[derive(Clone, Copy)]
pub(super) struct OnAxis {
    /// The vertices, measured from the block's first plane.
    pub(super) at: ForEach,
    /// The edges.
    pub(super) edges: ForEach,
}

/// A triangle in a block, in `f32`.
#[derive(Clone, Copy)]
pub(super) struct InBlock<'a, S> {
    pub(super) triangle: &'a Triangle<S>,
    pub(super) block: &'a Block,
    pub(super) rows: [OnAxis; 3],
    /// The greatest extent, on any axis, of triangle and block together: one at least.
    pub(super) widest: f32,
    /// The error bound of a vertex or a plane.
    pub(super) error: f32,
    /// For each axis, the edges along which its coordinate is constant.
    pub(super) level: [u32; 3],
}

/// Twice the area of a triangle seen along an axis, approximately, and its exact sign.
#[inline(always)]
pub(super) fn area<S: Scalar>(
    rows: &[OnAxis; 3],
    [u, v]: [usize; 2],
    error: f32,
    points: &[[S; 3]; 3],
) -> (f32, Ordering) {
    let (d, e) = (rows[u].edges, rows[v].edges);
    let area = (d * e.turned() - e * d.turned()).to_array()[0];
    let sign = if area.abs() > error { compare(area, 0.0) } else { exact_area(points, [u, v]) };
    (area, sign)
}

impl<'a, S: Scalar> InBlock<'a, S> {
    /// `None` if the block is so large or so far from the origin that the error exceeds
    /// [`MOST_ERROR`].
    #[inline(always)]
    pub(super) fn new(block: &'a Block, near: &Near<S>, triangle: &'a Triangle<S>) -> Option<Self> {
        let rows = block.rows(near);
        let [a, b, c] = rows.each(|row| row.at);
        let [x, y, z] = a.least(b).least(c).three();
        let low = least(least(least(x, y), z), 0.0);
        let widest = greatest(a.greatest(b).greatest(c).most(), block.widest()) - low;
        let error = near.error as f32 + ROUNDOFF * widest;
        let level = three(|i| {
            let [a, b, c] = near.points.each(|p| p[i]);
            u32::from(a == b) | u32::from(b == c) << 1 | u32::from(c == a) << 2
        });
        // `<=`, so that a NaN fails.
        let is_known = error <= MOST_ERROR;
        is_known.then_some(Self { triangle, block, rows, widest, error, level })
    }

    /// The first vertex, approximately.
    #[inline(always)]
    pub(super) fn first_vertex(&self) -> [f32; 3] {
        three(|i| self.rows[i].at.to_array()[0])
    }
}

impl Block {
    /// The voxels of the grid in a triangle's bounding box; `None` if an axis has more than
    /// [`MOST`].
    #[inline(always)]
    pub(super) fn of(bounds: &Bounds) -> Option<Self> {
        let [x, y, z] = &bounds.bounds;
        let width = |span: &Span| i64::from(span.last) - i64::from(span.first) + 1;
        let (i, j, k) = (width(x), width(y), width(z));
        // The feature `small` does without blocks: less code, more time.
        let fits = !cfg!(feature = "small") && i.max(j).max(k) <= MOST;
        let first = [x.first, y.first, z.first];
        fits.then_some(Self { first, widths: [i as u32, j as u32, k as u32] })
    }

    /// The number of voxels.
    #[inline(always)]
    pub(super) const fn voxels(&self) -> u64 {
        let [x, y, z] = self.widths;
        x as u64 * y as u64 * z as u64
    }

    /// The greatest width.
    #[inline(always)]
    pub(super) fn widest(&self) -> f32 {
        let [x, y, z] = self.widths;
        x.max(y).max(z) as f32
    }

    /// The triangle on each axis. The subtraction of the block's first plane is exact in `f64`: if
    /// the plane is not number zero, a place is at least the plane's place, which is not
    /// negative, or next to it.
    #[inline(always)]
    pub(super) fn rows<S: Scalar>(&self, near: &Near<S>) -> [OnAxis; 3] {
        three(|i| {
            let first = f64::from(self.first[i]);
            let at = ForEach::of_three(near.near.each(|p| (p[i] - first) as f32));
            OnAxis { at, edges: at.turned() - at }
        })
    }

    /// The error bound of a vertex in a row, or of a plane.
    #[inline(always)]
    pub(super) fn error<S: Scalar>(&self, near: &Near<S>) -> f32 {
        near.error as f32 + ROUNDOFF * self.widest()
    }
}
