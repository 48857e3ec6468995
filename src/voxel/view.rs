//! The view of a triangle in a block along an axis; u and v are the two remaining axes.
//!
//! In the slab from v = q to q + 1 the triangle covers an interval of u. If the triangle lies at
//! lesser u than the line of an edge, no point of it in the slab is beyond the greater of X(q) and
//! X(q + 1), where X(v) is u on that line. The interval ends at the least of these bounds and of
//! the triangle's greatest u: its last point is either a vertex, or the crossing of an edge with
//! v = q or v = q + 1. The least end is found in the same way. If the triangle appears as a line,
//! its edges run both ways, and either side serves.
//!
//! The block ends with the triangle, or with the grid before; each of its slabs holds a point of
//! the triangle. Therefore edges that touch no plane of v, and edges along which u or v is
//! constant, bound nothing and are skipped.
//!
//! # Error bound
//!
//! Lengths, η and the error of an area, 19·η·L, are as in `few`. The roundoff is ε here. L is the
//! greatest extent of triangle and block together on any axis, and at least one, so that half a
//! voxel is at most L/2.
//!
//! 1. An edge touches a plane of v if it does after both its ends are moved apart by 4·η: vertices
//!    and planes err by 2·η less a roundoff of L, and three roundings here are of L each.
//! 2. An edge with computed lengths du and dv crosses v = C at X. For a plane u = k of the block,
//!    (k − X)·dv is the area of the edge and the vector from its vertex to (k, C), and errs as
//!    areas do. Beyond 3·η dv has its true sign. The code requires 64·η, so that X stays within
//!    the range of [`SHIFTER`].
//! 3. X is computed by a slope and eight more roundings. Times dv, they are of 4.7·L² at most, and
//!    less than 20·ε·L² together; the area's own roundings are not among them. So (k, C) is on
//!    the side that it seems if X is more than 32·η·L/|dv| from k.
//! 4. The computed slope selects the greater of X(q) and X(q + 1). Either is a bound, and by that
//!    slope the selected one is not the lesser.
//!
//! Gappa adds up the roundings of step 3; the size of each was entered by hand.

use core::cmp::Ordering;

use super::block::{ForEach, InBlock, area};
use super::few::AREA;
use crate::arithmetic::{Quad, THREE};
use crate::scalar::Scalar;

/// See the error bound above.
const EDGE: u8 = 32;

/// The view along an axis.
pub(super) struct View {
    /// Twice the area of the triangle, approximately, and its exact sign.
    pub(super) area: f32,
    pub(super) sign: Ordering,
    /// The edges that bound intervals, and the edges among them that bound the greatest u.
    edges: u32,
    is_greatest: u32,
    /// Lower and upper bounds of the edges' ends in slab zero.
    from: [[f32; 4]; 2],
    slopes: [f32; 4],
    width: f32,
}

impl View {
    /// The view along an axis; `None` if an edge is too level for its crossing to be bounded.
    #[inline(always)]
    pub(super) fn new<S: Scalar>(inside: &InBlock<'_, S>, [u, v]: [usize; 2]) -> Option<Self> {
        let (row, across) = (&inside.rows[u], &inside.rows[v]);
        let (d, e) = (row.edges, across.edges);
        let error = f32::from(AREA) * inside.error * inside.widest;
        let (area, sign) = area(&inside.rows, [u, v], error, &inside.triangle.points());
        let (half, shifter) = (Four::splat(0.5), Four::splat(SHIFTER));
        // The edges that may touch a plane.
        let (low, high) =
            (across.at.least(across.at.turned()), across.at.greatest(across.at.turned()));
        let margin = Four::splat(4.0 * inside.error);
        let (low, high) = (low - margin - half + shifter, high + margin - half + shifter);
        let edges = high.exceeds(low) & THREE & !inside.level[u] & !inside.level[v];
        let lengths = e.magnitude();
        if edges & !lengths.exceeds(Four::splat(64.0 * inside.error)) != 0 {
            return None;
        }
        // If the triangle appears as a line, either side serves: its edges run both ways.
        let flip = if sign == Ordering::Less { THREE } else { 0 };
        let is_greatest = e.exceeds(Four::splat(0.0)) ^ flip;
        // The slope of a level edge may be infinite or NaN; it is not used.
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

    /// The ends of the intervals of four slabs, beginning with `first`.
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

/// A number for each of four slabs.
pub(super) type Four = ForEach;

/// Added to a number below 2^22 it rounds to a whole number, which the last bits hold. Extents are
/// below 2^11, and the ends of a row that has voxels are within 16 times the extents.
pub(super) const SHIFTER: f32 = (3_u32 << 22) as f32;

/// The ends of the intervals of four slabs: lower and upper bound of the least end, then of the
/// greatest. All are half a voxel less, so that rounding to nearest gives the voxel. Ties may
/// round either way, for the exact end lies strictly between its bounds; −1/2, the begin of a
/// block, rounds to zero, which is even.
#[derive(Clone, Copy)]
pub(super) struct Ends {
    pub(super) least: [Four; 2],
    pub(super) greatest: [Four; 2],
}

impl Ends {
    /// The intersection with four other intervals.
    #[inline(always)]
    pub(super) fn within(self, [a, b, c, d]: [Four; 4]) -> Self {
        let Self { least, greatest } = self;
        Self {
            least: [least[0].greatest(a), least[1].greatest(b)],
            greatest: [greatest[0].least(c), greatest[1].least(d)],
        }
    }

    /// The same, rounded to whole numbers.
    #[inline(always)]
    pub(super) fn rounded(self) -> Self {
        let (Self { least: [a, b], greatest: [c, d] }, shifter) = (self, Four::splat(SHIFTER));
        Self { least: [a + shifter, b + shifter], greatest: [c + shifter, d + shifter] }
    }

    /// The slabs that certainly have no voxels.
    #[inline(always)]
    pub(super) fn empty(&self) -> u32 {
        self.least[0].exceeds(self.greatest[1])
    }

    /// The slabs in doubt: the bounds of an end round to different voxels.
    #[inline(always)]
    pub(super) fn doubt(&self) -> u32 {
        let Self { least: [a, b], greatest: [c, d] } = self;
        b.exceeds(*a) | d.exceeds(*c)
    }

    /// Lower and upper bound of the least end, then of the greatest.
    #[inline(always)]
    pub(super) fn to_arrays(self) -> [[f32; 4]; 4] {
        let Self { least: [a, b], greatest: [c, d] } = self;
        [a.to_array(), b.to_array(), c.to_array(), d.to_array()]
    }
}

/// Each number in all four lanes. (`map` may go through memory.)
#[inline(always)]
pub(super) fn same([a, b, c, d]: [f32; 4]) -> [Four; 4] {
    [Four::splat(a), Four::splat(b), Four::splat(c), Four::splat(d)]
}

/// Number n of each array.
#[inline(always)]
pub(super) fn nth([a, b, c, d]: &[[f32; 4]; 4], n: usize) -> [f32; 4] {
    [a[n], b[n], c[n], d[n]]
}

/// The numbers of four slabs, beginning with `first`.
#[inline(always)]
pub(super) fn four(first: i32) -> Four {
    let first = first as f32;
    Four::new([first, first + 1.0, first + 2.0, first + 3.0])
}

/// The bits from the first to the last, each clamped to the 32 bits of the word.
#[inline(always)]
pub(super) fn among(first: i32, last: i32) -> u32 {
    let below = |k: i32| (1_u64 << k.clamp(0, 32)) - 1;
    (below(last + 1) & !below(first)) as u32
}

/// The whole numbers from which `rounded` made these floats.
#[inline(always)]
pub(super) const fn whole([a, b, c, d]: [f32; 4]) -> [i32; 4] {
    let shifter = SHIFTER.to_bits();
    [
        a.to_bits().wrapping_sub(shifter) as i32,
        b.to_bits().wrapping_sub(shifter) as i32,
        c.to_bits().wrapping_sub(shifter) as i32,
        d.to_bits().wrapping_sub(shifter) as i32,
    ]
}
