use core::fmt;

use super::Rule;
use super::block::{Block, ForEach};
use super::grid::Grid;
use super::marks::ALL_CLOSED;
use super::pass::{Bounds, Pass};
use super::placed::Near;
use super::rows::Row;
use super::slabs::Span;
use super::word::Word;
use super::{few, four_rows};
use crate::arithmetic::Quad;
use crate::scalar::Scalar;
use crate::shape::Triangle;

mod set;

/// Whether the machine computes four floats at once.
const HAS_VECTORS: bool = <ForEach as Quad>::IS_VECTOR;
/// How many voxels are few: up to 32.
const FEW: u64 = if HAS_VECTORS { 16 } else { 32 };

impl<S: Copy> Grid<S> {
    /// How many words a row of voxels takes: each begins with a word of its own.
    #[must_use]
    pub const fn row_words<W: Word>(&self) -> usize {
        self.resolution()[0].div_ceil(W::BITS) as usize
    }

    /// How many words the grid takes: those of a row, for each y, for each z. A number too
    /// great for the machine is the greatest number, which no slice has.
    #[must_use]
    pub const fn words<W: Word>(&self) -> usize {
        let [_, y, z] = self.resolution();
        self.row_words::<W>().saturating_mul(y as usize).saturating_mul(z as usize)
    }
}

/// A bit for each voxel of a grid, in the caller's memory.
///
/// The bits of a row lie side by side, x rising, from the least bit of a word of their own on;
/// rows follow each other, y rising, then z. Bits of the last word of a row beyond the grid stay
/// as they are. So the words of two slabs are the words of the one after those of the other, and
/// no two slabs share a word.
///
/// The order in which triangles are filled in, the order of their vertices, and how a grid is
/// parted change no bit.
///
/// ```
/// use septum::voxel::{Bits, Grid, Rule};
/// use septum::Triangle;
///
/// let grid = Grid::new([0.0_f32; 3], [0.25; 3], [64, 64, 64])?;
/// let triangle = Triangle::new([1.0, 1.0, 1.0], [15.0, 2.0, 3.0], [4.0, 14.0, 12.0])?;
///
/// // All at once, and slab by slab in a sixteenth of the memory.
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
    grid: Grid<S>,
    row_words: usize,
    words: &'a mut [W],
}

/// A slice has fewer words than a grid needs.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct TooFewWords {
    /// How many words the grid needs.
    pub needed: usize,
}

impl fmt::Display for TooFewWords {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "a grid of {} words does not fit the slice", self.needed)
    }
}

impl core::error::Error for TooFewWords {}

impl<'a, S: Scalar, W: Word> Bits<'a, S, W> {
    /// The bits of a grid in the first of these words, which stay as they are.
    ///
    /// # Errors
    /// [`TooFewWords`] where the slice has fewer than [`Grid::words`].
    ///
    /// *Panics*: never.
    pub fn new(grid: &Grid<S>, words: &'a mut [W]) -> Result<Self, TooFewWords> {
        let needed = grid.words::<W>();
        match words.get_mut(..needed) {
            Some(words) => Ok(Self { grid: *grid, row_words: grid.row_words::<W>(), words }),
            None => Err(TooFewWords { needed }),
        }
    }

    /// Sets the bits of all voxels that a triangle marks: those of [`Grid::rows`].
    ///
    /// *Panics*: never.
    #[inline]
    pub fn fill(&mut self, triangle: &Triangle<S>, rule: Rule) {
        if rule == Rule::Closed {
            return self.fill_closed(triangle);
        }
        for Row { x, y, z } in self.grid.rows(triangle, rule) {
            self.set_row([y, z], [x.start, x.end - 1]);
        }
    }

    fn fill_closed(&mut self, triangle: &Triangle<S>) {
        let grid = self.grid;
        let near = Near::new(triangle, &grid);
        let bounds = Bounds::new(&near, &grid, ALL_CLOSED);
        if bounds.is_full {
            let [x, y, z] = bounds.bounds;
            for z in z.first..=z.last {
                for y in y.first..=y.last {
                    self.set_row([y as u32, z as u32], [x.first as u32, x.last as u32]);
                }
            }
            return;
        }
        let is_done = Block::of(&bounds).is_some_and(|block| {
            if bounds.is_within && block.voxels() <= FEW {
                self.set_few(&block, few::met(&block, &near, &grid));
                return true;
            }
            HAS_VECTORS
                && four_rows::each(&block, &near, triangle, &grid, |rows| self.set_rows(rows))
        });
        if !is_done {
            let pass = Pass::within(&grid, &near, ALL_CLOSED, bounds);
            pass.each(&grid, |[y, z], Span { first, last }| {
                self.set_row([y as u32, z as u32], [first as u32, last as u32]);
            });
        }
    }

    /// Whether the bit of a voxel is set; `false` for one beyond the grid.
    #[inline]
    #[must_use]
    pub fn contains(&self, [x, y, z]: [u32; 3]) -> bool {
        let [nx, ny, nz] = self.grid.resolution();
        if x >= nx || y >= ny || z >= nz {
            return false;
        }
        let at = self.row_start(y, z) + (x / W::BITS) as usize;
        self.words.get(at).is_some_and(|&word| word >> (x % W::BITS) & W::ONE == W::ONE)
    }

    /// How many bits are set.
    #[must_use]
    pub fn count(&self) -> u64 {
        let beyond = self.row_words as u32 * W::BITS - self.grid.resolution()[0];
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

    /// The grid.
    #[must_use]
    pub const fn grid(&self) -> &Grid<S> {
        &self.grid
    }

    /// Clears all bits.
    pub(super) fn clear(&mut self) {
        self.words.fill(W::ZERO);
    }

    /// Changes the bit of a voxel that the grid has.
    #[inline(always)]
    pub(super) fn flip(&mut self, [x, y, z]: [u32; 3]) {
        let at = self.row_start(y, z) + (x / W::BITS) as usize;
        if let Some(word) = self.words.get_mut(at) {
            *word ^= W::ONE << (x % W::BITS);
        }
    }

    /// Sets the bits of a row from each bit that is set up to before the next one; or, if
    /// `to_none`, no bit.
    pub(super) fn fill_between(&mut self, y: u32, z: u32, to_none: bool) {
        let beyond = self.row_words as u32 * W::BITS - self.grid.resolution()[0];
        let row = self.row_mut(y, z);
        if to_none {
            return row.fill(W::ZERO);
        }
        let mut is_inside = false;
        for word in &mut *row {
            // Each bit becomes the parity of all up to it.
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
