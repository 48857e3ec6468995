//! A block of voxels: all that the box of a triangle comes to, and the triangle in it.

use super::pass::Bounds;
use super::placed::Near;
use super::slabs::Span;
use crate::arithmetic::{OfFour, Quad, each, greatest, least, three};
use crate::scalar::Scalar;
use crate::shape::Triangle;

/// The most voxels along an axis of a block.
const MOST: i64 = 1 << 10;

/// The most that a place may be from the truth: below, doubts are few. So extents are below 2^11.
const MOST_ERROR: f32 = 1.0 / 8192.0;

/// The roundoff of `f32`.
const ROUNDOFF: f32 = f32::EPSILON / 2.0;

/// A number for each vertex, or for the edge that begins there.
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
    /// The vertices, from the block's first plane on.
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
    /// How far a vertex or a plane may be from the truth.
    pub(super) error: f32,
    /// Along which edges each coordinate is constant.
    pub(super) level: [u32; 3],
}

impl<'a, S: Scalar> InBlock<'a, S> {
    /// `None` where they are so large, or so far away, that floats know little.
    #[inline(always)]
    pub(super) fn new(block: &'a Block, near: &Near<S>, triangle: &'a Triangle<S>) -> Option<Self> {
        let rows = [block.row(near, 0), block.row(near, 1), block.row(near, 2)];
        let [a, b, c] = [rows[0].at, rows[1].at, rows[2].at];
        let [x, y, z] = a.least(b).least(c).three();
        let low = least(least(least(x, y), z), 0.0);
        let [x, y, z] = a.greatest(b).greatest(c).three();
        let widest = greatest(greatest(greatest(x, y), z), block.widest()) - low;
        let error = near.error as f32 + ROUNDOFF * widest;
        let level = |i: usize| {
            let [a, b, c] = each(near.points, |p| p[i]);
            u32::from(a == b) | u32::from(b == c) << 1 | u32::from(c == a) << 2
        };
        let level = [level(0), level(1), level(2)];
        // Not the other way round: of NaN nothing is known.
        let is_known = error <= MOST_ERROR;
        is_known.then_some(Self { triangle, block, rows, widest, error, level })
    }

    /// About where the first vertex is.
    #[inline(always)]
    pub(super) fn first_vertex(&self) -> [f32; 3] {
        three(|i| self.rows[i].at.to_array()[0])
    }
}

impl Block {
    /// All voxels of the grid that the box of a triangle comes to, if no axis has more than
    /// [`MOST`].
    #[inline(always)]
    pub(super) fn of(bounds: &Bounds) -> Option<Self> {
        let [x, y, z] = &bounds.bounds;
        let width = |span: &Span| i64::from(span.last) - i64::from(span.first) + 1;
        let (i, j, k) = (width(x), width(y), width(z));
        // A small program does without, at the price of time.
        let fits = !cfg!(feature = "small") && i.max(j).max(k) <= MOST;
        let first = [x.first, y.first, z.first];
        fits.then_some(Self { first, widths: [i as u32, j as u32, k as u32] })
    }

    /// How many voxels it has.
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

    /// The triangle on an axis. To measure it from the block is exact: in `f64` a place is at
    /// least that of the block's plane, which is not negative, or next to it; of a block that the
    /// grid cuts there, that plane is number zero.
    #[inline(always)]
    pub(super) fn row<S: Scalar>(&self, near: &Near<S>, i: usize) -> OnAxis {
        let first = f64::from(self.first[i]);
        let [a, b, c] = &near.near;
        let at = [(a[i] - first) as f32, (b[i] - first) as f32, (c[i] - first) as f32];
        let at = ForEach::of_three(at);
        OnAxis { at, edges: at.turned() - at }
    }

    /// How far a vertex in a row may be from the truth, or a plane.
    #[inline(always)]
    pub(super) fn error<S: Scalar>(&self, near: &Near<S>) -> f32 {
        near.error as f32 + ROUNDOFF * self.widest()
    }
}
