//! The entries of the list that a build sorts.

use crate::arithmetic::{Each, three};
use crate::mesh::Index;
use crate::mesh::node::Cell;

/// A triangle in the list that a build sorts.
pub(in crate::mesh) trait Entry: Copy {
    fn new(index: usize, cell: impl FnOnce() -> Cell) -> Self;
    fn index(&self) -> usize;
    /// The grid box around the triangle; `compute` returns it for an index.
    fn cell(&self, compute: impl FnOnce(usize) -> Cell) -> Cell;

    /// Twice the centre of the box along an axis.
    #[inline(always)]
    fn middle(&self, axis: usize, compute: impl FnOnce(usize) -> Cell) -> u32 {
        middle(&self.cell(compute))[axis % 3]
    }
}

/// Without scratch memory a triangle's box is computed whenever it is needed.
impl<I: Index> Entry for I {
    fn new(index: usize, _: impl FnOnce() -> Cell) -> Self {
        Self::of(index)
    }

    fn index(&self) -> usize {
        self.get()
    }

    fn cell(&self, compute: impl FnOnce(usize) -> Cell) -> Cell {
        compute(self.get())
    }
}

/// Memory for a fast build: the box of one triangle, 16 bytes.
///
/// A [`TreeBuilder`](crate::mesh::TreeBuilder) needs one for each triangle.
#[derive(Clone, Copy, Debug)]
pub struct Scratch {
    /// The least x, y and z, 16 bits each, and half of the index; the greatest, and the rest. Two
    /// words are moved in registers: with a field for each number the sort took twice as long.
    words: [u64; 2],
}

impl Scratch {
    /// An unused element, to initialize a slice.
    pub const EMPTY: Self = Self { words: [0; 2] };
}

impl Entry for Scratch {
    #[inline(always)]
    fn new(index: usize, cell: impl FnOnce() -> Cell) -> Self {
        let Cell { low, high } = cell();
        let pack = |[x, y, z]: [u16; 3], rest: usize| {
            u64::from(x) | u64::from(y) << 16 | u64::from(z) << 32 | (rest as u64) << 48
        };
        Self { words: [pack(low, index), pack(high, index >> 16)] }
    }

    #[inline(always)]
    fn index(&self) -> usize {
        let [low, high] = self.words;
        (low >> 48 | high >> 48 << 16) as usize
    }

    #[inline(always)]
    fn cell(&self, _: impl FnOnce(usize) -> Cell) -> Cell {
        let unpack = |word: u64| three(|k| (word >> (16 * k)) as u16);
        let [low, high] = self.words;
        Cell { low: unpack(low), high: unpack(high) }
    }

    #[inline(always)]
    fn middle(&self, axis: usize, _: impl FnOnce(usize) -> Cell) -> u32 {
        let [low, high] = self.words.each(|word| u32::from((word >> (16 * (axis % 3))) as u16));
        low + high
    }
}

/// Twice the centre of a box.
#[inline(always)]
pub(super) fn middle(cell: &Cell) -> [u32; 3] {
    three(|k| u32::from(cell.low[k]) + u32::from(cell.high[k]))
}
