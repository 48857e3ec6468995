//! Rows of a block, four at a time.
//!
//! What is seen along an axis leaves an interval of each slab (`view`). What is left is the plane.
//! The plane of the triangle comes in a row of voxels to an interval of x: about its place at the
//! middle of the row, half of its slopes in y and z to either side. Where it is parallel to x, it
//! separates nothing that is not separated in the view along x.
//!
//! Each end is taken a little too low and a little too high. Where both lie between the same two
//! planes, so does the end. Where they do not, the pairs of the triangle and the voxels between
//! tell: what the triangle meets of a row is in one piece.
//!
//! # Error bound
//!
//! Lengths are as in `view`. The way along x from the plane to a corner of the block, times the x of
//! the normal, is a volume, which errs as in `few`. By the slopes it takes 20 roundings, of 15·L³ at
//! most. Gappa adds them up, and 152·η·L² is enough. Beyond 20·η·L the normal's x has its true sign.

use core::cmp::Ordering;

use super::block::{Block, InBlock};
use super::ends::{four, lanes, nth, same, whole};
use super::few::AREA;
use super::grid::Grid;
use super::placed::Near;
use super::view::View;
use crate::scalar::Scalar;
use crate::shape::Triangle;

/// See the error bound above.
const PLANE: u8 = 152;

/// Farther than anything in a block.
const FAR: f32 = 1e30;
/// How many slabs of y are worked out at a time.
const SLABS: i32 = 32;
const QUADS: usize = SLABS as usize / 4;

/// Where the plane is, in the row (0, 0).
struct Plane {
    middle: f32,
    slopes: [f32; 2],
    /// From the middle to the least end, too low and too high, and to the greatest.
    reach: [f32; 4],
}

/// Four layers: their intervals of x and of y, the latter rounded, and which have none.
struct Layers {
    x: [[f32; 4]; 4],
    y: [[f32; 4]; 4],
    empty: u32,
}

/// A block of a grid, and a triangle in it.
struct Rows<'a, S> {
    inside: InBlock<'a, S>,
    grid: &'a Grid<S>,
}

/// Hands on the rows of a block that the triangle meets: of which y and z, and the first and the
/// last x. Where floats know nothing, it hands on none, and returns `false`.
#[inline(always)]
pub(super) fn each<S: Scalar>(
    block: &Block,
    near: &Near<S>,
    triangle: &Triangle<S>,
    grid: &Grid<S>,
    mut f: impl FnMut([u32; 2], [u32; 2]),
) -> bool {
    let Some(inside) = InBlock::new(block, near, triangle) else { return false };
    let first = block.first.map(|first| first as u32);
    let from = |i: usize, k: i32| first[i] + k as u32;
    Rows { inside, grid }
        .each(|[y, z], [first, last]| f([from(1, y), from(2, z)], [from(0, first), from(0, last)]))
        .is_some()
}

impl<S: Scalar> Rows<'_, S> {
    /// `None` where floats know nothing.
    #[inline(always)]
    fn each(&self, mut f: impl FnMut([i32; 2], [i32; 2])) -> Option<()> {
        let view = |u: usize, v: usize| View::new(&self.inside, [u, v]);
        let (xy, xz, yz) = (view(0, 1)?, view(0, 2)?, view(1, 2)?);
        let plane = self.plane(&xy, &xz, &yz)?;
        let [_, height, depth] = self.inside.block.widths.map(|width| width as i32);
        let reach = same(plane.reach);
        let [slope, ..] = same([plane.slopes[0]; 4]);

        let mut from_y = 0;
        while from_y < height {
            let to_y = height.min(from_y + SLABS);
            let mut in_xy = [xy.ends(from_y); QUADS];
            for (q, ends) in in_xy.iter_mut().enumerate().skip(1) {
                let y = from_y + 4 * q as i32;
                if y < to_y {
                    *ends = xy.ends(y);
                }
            }
            for from_z in (0..depth).step_by(4) {
                let layers = Layers::new(&xz, &yz, from_z);
                for z in from_z..depth.min(from_z + 4) {
                    let n = (z - from_z) as usize % 4;
                    // Of these y the triangle may come to the first and the last, and surely does
                    // to those from the second to the third.
                    let y = whole(nth(&layers.y, n));
                    let (first, last) = (y[0].max(from_y), y[3].min(to_y - 1));
                    if layers.empty >> n & 1 == 1 || first > last {
                        continue;
                    }
                    let layer = same(nth(&layers.x, n));
                    let [middle, ..] = same([plane.middle + z as f32 * plane.slopes[1]; 4]);
                    for q in (first - from_y) / 4..(last - from_y) / 4 + 1 {
                        let from = from_y + 4 * q;
                        let middle = middle + four(from) * slope;
                        let [a, b, c, d] = reach;
                        let plane = [middle + a, middle + b, middle + c, middle + d];
                        let ends = in_xy.get(q as usize)?.within(layer);
                        let ends = ends.within(plane).rounded();
                        let mut met = lanes(from, first, last) & !ends.empty();
                        let sure = lanes(from, y[1], y[2]) & !ends.doubt();
                        let x = ends.to_arrays();
                        while met != 0 {
                            let k = met.trailing_zeros();
                            met &= met - 1;
                            let (at, k) = ([from + k as i32, z], k as usize % 4);
                            let x = whole(nth(&x, k));
                            if sure >> k & 1 == 1 {
                                f(at, [x[0], x[2]]);
                                continue;
                            }
                            let row = self.settled(at, y, x);
                            row.into_iter().for_each(|row| f(at, row));
                        }
                    }
                }
            }
            from_y = to_y;
        }
        Some(())
    }

    /// A row of which an end is in doubt, or whether the triangle comes to it at all.
    #[cold]
    #[inline(never)]
    fn settled(&self, [y, z]: [i32; 2], in_y: [i32; 4], in_x: [i32; 4]) -> Option<[i32; 2]> {
        let meets = |x: i32| {
            let [i, j, k] = self.inside.block.first;
            let voxel = self.grid.voxel([i + x, j + y, k + z].map(|i| i as u32));
            voxel.is_some_and(|voxel| self.inside.triangle.overlaps(&voxel))
        };
        let [mut first, sure_first, sure_last, mut last] = in_x;
        if (y < in_y[1] || y > in_y[2]) && sure_first <= sure_last && !meets(sure_first) {
            return None;
        }
        let is_sure = |x: i32| sure_first <= x && x <= sure_last;
        while first <= last && !is_sure(first) && !meets(first) {
            first += 1;
        }
        while first <= last && !is_sure(last) && !meets(last) {
            last -= 1;
        }
        (first <= last).then_some([first, last])
    }

    /// Where the plane is: `None` where rounding cannot say how it is turned.
    #[inline(always)]
    fn plane(&self, xy: &View, xz: &View, yz: &View) -> Option<Plane> {
        let InBlock { widest, error, .. } = &self.inside;
        if yz.sign == Ordering::Equal {
            let reach = [-FAR, -FAR, FAR, FAR];
            return Some(Plane { middle: 0.0, slopes: [0.0; 2], reach });
        }
        if yz.area.abs() <= f32::from(AREA) * error * widest {
            return None;
        }
        let per_x = 1.0 / yz.area;
        let [y, z] = [xz.area * per_x, -xy.area * per_x];
        let [a, b, c] = self.inside.first_vertex();
        let half = 0.5 * (y.abs() + z.abs());
        let error = f32::from(PLANE) * error * widest * widest * per_x.abs();
        Some(Plane {
            middle: a + y * (0.5 - b) + z * (0.5 - c) - 0.5,
            slopes: [y, z],
            reach: [-half - error, -half + error, half - error, half + error],
        })
    }
}

impl Layers {
    /// From one on.
    #[inline(always)]
    fn new(xz: &View, yz: &View, first: i32) -> Self {
        let y = yz.ends(first).rounded();
        Self { x: xz.ends(first).to_arrays(), y: y.to_arrays(), empty: y.empty() }
    }
}
