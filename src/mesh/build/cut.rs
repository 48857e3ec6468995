//! The entries of the list that a build sorts: a cut by bisection, and the sort of a few.

use crate::arithmetic::{Each, three};
use crate::mesh::Index;
use crate::mesh::node::{Cell, Grid};
use crate::scalar::Scalar;

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

/// A cut of a part of the list: it moves to the front the entries that come first along the axis of
/// the greatest spread.
#[derive(Clone, Copy, Debug)]
pub(super) struct Cut {
    /// The entries not yet on one side, and the place of the cut.
    from: usize,
    to: usize,
    place: usize,
    /// `None` while the entries are measured.
    axis: Option<usize>,
    /// The ends of the middles along each axis.
    ends: [[u32; 2]; 3],
    /// The range of keys of the entries not yet on one side.
    low: u64,
    high: u64,
    /// The pass: entries before `at` were looked at, and those before `split` are in the lower half.
    at: usize,
    split: usize,
}

impl Cut {
    pub(super) const DONE: Self = Self {
        from: 0,
        to: 0,
        place: 0,
        axis: None,
        ends: [[u32::MAX, 0]; 3],
        low: 0,
        high: 0,
        at: 0,
        split: 0,
    };

    pub(super) fn new([from, place, to]: [usize; 3]) -> Self {
        Self { from, to, place, at: from, split: from, ..Self::DONE }
    }

    pub(super) fn is_done(&self) -> bool {
        self.place <= self.from || self.place >= self.to
    }

    /// Looks at up to `budget` entries, and returns their number.
    pub(super) fn advance<S: Scalar, T: Entry>(
        &mut self,
        grid: &Grid<S>,
        entries: &mut [T],
        cell: impl Fn(usize) -> Cell + Copy,
        budget: usize,
    ) -> usize {
        let end = self.to.min(self.at.saturating_add(budget)).min(entries.len());
        let took = end.saturating_sub(self.at);
        let Some(axis) = self.axis else {
            for entry in entries.get(self.at..end).unwrap_or_default() {
                let middle = middle(&entry.cell(cell));
                for k in 0..3 {
                    let [low, high] = self.ends[k];
                    self.ends[k] = [low.min(middle[k]), high.max(middle[k])];
                }
            }
            self.at = end;
            if end == self.to {
                self.choose(grid);
            }
            return took;
        };
        let key = |entry: &T| u64::from(entry.middle(axis, cell)) << 32 | entry.index() as u64;
        if self.to - self.from <= FEW {
            sort_by_key(entries.get_mut(self.from..self.to).unwrap_or_default(), key);
            self.to = self.from;
            return FEW;
        }
        let (pivot, mut split) = (self.pivot(entries.len()), self.split);
        let part = entries.get_mut(..end).unwrap_or_default();
        for i in self.at..end.min(part.len()) {
            let entry = part[i];
            let is_below = key(&entry) <= pivot;
            // By address, without a branch; an entry that stays is stored over itself.
            let to = if is_below { split.min(i) } else { i };
            part[i] = part[to];
            part[to] = entry;
            split += usize::from(is_below);
        }
        (self.at, self.split) = (end, split);
        if end == self.to {
            if self.place < split {
                (self.to, self.high) = (split, pivot);
            } else {
                (self.from, self.low) = (split, self.after(pivot, entries.len()));
            }
            (self.at, self.split) = (self.from, self.from);
        }
        took
    }

    /// Chooses the axis, after all entries were measured.
    fn choose<S: Scalar>(&mut self, grid: &Grid<S>) {
        let spread = three(|k| grid.size(k, self.ends[k][1] - self.ends[k][0]));
        let axis = if spread[0] >= spread[1] && spread[0] >= spread[2] {
            0
        } else if spread[1] >= spread[2] {
            1
        } else {
            2
        };
        let [low, high] = self.ends[axis];
        self.axis = Some(axis);
        (self.low, self.high) = (u64::from(low) << 32, u64::from(high) << 32 | INDEX);
        self.at = self.from;
    }

    /// A key half way. Its index is one of the list's, for entries with one middle are cut by their index: without
    /// that the first dozen passes would find all of them in the lower half.
    fn pivot(&self, entries: usize) -> u64 {
        let half_way = self.low + (self.high - self.low) / 2;
        half_way - (half_way & INDEX).saturating_sub(last_index(entries))
    }

    /// The least key above another.
    fn after(&self, key: u64, entries: usize) -> u64 {
        if key & INDEX < last_index(entries) { key + 1 } else { (key | INDEX) + 1 }
    }
}

/// The bits of a key that are an index.
const INDEX: u64 = u32::MAX as u64;

fn last_index(entries: usize) -> u64 {
    (entries as u64).saturating_sub(1)
}

/// The number of entries that are sorted one by one.
const FEW: usize = 16;

/// Insertion sort.
pub(super) fn sort_by_key<T: Copy>(all: &mut [T], key: impl Fn(&T) -> u64) {
    for i in 1..all.len() {
        let Some(&entry) = all.get(i) else { return };
        let (mut to, key_of_entry) = (i, key(&entry));
        while let Some(&before) = to.checked_sub(1).and_then(|before| all.get(before)) {
            if key(&before) <= key_of_entry {
                break;
            }
            if let Some(here) = all.get_mut(to) {
                *here = before;
            }
            to -= 1;
        }
        if let Some(here) = all.get_mut(to) {
            *here = entry;
        }
    }
}
