//! A triangle in a block, seen along an axis: u and v are the other two.
//!
//! In the slab from v = q to q + 1 the triangle has an interval of u. Say that it lies at lesser u
//! than the line of an edge. Then no point of it in the slab is beyond the greater of X(q) and
//! X(q + 1), where X(v) is u on that line. The interval ends at the least of these and of the
//! triangle's own greatest u. For its last point is where two of the bounds meet: two edges, in a
//! vertex that is the triangle's last; or an edge and v = q or v = q + 1. The other end is found
//! likewise. Of a triangle that is seen as a line, edges go both ways, and either side will do.
//!
//! The block ends where the triangle does, or where the grid does before; each of its slabs holds
//! a point of the triangle. So these edges need no look: those that touch no plane of v, and those
//! along which u or v is constant.
//!
//! # Error bound
//!
//! Lengths and η are as in `few`, and so is the error of an area, 19·η·L. The roundoff is ε here. L
//! is the greatest extent, on any axis, of triangle and block together, and at least one: so half
//! a voxel is at most L/2.
//!
//! 1. An edge touches a plane of v if it does after both its ends are moved apart by 4·η: vertices
//!    and planes err by 2·η less a roundoff of L, and three roundings here are of L each.
//! 2. An edge, du and dv long as computed, crosses v = C at X. For a plane u = k of the block,
//!    k − X times dv is the area of the edge and the way from its vertex to (k, C), which errs as
//!    areas do. Beyond 3·η dv has its true sign; beyond 64·η, which is asked, X is no farther than
//!    the numbers of `ends` go.
//! 3. X is computed by a slope and eight more roundings. Times dv, they are of 4.7·L² at most, and
//!    less than 20·ε·L² together; the area's own roundings are not among them. So (k, C) is on
//!    the side that it seems if X is more than 32·η·L/|dv| from k.
//! 4. Whether X(q) or X(q + 1) is the greater is said by the computed slope. Any of the two is a
//!    bound, and by that slope the other is no greater.
//!
//! Gappa adds up 3; how great each rounding is has been put in by hand.

use core::cmp::Ordering;

use super::block::InBlock;
use super::ends::{Ends, Four, SHIFTER, four};
use super::few::AREA;
use super::sign::turn;
use crate::arithmetic::{Quad, THREE, compare};
use crate::scalar::Scalar;

/// See the error bound above.
const EDGE: u8 = 32;

/// What is seen along an axis.
pub(super) struct View {
    /// Twice the area of the triangle, nearly, and its exact sign.
    pub(super) area: f32,
    pub(super) sign: Ordering,
    /// The edges that end intervals, and those of them that end them at the greatest u.
    edges: u32,
    is_greatest: u32,
    /// Where the edges end the interval of slab zero, too low and too high.
    from: [[f32; 4]; 2],
    slopes: [f32; 4],
    width: f32,
}

impl View {
    /// What is seen along an axis: `None` where rounding takes a level edge for a steep one.
    #[inline(always)]
    pub(super) fn new<S: Scalar>(inside: &InBlock<'_, S>, [u, v]: [usize; 2]) -> Option<Self> {
        let (row, across) = (&inside.rows[u], &inside.rows[v]);
        let (d, e) = (row.edges, across.edges);
        let area = (d * e.turned() - e * d.turned()).to_array()[0];
        let sign = if area.abs() > f32::from(AREA) * inside.error * inside.widest {
            compare(area, 0.0)
        } else {
            exact_area(inside, [u, v])
        };
        let (half, shifter) = (Four::splat(0.5), Four::splat(SHIFTER));
        // Which touch a plane, for all that is known.
        let (low, high) =
            (across.at.least(across.at.turned()), across.at.greatest(across.at.turned()));
        let margin = Four::splat(4.0 * inside.error);
        let (low, high) = (low - margin - half + shifter, high + margin - half + shifter);
        let edges = high.exceeds(low) & THREE & !inside.level[u] & !inside.level[v];
        let lengths = e.magnitude();
        if edges & !lengths.exceeds(Four::splat(64.0 * inside.error)) != 0 {
            return None;
        }
        // Of a triangle that is seen as a line either side will do: its edges go both ways.
        let flip = if sign == Ordering::Less { THREE } else { 0 };
        let is_greatest = e.exceeds(Four::splat(0.0)) ^ flip;
        // Of level edges this is no number, and nobody reads it.
        let slopes = d / e;
        let way = slopes.magnitude() * half;
        let middle = row.at + (half - across.at) * slopes - half;
        let (greatest, least) = ((middle + way).to_array(), (middle - way).to_array());
        let mut ends = [0.0; 4];
        for k in 0..3 {
            ends[k] = if is_greatest >> k & 1 == 1 { greatest[k] } else { least[k] };
        }
        let ends = Four::new(ends);
        let error = Four::splat(f32::from(EDGE) * inside.error * inside.widest) / lengths;
        Some(Self {
            area,
            sign,
            edges,
            is_greatest,
            from: [(ends - error).to_array(), (ends + error).to_array()],
            slopes: slopes.to_array(),
            width: inside.block.widths[u] as f32,
        })
    }

    /// Where the intervals of four slabs end, from one on.
    #[inline(always)]
    pub(super) fn ends(&self, first: i32) -> Ends {
        let mut least = [Four::splat(-0.5); 2];
        let mut greatest = [Four::splat(self.width - 1.0); 2];
        let slabs = four(first);
        for k in 0..3 {
            if self.edges >> k & 1 == 0 {
                continue;
            }
            let way = slabs * Four::splat(self.slopes[k]);
            let (low, high) =
                (Four::splat(self.from[0][k]) + way, Four::splat(self.from[1][k]) + way);
            if self.is_greatest >> k & 1 == 1 {
                greatest = [greatest[0].least(low), greatest[1].least(high)];
            } else {
                least = [least[0].greatest(low), least[1].greatest(high)];
            }
        }
        Ends { least, greatest }
    }
}

#[cold]
#[inline(never)]
fn exact_area<S: Scalar>(inside: &InBlock<'_, S>, [u, v]: [usize; 2]) -> Ordering {
    if inside.level[u] | inside.level[v] == THREE {
        return Ordering::Equal;
    }
    let [a, b, c] = inside.triangle.points().map(|p| [p[u], p[v]]);
    turn(a, b, c, c)
}
