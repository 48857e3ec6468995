use core::fmt;

use super::block::{Block, ForEach};
use super::grid::Grid;
use super::pass::Pass;
use super::place::{ALL_CLOSED, AxisMarks, Marks};
use super::placed::{Bounds, Near};
use super::rows::passes;
use super::word::Word;
use super::{Rule, few, four_rows};
use crate::arithmetic::Quad;
use crate::scalar::Scalar;
use crate::shape::Triangle;

mod set;

/// Whether the machine computes with vectors of four floats.
const HAS_VECTORS: bool = ForEach::IS_VECTOR;
/// The largest block for [`few`]: 32 at most, the bits of its word.
const FEW: u64 = if HAS_VECTORS { 16 } else { 32 };

impl<S: Copy> Grid<S> {
    /// Returns the number of words of a row of voxels. Each row begins with a new word.
    #[must_use]
    pub const fn row_words<W: Word>(&self) -> usize {
        self.resolution()[0].div_ceil(W::BITS) as usize
    }

    /// Returns the number of words of the grid, [`row_words`](Self::row_words) for each y and z. If
    /// `usize` overflows, returns `usize::MAX`, which is the length of no slice.
    #[must_use]
    pub const fn words<W: Word>(&self) -> usize {
        let [_, y, z] = self.resolution();
        self.row_words::<W>().saturating_mul(y as usize).saturating_mul(z as usize)
    }
}

/// A bit for each voxel of a grid, in the caller's memory: surface voxelization of a mesh.
///
/// A row begins with the least bit of a new word and has a bit for each voxel, x rising. Rows
/// follow each other, y rising, then z. Only [`clear`](Self::clear) and
/// [`Solid::finish`](super::Solid::finish) change bits beyond the grid in the last word of a row.
/// Slabs of a grid along z share no word; the words of all slabs in order are the words of the grid.
///
/// The order of triangles, the order of their vertices, and the cut of a grid into parts change
/// no bit.
///
/// ```
/// use septum::voxel::{Bits, Grid, Rule};
/// use septum::Triangle;
///
/// let grid = Grid::new([0.0_f32; 3], [0.25; 3], [64, 64, 64])?;
/// let triangle = Triangle::new([1.0, 1.0, 1.0], [15.0, 2.0, 3.0], [4.0, 14.0, 12.0])?;
///
/// // The whole grid at once, then slab by slab in a sixteenth of the memory.
/// let mut words = vec![0_u64; grid.words::<u64>()];
/// let mut all = Bits::new(&grid, &mut words)?;
/// all.fill(&triangle, Rule::Closed);
/// let all = all.count();
///
/// let mut count = 0;
/// for z in (0..64).step_by(4) {
///     let slab = grid.part([0..64, 0..64, z..z + 4]).unwrap();
///     let mut words = [0_u64; 64 * 4];
///     let mut bits = Bits::new(&slab, &mut words)?;
///     bits.fill(&triangle, Rule::Closed);
///     count += bits.count();
/// }
/// assert_eq!(count, all);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug)]
pub struct Bits<'a, S, W> {
    pub(super) grid: Grid<S>,
    pub(super) row_words: usize,
    pub(super) words: &'a mut [W],
}

/// Error: a slice has fewer words than a grid needs.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct TooFewWords {
    /// The number of words that the grid needs.
    pub needed: usize,
}

impl fmt::Display for TooFewWords {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "a grid of {} words does not fit the slice", self.needed)
    }
}

impl core::error::Error for TooFewWords {}

impl<'a, S: Scalar, W: Word> Bits<'a, S, W> {
    /// Makes the bits of a grid from the first of these words. Bits that are set stay set.
    ///
    /// # Errors
    /// [`TooFewWords`] if the slice has fewer than [`Grid::words`].
    ///
    /// *Panics*: never.
    pub fn new(grid: &Grid<S>, words: &'a mut [W]) -> Result<Self, TooFewWords> {
        let needed = grid.words::<W>();
        match words.get_mut(..needed) {
            Some(words) => Ok(Self { grid: *grid, row_words: grid.row_words::<W>(), words }),
            None => Err(TooFewWords { needed }),
        }
    }

    /// Sets the bits of the voxels that a triangle marks, the voxels of [`Grid::rows`].
    ///
    /// *Panics*: never.
    #[inline]
    pub fn fill(&mut self, triangle: &Triangle<S>, rule: Rule) {
        if rule == Rule::Closed {
            return self.fill_closed(triangle);
        }
        let (first, next) = passes(rule);
        self.fill_pass(triangle, first);
        next.iter().for_each(|&marks| self.fill_pass(triangle, marks));
    }

    #[inline(never)]
    fn fill_pass(&mut self, triangle: &Triangle<S>, marks: [Marks; 3]) {
        let near = Near::new(triangle, &self.grid);
        let bounds = Bounds::new(&near, &self.grid, marks);
        self.fill_rows(&near, bounds, marks);
    }

    fn fill_closed(&mut self, triangle: &Triangle<S>) {
        let grid = self.grid;
        let near = Near::new(triangle, &grid);
        let bounds = Bounds::new(&near, &grid, ALL_CLOSED);
        let block = if bounds.is_full { None } else { Block::of(&bounds) };
        let is_done = block.is_some_and(|block| {
            if bounds.is_within && block.voxels() <= FEW {
                self.set_few(&block, few::met(&block, &near, &grid));
                return true;
            }
            HAS_VECTORS
                && four_rows::each(&block, &near, triangle, &grid, |rows| self.set_rows(rows))
        });
        if !is_done {
            self.fill_rows(&near, bounds, ALL_CLOSED);
        }
    }

    /// Sets the bits of the rows within the bounds of a triangle.
    #[inline(always)]
    fn fill_rows<M: AxisMarks>(&mut self, near: &Near<S>, bounds: Bounds, marks: M) {
        let grid = self.grid;
        if bounds.is_full {
            let [x, y, z] = bounds.bounds;
            for z in z.first..=z.last {
                (y.first..=y.last).for_each(|y| self.set_span([y, z], x));
            }
            return;
        }
        let pass = Pass::within(&grid, near, marks, bounds);
        pass.each(&grid, |row, span| self.set_span(row, span));
    }

    /// Is the bit of a voxel set? `false` if the grid has no such voxel.
    #[doc(alias = "get")]
    #[inline]
    #[must_use]
    pub fn contains(&self, [x, y, z]: [u32; 3]) -> bool {
        if !self.has([x, y, z]) {
            return false;
        }
        let at = self.row_start(y, z) + (x / W::BITS) as usize;
        self.words.get(at).is_some_and(|&word| word >> (x % W::BITS) & W::ONE == W::ONE)
    }

    #[inline]
    pub(super) fn has(&self, [x, y, z]: [u32; 3]) -> bool {
        let [nx, ny, nz] = self.grid.resolution();
        x < nx && y < ny && z < nz
    }

    /// The number of bits beyond the grid in the last word of a row.
    #[inline]
    pub(super) fn beyond(&self) -> u32 {
        self.row_words as u32 * W::BITS - self.grid.resolution()[0]
    }

    /// How many bits of the grid are set?
    #[must_use]
    pub fn count(&self) -> u64 {
        let beyond = self.beyond();
        let row = |row: &[W]| {
            let all: u32 = row.iter().map(|word| word.ones()).sum();
            let tail = row.last().map_or(0, |&word| match beyond {
                0 => 0,
                beyond => (word >> (W::BITS - beyond)).ones(),
            });
            u64::from(all - tail)
        };
        self.words.chunks_exact(self.row_words).map(row).sum()
    }

    /// Returns the grid.
    #[must_use]
    pub const fn grid(&self) -> &Grid<S> {
        &self.grid
    }

    /// Flips the bit of a voxel of the grid.
    #[inline(always)]
    pub(super) fn flip(&mut self, [x, y, z]: [u32; 3]) {
        let at = self.row_start(y, z) + (x / W::BITS) as usize;
        if let Some(word) = self.words.get_mut(at) {
            *word ^= W::ONE << (x % W::BITS);
        }
    }

    /// Replaces each bit of a row by the parity of the bits up to it; clears the row if `is_open`.
    pub(super) fn fill_between(&mut self, y: u32, z: u32, is_open: bool) {
        let beyond = self.beyond();
        let row = self.row_mut(y, z);
        if is_open {
            return row.fill(W::ZERO);
        }
        let mut is_inside = false;
        for word in &mut *row {
            // A parallel prefix: each bit becomes the parity of the bits up to it in this word.
            let mut shift = 1;
            while shift < W::BITS {
                *word ^= *word << shift;
                shift *= 2;
            }
            if is_inside {
                *word ^= W::ALL;
            }
            is_inside = *word >> (W::BITS - 1) == W::ONE;
        }
        // Crossings beyond the grid leave a row inside at its end.
        if let Some(last) = row.last_mut() {
            *last = *last & (W::ALL >> beyond);
        }
    }

    #[inline(always)]
    fn row_start(&self, y: u32, z: u32) -> usize {
        let ny = self.grid.resolution()[1] as usize;
        (z as usize * ny + y as usize) * self.row_words
    }

    #[inline(always)]
    fn row_mut(&mut self, y: u32, z: u32) -> &mut [W] {
        let start = self.row_start(y, z);
        self.words.get_mut(start..start + self.row_words).unwrap_or_default()
    }
}
