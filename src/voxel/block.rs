//! A block of voxels: all that the box of a triangle comes to, and the triangle in it.

use super::pass::Bounds;
use super::placed::Near;
use super::slabs::Span;
use crate::arithmetic::{OfFour, Quad};
use crate::scalar::Scalar;

/// The most voxels along an axis of a block.
pub(super) const MOST: u32 = 32;

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
pub(super) struct Row {
    /// The vertices, from the block's first plane on.
    pub(super) at: ForEach,
    /// The edges.
    pub(super) edges: ForEach,
}

impl Block {
    /// All voxels that the box of a triangle comes to, if none is beyond the grid, and no axis
    /// has more than [`MOST`].
    #[inline(always)]
    pub(super) fn of(bounds: &Bounds) -> Option<Self> {
        let Bounds { bounds: [x, y, z], is_within, .. } = bounds;
        let width = |span: &Span| i64::from(span.last) - i64::from(span.first) + 1;
        let (i, j, k) = (width(x), width(y), width(z));
        // A small program does without, at the price of time.
        let fits = !cfg!(feature = "small") && *is_within && i.max(j).max(k) <= i64::from(MOST);
        let first = [x.first, y.first, z.first];
        fits.then_some(Self { first, widths: [i as u32, j as u32, k as u32] })
    }

    /// How many voxels it has.
    #[inline(always)]
    pub(super) const fn voxels(&self) -> u32 {
        self.widths[0] * self.widths[1] * self.widths[2]
    }

    /// The greatest width.
    #[inline(always)]
    pub(super) fn widest(&self) -> f32 {
        let [x, y, z] = self.widths;
        x.max(y).max(z) as f32
    }

    /// The triangle on an axis. To measure it from the block is exact: in `f64` a place is at
    /// least that of the block's plane, which is not negative, or next to it.
    #[inline(always)]
    pub(super) fn row<S: Scalar>(&self, near: &Near<S>, i: usize) -> Row {
        let first = f64::from(self.first[i]);
        let [a, b, c] = &near.near;
        let at = [(a[i] - first) as f32, (b[i] - first) as f32, (c[i] - first) as f32];
        let at = ForEach::of_three(at);
        Row { at, edges: at.turned() - at }
    }

    /// How far a vertex in a row may be from the truth, or a plane.
    #[inline(always)]
    pub(super) fn error<S: Scalar>(&self, near: &Near<S>) -> f32 {
        near.error as f32 + ROUNDOFF * self.widest()
    }
}
