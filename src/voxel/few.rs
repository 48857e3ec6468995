//! A few voxels: which voxels of a small block a triangle meets, by signs at the points where
//! planes cross inside the block.
//!
//! Whole meshes take 0.75 of the time with this file where triangles are no larger than a few
//! voxels: Spot (5,856 triangles) at 32 voxels along its longest side, `f32`, `f64` and I16F16, on
//! x86-64. The teapot at 32 takes 0.85; at 128 and above both are within 2 %.
//!
//! The block is the triangle's bounding box in voxels. Extend its outermost voxels outwards
//! without end: no voxel gains a point of the triangle. A triangle and a box, which may be
//! endless, are disjoint exactly if one of 13 axes separates them, and an axis does not separate
//! them if the box is endless towards the triangle. Therefore:
//!
//! * faces separate no voxel of the block from the triangle;
//! * seen along an axis, an edge separates a voxel exactly if the voxel's nearest corner along
//!   the edge's outward normal is a crossing of two planes inside the block and lies strictly
//!   outside the edge;
//! * the plane of the triangle separates a voxel exactly if its nearest corner along the normal,
//!   in either direction, is a crossing of three planes inside the block and lies strictly off the
//!   plane.
//!
//! So each crossing takes one sign. If a component of a normal is zero, two corners are equally
//! near and either serves: a face, or an edge seen along the component's axis, separates the same
//! voxels.
//!
//! # Error bound
//!
//! Lengths are in voxels from the block's first planes, in `f32` with roundoff u. L is the block's
//! greatest width. The place of a vertex or a plane errs by the error of `Near` and by the
//! rounding to `f32`, u·L: together η. (The subtraction of the block's first plane is exact, see
//! `Block::row`.)
//!
//! 1. A difference of two places errs by 2·η and its rounding, u·L: by less than 3·η.
//! 2. An area is the difference of two products of lengths up to L. It errs by 4·L·3·η, the
//!    squares of these errors, and 3·u·2·L² ≤ 6·η·L: by less than 19·η·L if η ≤ 2^-6, and 20·η·L
//!    is given.
//! 3. A volume is a sum of three products: of an area, at most 2·L², and a length. It errs by
//!    3·(19·η·L·L + 2·L²·3·η), their squares, and 5·u·6·L³ ≤ 30·η·L²: by less than 110·η·L², and
//!    112·η·L² is given.
//!
//! A sign of a number within its bound is computed exactly. If η > 2^-6, every sign is.

use core::cmp::Ordering;

use super::block::{Block, ForEach, OnAxis, area};
use super::grid::Grid;
use super::placed::Near;
use super::sign::{exact_turn, side};
use crate::arithmetic::{Each, Quad, THREE, compare};
use crate::scalar::Scalar;

/// Returns the voxels of a block of at most 32 that the triangle meets, a bit for each: x first,
/// then y, then z.
#[inline(always)]
pub(super) fn met<S: Scalar>(block: &Block, near: &Near<S>, grid: &Grid<S>) -> u32 {
    let (widths, widest) = (block.widths, block.widest());
    let error = block.error(near);
    let error = if error <= 1.0 / 64.0 { error } else { f32::INFINITY };
    let few = Few {
        block,
        strides: [1, widths[0], widths[0] * widths[1]],
        near,
        grid,
        area_error: f32::from(AREA) * error * widest,
    };
    let rows = block.rows(near);
    let views =
        [few.view(&rows, [1, 2], 0), few.view(&rows, [2, 0], 1), few.view(&rows, [0, 1], 2)];
    let mut apart = views[0].apart | views[1].apart | views[2].apart;
    if widths[0] > 1 && widths[1] > 1 && widths[2] > 1 {
        apart |= few.beside_plane(&rows, &views, f32::from(VOLUME) * error * widest * widest);
    }
    u32::MAX >> (32 - block.voxels() as u32) & !apart
}

/// See the error bound above.
pub(super) const AREA: u8 = 20;
const VOLUME: u8 = 112;

/// The view along an axis.
struct Outline {
    /// Twice the area of the triangle, approximately, and its exact sign.
    area: f32,
    sign: Ordering,
    /// The voxels that an edge separates.
    apart: u32,
}

/// A block and the triangle in it.
struct Few<'a, S> {
    block: &'a Block,
    /// The distance between the bits of neighbours on each axis.
    strides: [u32; 3],
    near: &'a Near<S>,
    grid: &'a Grid<S>,
    /// The error bound of an area.
    area_error: f32,
}

impl<S: Scalar> Few<'_, S> {
    /// The view along an axis; empty if no planes cross inside the block.
    #[inline(always)]
    fn view(&self, rows: &[OnAxis; 3], axes: [usize; 2], along: usize) -> Outline {
        let [u, v] = axes;
        let ([i, j], [x, y]) =
            ([self.block.widths[u], self.block.widths[v]], [self.strides[u], self.strides[v]]);
        if i == 1 || j == 1 {
            return Outline { area: 0.0, sign: Ordering::Equal, apart: 0 };
        }
        let (d, e) = (rows[u].edges, rows[v].edges);
        let rises = [self.rise(u), self.rise(v)];
        let (area, sign) = area(rows, axes, self.area_error, &self.near.points);
        // The normals (e, −d) of the edges point outward, unless the area is negative. If the
        // triangle appears as a line, both sides are outside, and its edges run both ways.
        let is_turned = sign == Ordering::Less;
        let flip = if is_turned { THREE } else { 0 };
        let (right, up) = (rises[1] ^ flip, !rises[0] ^ flip);
        let (error, minus) = (ForEach::splat(self.area_error), ForEach::splat(-self.area_error));

        let mut column = 1;
        for _ in 1..self.block.widths[along] {
            column = column << self.strides[along] | 1;
        }
        let mut apart = 0;
        for q in 1..j {
            let from_v = ForEach::splat(q as f32) - rows[v].at;
            for p in 1..i {
                let from_u = ForEach::splat(p as f32) - rows[u].at;
                let out = e * from_u - d * from_v;
                let mut ahead = out.exceeds(error) & THREE;
                let mut back = minus.exceeds(out) & THREE;
                if ahead | back != THREE {
                    (ahead, back) = self.exact_sides(axes, [p, q]);
                }
                let out = if is_turned { back } else { ahead };
                let at = p * x + q * y;
                // No branch: the processor cannot predict it.
                let mut clear =
                    |edges: u32, at: u32| apart |= (column * u32::from(edges != 0)) << at;
                clear(out & right & up, at);
                clear(out & !right & up, at - x);
                clear(out & right & !up, at - y);
                clear(out & !right & !up, at - x - y);
            }
        }
        Outline { area, sign, apart }
    }

    /// The edges that rise along an axis.
    #[inline(always)]
    fn rise(&self, i: usize) -> u32 {
        let [a, b, c] = self.near.points.each(|p| p[i]);
        u32::from(a < b) | u32::from(b < c) << 1 | u32::from(c < a) << 2
    }

    /// The voxels that the plane of the triangle separates.
    #[inline(always)]
    fn beside_plane(&self, rows: &[OnAxis; 3], views: &[Outline; 3], error: f32) -> u32 {
        let ([i, j, k], [_, y, z]) = (self.block.widths, self.strides);
        let first = |row: &OnAxis| row.at.to_array()[0];
        let [a, b, c] = [first(&rows[0]), first(&rows[1]), first(&rows[2])];
        let mut apart = 0;
        for r in 1..k {
            for q in 1..j {
                for p in 1..i {
                    let above = views[0].area * (p as f32 - a)
                        + views[1].area * (q as f32 - b)
                        + views[2].area * (r as f32 - c);
                    let above = if above.abs() > error {
                        compare(above, 0.0)
                    } else {
                        self.exact_above([p, q, r])
                    };
                    let less = |view: &Outline| u32::from(view.sign != above);
                    let [p, q, r] = [p - less(&views[0]), q - less(&views[1]), r - less(&views[2])];
                    apart |= u32::from(above != Ordering::Equal) << (p + q * y + r * z);
                }
            }
        }
        apart
    }

    /// The edges with a crossing of planes strictly on their outer side, then the edges with the
    /// crossing strictly on their inner side, seen along an axis.
    #[cold]
    #[inline(never)]
    fn exact_sides(&self, [u, v]: [usize; 2], [p, q]: [u32; 2]) -> (u32, u32) {
        let crossing = [self.plane(u, p), self.plane(v, q)];
        let points = self.near.points.each(|p| [p[u], p[v]]);
        let (mut ahead, mut back) = (0, 0);
        for k in 0..3 {
            match exact_turn(points[k], points[(k + 1) % 3], crossing) {
                Ordering::Less => ahead |= 1 << k,
                Ordering::Greater => back |= 1 << k,
                Ordering::Equal => {}
            }
        }
        (ahead, back)
    }

    /// The side of the triangle's plane on which a crossing lies.
    #[cold]
    #[inline(never)]
    fn exact_above(&self, [p, q, r]: [u32; 3]) -> Ordering {
        let crossing = [self.plane(0, p), self.plane(1, q), self.plane(2, r)];
        side(&self.near.points, crossing, crossing)
    }

    fn plane(&self, axis: usize, k: u32) -> S {
        self.grid.plane(axis, self.block.first[axis] as u32 + k)
    }
}
