//! Grids of bits as sets of voxels: members, and operations on two sets.

use core::fmt;

use super::bits::Bits;
use super::word::Word;
use crate::scalar::Scalar;
use crate::shape::Aabb;

/// Error: two sets of voxels belong to different grids.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct DifferentGrids;

impl fmt::Display for DifferentGrids {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("the two sets of voxels belong to different grids")
    }
}

impl core::error::Error for DifferentGrids {}

impl<S: Scalar, W: Word> Bits<'_, S, W> {
    /// Sets or clears the bit of a voxel. Returns whether it was set before. If the grid has no
    /// such voxel, changes nothing and returns `false`.
    #[inline]
    pub fn set(&mut self, voxel: [u32; 3], is_set: bool) -> bool {
        let was_set = self.contains(voxel);
        if was_set != is_set && self.has(voxel) {
            self.flip(voxel);
        }
        was_set
    }

    /// Clears all bits, also bits beyond the grid.
    pub fn clear(&mut self) {
        self.words.fill(W::ZERO);
    }

    /// Adds the voxels of `other`.
    ///
    /// # Errors
    /// [`DifferentGrids`], unless both have the same grid, or the same part of one.
    #[doc(alias = "union")]
    pub fn union_with(&mut self, other: &Bits<'_, S, W>) -> Result<(), DifferentGrids> {
        self.combine(other, |a, b| a | b)
    }

    /// Keeps the voxels that `other` has too.
    ///
    /// # Errors
    /// As [`union_with`](Self::union_with).
    #[doc(alias = "intersection")]
    pub fn intersect_with(&mut self, other: &Bits<'_, S, W>) -> Result<(), DifferentGrids> {
        self.combine(other, |a, b| a & b)
    }

    /// Removes the voxels that `other` has.
    ///
    /// # Errors
    /// As [`union_with`](Self::union_with).
    #[doc(alias = "difference")]
    #[doc(alias = "subtract")]
    pub fn difference_with(&mut self, other: &Bits<'_, S, W>) -> Result<(), DifferentGrids> {
        self.combine(other, |a, b| a & (b ^ W::ALL))
    }

    /// Have the two sets no voxel in common?
    ///
    /// # Errors
    /// As [`union_with`](Self::union_with).
    pub fn is_disjoint(&self, other: &Bits<'_, S, W>) -> Result<bool, DifferentGrids> {
        self.check_grid(other)?;
        let mut words = self.words.iter().zip(&*other.words).enumerate();
        Ok(words.all(|(k, (&a, &b))| a & b & self.mask(k) == W::ZERO))
    }

    fn check_grid(&self, other: &Bits<'_, S, W>) -> Result<(), DifferentGrids> {
        if self.grid == other.grid { Ok(()) } else { Err(DifferentGrids) }
    }

    /// Replaces each word, except for bits beyond the grid.
    fn combine(
        &mut self,
        other: &Bits<'_, S, W>,
        word: impl Fn(W, W) -> W,
    ) -> Result<(), DifferentGrids> {
        self.check_grid(other)?;
        for k in 0..other.words.len() {
            let mask = self.mask(k);
            if let (Some(a), Some(&b)) = (self.words.get_mut(k), other.words.get(k)) {
                *a = (word(*a, b) & mask) | (*a & (mask ^ W::ALL));
            }
        }
        Ok(())
    }

    /// The bits of word `k` that belong to the grid.
    #[inline(always)]
    fn mask(&self, k: usize) -> W {
        let is_last = (k + 1) % self.row_words.max(1) == 0;
        if is_last { W::ALL >> self.beyond() } else { W::ALL }
    }

    /// The voxels whose bits are set, x rising first, then y, then z.
    ///
    /// ```
    /// use septum::voxel::{Bits, Grid};
    ///
    /// let grid = Grid::new([0.0; 3], [0.5; 3], [40, 3, 2])?;
    /// let (mut words, mut more) = ([0_u32; 12], [0_u32; 12]);
    /// let mut floor = Bits::new(&grid, &mut words)?;
    /// floor.set([39, 0, 1], true);
    /// floor.set([2, 1, 0], true);
    /// assert_eq!(floor.iter().collect::<Vec<_>>(), [[2, 1, 0], [39, 0, 1]]);
    ///
    /// let mut desk = Bits::new(&grid, &mut more)?;
    /// desk.set([2, 1, 0], true);
    /// assert!(!floor.is_disjoint(&desk)?);
    /// floor.difference_with(&desk)?;
    /// let (min, max) = floor.boxes().next().unwrap().min_max().unwrap();
    /// assert_eq!((min.x, max.x, floor.count()), (19.5, 20.0, 1));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn iter(&self) -> Voxels<'_, W> {
        let [nx, ny, _] = self.grid.resolution();
        Voxels { words: &*self.words, next: 0, word: W::ZERO, nx, ny, at: [0; 3] }
    }

    /// The boxes of the voxels whose bits are set: [`Grid::voxel`](super::Grid::voxel) of each.
    pub fn boxes(&self) -> impl Iterator<Item = Aabb<S>> + '_ {
        self.iter().filter_map(|voxel| self.grid.voxel(voxel))
    }
}

impl<'b, S: Scalar, W: Word> IntoIterator for &'b Bits<'_, S, W> {
    type Item = [u32; 3];
    type IntoIter = Voxels<'b, W>;

    fn into_iter(self) -> Voxels<'b, W> {
        self.iter()
    }
}

/// The voxels whose bits are set: see [`Bits::iter`].
#[derive(Clone, Debug)]
pub struct Voxels<'b, W> {
    words: &'b [W],
    /// How many words have been read, and the bits that remain of the last.
    next: usize,
    word: W,
    nx: u32,
    ny: u32,
    /// The voxel of the least bit of that word.
    at: [u32; 3],
}

impl<W: Word> Iterator for Voxels<'_, W> {
    type Item = [u32; 3];

    fn next(&mut self) -> Option<[u32; 3]> {
        while self.word == W::ZERO {
            self.word = *self.words.get(self.next)?;
            let [x, y, z] = self.at;
            self.at = if self.next == 0 {
                [0; 3]
            } else if x + W::BITS < self.nx {
                [x + W::BITS, y, z]
            } else if y + 1 < self.ny {
                [0, y + 1, z]
            } else {
                [0, 0, z + 1]
            };
            self.next += 1;
            let left = self.nx - self.at[0];
            if left < W::BITS {
                self.word = self.word & W::first(left);
            }
        }
        let bit = self.word.zeros();
        self.word = self.word & (self.word ^ (W::ONE << bit));
        let [x, y, z] = self.at;
        Some([x + bit, y, z])
    }
}
