//! Four intervals at once, of which each end is known up to rounding.

use super::block::ForEach;
use crate::arithmetic::Quad;

/// A number for each of four slabs.
pub(super) type Four = ForEach;

/// With it units are whole, and the last bits those of the number, below 2^22: extents are below
/// 2^11, and the ends of a row that has any voxels within 16 of these.
pub(super) const SHIFTER: f32 = (3_u32 << 22) as f32;

/// Where the intervals of four slabs end: the least end, too low and too high, and likewise the
/// greatest. All are half a voxel less, so that to round to the nearest gives the voxel. Rounded
/// ties may go either way, for the truth lies strictly between too low and too high; −1/2, where a
/// block begins, goes to zero, which is even.
#[derive(Clone, Copy)]
pub(super) struct Ends {
    pub(super) least: [Four; 2],
    pub(super) greatest: [Four; 2],
}

impl Ends {
    /// What they have in common with others.
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

    /// The slabs that surely have no voxels.
    #[inline(always)]
    pub(super) fn empty(&self) -> u32 {
        self.least[0].exceeds(self.greatest[1])
    }

    /// The slabs of which an end, rounded, may be either of two.
    #[inline(always)]
    pub(super) fn doubt(&self) -> u32 {
        let Self { least: [a, b], greatest: [c, d] } = self;
        b.exceeds(*a) | d.exceeds(*c)
    }

    /// Least, too low and too high; greatest, too low and too high.
    #[inline(always)]
    pub(super) fn to_arrays(self) -> [[f32; 4]; 4] {
        let Self { least: [a, b], greatest: [c, d] } = self;
        [a.to_array(), b.to_array(), c.to_array(), d.to_array()]
    }
}

/// The same numbers for each of four slabs. (`map` may go through memory.)
#[inline(always)]
pub(super) fn same([a, b, c, d]: [f32; 4]) -> [Four; 4] {
    [Four::splat(a), Four::splat(b), Four::splat(c), Four::splat(d)]
}

/// The n-th of each.
#[inline(always)]
pub(super) fn nth([a, b, c, d]: &[[f32; 4]; 4], n: usize) -> [f32; 4] {
    [a[n], b[n], c[n], d[n]]
}

/// Four slabs, from one on.
#[inline(always)]
pub(super) fn four(first: i32) -> Four {
    let first = first as f32;
    Four::new([first, first + 1.0, first + 2.0, first + 3.0])
}

/// The numbers from the first to the last, of those from 0 to 31, bit by bit.
#[inline(always)]
pub(super) fn among(first: i32, last: i32) -> u32 {
    let below = |k: i32| (1_u64 << k.clamp(0, 32)) - 1;
    (below(last + 1) & !below(first)) as u32
}

/// The whole numbers that the shifter was added to.
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
