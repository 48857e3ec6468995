//! Rows of a block, four at a time: floats alone, which say where they leave a doubt.
//!
//! Seen along an axis, u and v are the other two. In the slab from v = q to q + 1 the triangle
//! comes to an interval of u. Say that it lies at lesser u than the line of an edge. Then no point
//! of it in the slab is beyond the greater of X(q) and X(q + 1), where X(v) is u on that line.
//! The interval ends at the least of these and of the triangle's own greatest u: its last point is
//! a vertex inside of the slab, and so the triangle's last, or a point where an edge crosses v = q
//! or v = q + 1, at the greater X of that edge. The other end is found likewise.
//!
//! The block ends where the triangle does, so that these edges need no look: those that cross no
//! plane of v, and those along which u or v is constant.
//!
//! The plane of the triangle comes in a row of voxels to an interval of x: about its place at the
//! middle of the row, half of its slopes in y and z to either side. Where it is parallel to x, it
//! separates nothing that is not separated in the view along x.
//!
//! Each end is taken a little too low and a little too high. Where both lie between the same two
//! planes, so does the end; where they do not, there is a doubt, and floats say nothing.
//!
//! # Error bound
//!
//! Lengths, L, η and u are as in `few`, and so are the errors of an area, 19·η·L, and of a volume,
//! 110·η·L².
//!
//! 1. An edge, du and dv long as computed, crosses v = C at X. For a plane u = k of the block,
//!    k − X times dv is the area of the edge and the way from its vertex to (k, C), which errs as
//!    areas do. Beyond 64·η dv has its true sign.
//! 2. X is computed by a slope and eight more roundings. Times dv, they are of 4.7·L² at most, and
//!    less than 20·u·L² together; the area's own roundings are not among them. So (k, C) is on
//!    the side that it seems if X is more than 32·η·L/|dv| from k.
//! 3. Likewise for the plane of the triangle: the way along x from it to a corner of the block,
//!    times the x of the normal, is a volume. By the slopes it takes 20 roundings, of 15·L³ at most.
//!    152·η·L² is given. Beyond 20·η·L the normal's x has its true sign.
//!
//! Gappa proves 2 and 3.

use core::cmp::Ordering;

use super::block::{Block, MOST, Row};
use super::ends::{Ends, Four, SHIFTER, four, whole};
use super::few::AREA;
use super::placed::Near;
use super::sign::turn;
use crate::arithmetic::{Quad, THREE, compare};
use crate::scalar::Scalar;

/// See the error bound above.
const EDGE: u8 = 32;
const PLANE: u8 = 152;

/// Farther than anything in a block.
const FAR: f32 = 1e30;
/// Quads of slabs.
const QUADS: usize = MOST as usize / 4;

/// What is seen along an axis.
struct View {
    /// Twice the area of the triangle, nearly, and its exact sign.
    area: f32,
    sign: Ordering,
    /// The edges that end intervals, and those of them that end them at the greatest u.
    edges: u32,
    is_greatest: u32,
    /// Where the edges end the interval of slab zero, too low and too high.
    from: [[f32; 4]; 2],
    slopes: [f32; 4],
    width: f32,
}

/// Where the plane is, in the row (0, 0).
struct Plane {
    middle: f32,
    slopes: [f32; 2],
    /// From the middle to the least end, too low and too high, and to the greatest.
    reach: [f32; 4],
}

/// A block, and a triangle that it is about.
struct Rows<'a, S> {
    near: &'a Near<S>,
    rows: [Row; 3],
    widths: [u32; 3],
    widest: f32,
    error: f32,
    /// Along which edges each coordinate is constant.
    level: [u32; 3],
}

/// Hands on rows of a block: of which y and z, and the first and the last x. It says whether
/// they are all that the triangle meets; if not, there was a doubt.
#[inline(always)]
pub(super) fn each<S: Scalar>(
    block: &Block,
    near: &Near<S>,
    mut f: impl FnMut([u32; 2], [u32; 2]),
) -> bool {
    let error = block.error(near);
    // Not the other way round: of NaN nothing is known.
    let is_known = error <= 1.0 / 1024.0;
    if !is_known {
        return false;
    }
    let level = |i: usize| {
        let [a, b, c] = near.points.map(|p| p[i]);
        u32::from(a == b) | u32::from(b == c) << 1 | u32::from(c == a) << 2
    };
    let rows = Rows {
        near,
        rows: [block.row(near, 0), block.row(near, 1), block.row(near, 2)],
        widths: block.widths,
        widest: block.widest(),
        error,
        level: [level(0), level(1), level(2)],
    };
    let first = block.first.map(|first| first as u32);
    rows.each(|[y, z], [from, to]| {
        f([first[1] + y, first[2] + z], [first[0] + from, first[0] + to]);
    })
    .is_some()
}

impl<S: Scalar> Rows<'_, S> {
    /// `None` where there is a doubt.
    #[inline(always)]
    fn each(&self, mut f: impl FnMut([u32; 2], [u32; 2])) -> Option<()> {
        let (xy, xz, yz) = (self.view([0, 1])?, self.view([0, 2])?, self.view([1, 2])?);
        let plane = self.plane(&xy, &xz, &yz)?;
        let [_, height, depth] = self.widths;

        let mut in_xy = [xy.ends(0); QUADS];
        for (q, ends) in (0..height.div_ceil(4)).zip(&mut in_xy).skip(1) {
            *ends = xy.ends(4 * q);
        }
        let reach = plane.reach.map(Four::splat);
        let slope = Four::splat(plane.slopes[0]);
        for from_z in (0..depth).step_by(4) {
            let count = (depth - from_z).min(4);
            let (in_xz, in_yz) = (xz.ends(from_z).to_arrays(), yz.ends(from_z).rounded());
            let [firsts, lasts] = in_yz.voxels(15 >> (4 - count))?;
            for n in 0..count {
                let (z, n) = (from_z + n, n as usize % 4);
                let (first, last) = (whole(firsts[n]), whole(lasts[n]));
                let layer = in_xz.map(|end| Four::splat(end[n]));
                let middle = Four::splat(plane.middle + z as f32 * plane.slopes[1]);
                for q in first / 4..last / 4 + 1 {
                    let y = 4 * q;
                    let middle = middle + four(y) * slope;
                    let [a, b, c, d] = reach.map(|reach| middle + reach);
                    let ends = in_xy.get(q as usize)?.within(layer).within([a, b, c, d]).rounded();
                    let (head, tail) = (first.saturating_sub(y), (y + 3).saturating_sub(last));
                    let mut lanes = 15 << head & 15 >> tail & !ends.empty();
                    let [from, to] = ends.voxels(lanes)?;
                    while lanes != 0 {
                        let k = lanes.trailing_zeros();
                        lanes &= lanes - 1;
                        let (from, to) = (from[k as usize % 4], to[k as usize % 4]);
                        f([y + k, z], [whole(from), whole(to)]);
                    }
                }
            }
        }
        Some(())
    }

    /// What is seen along an axis: `None` where rounding takes a level edge for a steep one.
    #[inline(always)]
    fn view(&self, [u, v]: [usize; 2]) -> Option<View> {
        let (row, across) = (&self.rows[u], &self.rows[v]);
        let (d, e) = (row.edges, across.edges);
        let area = (d * e.turned() - e * d.turned()).to_array()[0];
        let sign = if area.abs() > f32::from(AREA) * self.error * self.widest {
            compare(area, 0.0)
        } else {
            self.exact_area([u, v])
        };
        let (half, shifter) = (Four::splat(0.5), Four::splat(SHIFTER));
        // Which cross a plane, for all that is known.
        let (low, high) =
            (across.at.least(across.at.turned()), across.at.greatest(across.at.turned()));
        let error = Four::splat(4.0 * self.error);
        let (low, high) = (low - error - half + shifter, high + error - half + shifter);
        let edges = high.exceeds(low) & THREE & !self.level[u] & !self.level[v];
        let lengths = e.magnitude();
        if edges & !lengths.exceeds(Four::splat(64.0 * self.error)) != 0 {
            return None;
        }
        // Of a triangle that is seen as a line either side will do: its edges go both ways.
        let flip = if sign == Ordering::Less { THREE } else { 0 };
        let is_greatest = e.exceeds(Four::splat(0.0)) ^ flip;
        let slopes = d / e;
        let way = slopes.magnitude() * half;
        let middle = row.at + (half - across.at) * slopes - half;
        let [greatest, least] = [(middle + way), (middle - way)].map(Four::to_array);
        let mut ends = [0.0; 4];
        for k in 0..3 {
            ends[k] = if is_greatest >> k & 1 == 1 { greatest[k] } else { least[k] };
        }
        let ends = Four::new(ends);
        let error = Four::splat(f32::from(EDGE) * self.error * self.widest) / lengths;
        Some(View {
            area,
            sign,
            edges,
            is_greatest,
            from: [(ends - error).to_array(), (ends + error).to_array()],
            slopes: slopes.to_array(),
            width: self.widths[u] as f32,
        })
    }

    /// Where the plane is: `None` where rounding cannot say how it is turned.
    #[inline(always)]
    fn plane(&self, xy: &View, xz: &View, yz: &View) -> Option<Plane> {
        if yz.sign == Ordering::Equal {
            let reach = [-FAR, -FAR, FAR, FAR];
            return Some(Plane { middle: 0.0, slopes: [0.0; 2], reach });
        }
        if yz.area.abs() <= f32::from(AREA) * self.error * self.widest {
            return None;
        }
        let per_x = 1.0 / yz.area;
        let [y, z] = [xz.area * per_x, -xy.area * per_x];
        let [a, b, c] = [0, 1, 2].map(|i: usize| self.rows[i].at.to_array()[0]);
        let half = 0.5 * (y.abs() + z.abs());
        let error = f32::from(PLANE) * self.error * self.widest * self.widest * per_x.abs();
        Some(Plane {
            middle: a + y * (0.5 - b) + z * (0.5 - c) - 0.5,
            slopes: [y, z],
            reach: [-half - error, -half + error, half - error, half + error],
        })
    }

    #[cold]
    #[inline(never)]
    fn exact_area(&self, [u, v]: [usize; 2]) -> Ordering {
        if self.level[u] | self.level[v] == THREE {
            return Ordering::Equal;
        }
        let [a, b, c] = self.near.points.map(|p| [p[u], p[v]]);
        turn(a, b, c, c)
    }
}

impl View {
    /// Where the intervals of four slabs end, from one on.
    #[inline(always)]
    fn ends(&self, first: u32) -> Ends {
        let mut least = [Four::splat(-0.5); 2];
        let mut greatest = [Four::splat(self.width - 1.0); 2];
        let slabs = four(first);
        for k in 0..3 {
            if self.edges >> k & 1 == 0 {
                continue;
            }
            let way = slabs * Four::splat(self.slopes[k]);
            let [low, high] = [0, 1].map(|i: usize| Four::splat(self.from[i][k]) + way);
            if self.is_greatest >> k & 1 == 1 {
                greatest = [greatest[0].least(low), greatest[1].least(high)];
            } else {
                least = [least[0].greatest(low), least[1].greatest(high)];
            }
        }
        Ends { least, greatest }
    }
}
