//! Four intervals at once, of which each end is known up to rounding.

use super::block::ForEach;
use crate::arithmetic::Quad;

/// A number for each of four slabs.
pub(super) type Four = ForEach;

/// With it units are whole, and the last bits those of the number.
pub(super) const SHIFTER: f32 = (3_u32 << 22) as f32;

/// Where the intervals of four slabs end: first too low, then too high, both by half a voxel
/// less, so that to round to the nearest gives the voxel.
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
        let round = |ends: [Four; 2]| ends.map(|end| end + Four::splat(SHIFTER));
        Self { least: round(self.least), greatest: round(self.greatest) }
    }

    /// The slabs that surely have no voxels.
    #[inline(always)]
    pub(super) fn empty(&self) -> u32 {
        self.least[0].exceeds(self.greatest[1])
    }

    /// The first and the last voxel of each of these slabs, by rounded ends: `None` where one is
    /// in doubt.
    #[inline(always)]
    pub(super) fn voxels(&self, slabs: u32) -> Option<[[f32; 4]; 2]> {
        let Self { least: [a, b], greatest: [c, d] } = self;
        let doubt = (b.exceeds(*a) | d.exceeds(*c)) & slabs;
        (doubt == 0).then(|| [a.to_array(), c.to_array()])
    }

    #[inline(always)]
    pub(super) fn to_arrays(self) -> [[f32; 4]; 4] {
        let Self { least: [a, b], greatest: [c, d] } = self;
        [a, b, c, d].map(Four::to_array)
    }
}

/// Four slabs, from one on.
#[inline(always)]
pub(super) fn four(first: u32) -> Four {
    let first = first as f32;
    Four::new([first, first + 1.0, first + 2.0, first + 3.0])
}

/// The whole number that the shifter was added to.
#[inline(always)]
pub(super) const fn whole(x: f32) -> u32 {
    x.to_bits() & 0x3f_ffff
}
