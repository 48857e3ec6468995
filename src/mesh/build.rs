//! How a tree is built: the triangles are sorted so that neighbours are close in space, and the
//! boxes of the nodes are joined from the bottom up.
//!
//! Each node cuts its triangles in two along the axis on which their middles spread most, and each
//! half again. A cut finds the triangles that come first by bisection: the middles lie in a range
//! of numbers, and each pass moves those below the middle of the range to the front, and continues
//! in the half that has the place of the cut. Ties are broken by index, so that the keys differ and
//! the tree is the same on every machine. A range of keys halves at most 49 times, which bounds the
//! passes; evenly spread middles take about two passes over the triangles in all.
//!
//! All loops can stop after any triangle: a build is a state that advances.

mod cut;

use core::ops::Range;

use self::cut::{Cut, sort_by_key};
use super::node::{Cell, Grid, LEAF, Layout, Node};
use super::{Index, Mesh, MeshError};
use crate::arithmetic::three;
use crate::scalar::Scalar;
use crate::shape::joined;
use cut::Entry;

pub use cut::Scratch;

/// The next step of a build.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Phase {
    /// Finds the bounds of the mesh.
    Bounds,
    /// Lists the triangles, with their boxes.
    List,
    /// Sorts them.
    Sort,
    /// Sorts each leaf by index.
    Leaves,
    /// Joins the boxes of the nodes.
    Nodes,
    Done,
}

/// The state of a build.
#[derive(Clone, Debug)]
pub(super) struct Build<S: Scalar> {
    pub(super) layout: Layout,
    /// Valid after the first phase.
    pub(super) grid: Grid<S>,
    bounds: Option<[[S; 3]; 2]>,
    phase: Phase,
    /// The next triangle, or the number of nodes still to be joined.
    at: usize,
    /// The node whose triangles are cut, its cuts still to be made, and the cut in progress.
    node: usize,
    cuts: [[usize; 3]; 3],
    cut: Cut,
    /// The triangles looked at, a level of nodes counting once, and their number in all.
    done: u64,
    work: u64,
}

/// The leaves of a tree: the triangles of a mesh, or boxes.
pub(super) trait Leaves<S: Scalar>: Copy {
    /// The corners of the box around leaf `i`; `None` for a box beyond all floats.
    fn corners(&self, i: usize) -> Option<[[S; 3]; 2]>;

    /// The grid box around leaf `i`.
    #[inline(always)]
    fn cell(&self, grid: &Grid<S>, i: usize) -> Cell {
        self.corners(i).map_or(Cell::ALL, |corners| grid.cell(corners))
    }
}

impl<S: Scalar, I: Index> Leaves<S> for Mesh<'_, S, I> {
    #[inline(always)]
    fn corners(&self, i: usize) -> Option<[[S; 3]; 2]> {
        Some(self.known(i).corners())
    }
}

/// A build's memory: `entries` is sorted, and the indices are written to `order`.
pub(super) struct Memory<'m, L, I, T> {
    pub(super) leaves: L,
    pub(super) nodes: &'m mut [Node],
    pub(super) entries: &'m mut [T],
    pub(super) order: &'m mut [I],
}

impl<S: Scalar> Build<S> {
    /// The start of a build, if nodes and order have the right lengths.
    pub(super) fn new<I>(count: usize, nodes: &[Node], order: &[I]) -> Result<Self, MeshError> {
        Ok(Self::over(layout_in_order(count, nodes, order)?, count))
    }

    /// The start of a build over as many triangles or boxes.
    pub(super) fn over(layout: Layout, count: usize) -> Self {
        Self {
            work: work(&layout, count),
            layout,
            grid: Grid::between([[S::ZERO; 3]; 2]),
            bounds: None,
            phase: Phase::Bounds,
            at: 0,
            node: 0,
            cuts: [[0; 3]; 3],
            cut: Cut::DONE,
            done: 0,
        }
    }

    /// Whether the tree is finished.
    pub(super) fn is_done(&self) -> bool {
        self.phase == Phase::Done
    }

    /// The share of the work that is done, from 0 to 1.
    pub(super) fn progress(&self) -> f32 {
        // A share next to one would be rounded to it.
        let share = self.done as f32 / self.work.max(1) as f32;
        if self.is_done() { 1.0 } else { share.min(1.0 - f32::EPSILON) }
    }

    /// Looks at `budget` triangles, or a few more; at one at least. Returns whether the tree is finished.
    pub(super) fn advance<L: Leaves<S>, I: Index, T: Entry>(
        &mut self,
        memory: &mut Memory<'_, L, I, T>,
        budget: usize,
    ) -> bool {
        let mut left = budget.max(1);
        while left > 0 && !self.is_done() {
            let took = match self.phase {
                Phase::Bounds | Phase::List | Phase::Leaves => self.linear(memory, left),
                Phase::Sort => self.sort(memory, left),
                Phase::Nodes | Phase::Done => self.join(memory, left),
            };
            left = left.saturating_sub(took);
        }
        self.is_done()
    }

    /// The phases that visit each triangle once.
    fn linear<L: Leaves<S>, I: Index, T: Entry>(
        &mut self,
        memory: &mut Memory<'_, L, I, T>,
        budget: usize,
    ) -> usize {
        let Memory { leaves, entries, order, .. } = memory;
        let whole_leaves = budget.div_ceil(LEAF).saturating_mul(LEAF);
        let (from, to) = (self.at, entries.len().min(self.at.saturating_add(whole_leaves)));
        match self.phase {
            Phase::Bounds => {
                for i in from..to {
                    let Some(ends) = leaves.corners(i) else { continue };
                    self.bounds = Some(self.bounds.map_or(ends, |all| joined(all, ends)));
                }
            }
            Phase::List => {
                let entries = entries.get_mut(from..to).unwrap_or_default();
                for (i, entry) in (from..to).zip(entries) {
                    *entry = T::new(i, || leaves.cell(&self.grid, i));
                }
            }
            _ => {
                for leaf in entries.get_mut(from..to).unwrap_or_default().chunks_mut(LEAF) {
                    sort_by_key(leaf, |entry| entry.index() as u64);
                }
                let entries = entries.get(from..to).unwrap_or_default();
                for (to, entry) in
                    order.get_mut(from..to).unwrap_or_default().iter_mut().zip(entries)
                {
                    *to = I::of(entry.index());
                }
            }
        }
        self.at = to;
        self.done += (to - from) as u64;
        if to == entries.len() {
            self.at = 0;
            self.phase = match self.phase {
                Phase::Bounds => {
                    self.grid = Grid::between(self.bounds.unwrap_or([[S::ZERO; 3]; 2]));
                    Phase::List
                }
                Phase::List => {
                    self.start_node(0);
                    Phase::Sort
                }
                _ => {
                    self.at = self.layout.nodes;
                    Phase::Nodes
                }
            };
        }
        to - from + 1
    }

    /// Plans the cuts of a node: where each begins, cuts and ends.
    fn start_node(&mut self, node: usize) {
        self.node = node;
        let children = self.layout.children(node);
        let all = self.layout.below(node);
        let [first, half, third] = three(|k| {
            let place = children.start + k;
            if place < children.end { self.layout.below(place).end } else { all.end }
        });
        self.cuts = [[half, third, all.end], [all.start, first, half], [all.start, half, all.end]];
    }

    fn sort<L: Leaves<S>, I: Index, T: Entry>(
        &mut self,
        memory: &mut Memory<'_, L, I, T>,
        budget: usize,
    ) -> usize {
        let Memory { leaves, entries, .. } = memory;
        if self.node >= self.layout.nodes {
            self.phase = Phase::Leaves;
            return 1;
        }
        if self.cut.is_done() {
            let [c, b, a] = self.cuts;
            self.done += (a[2] - a[0]) as u64 / 2;
            self.cuts = [[0; 3], c, b];
            self.cut = Cut::new(a);
            if a == [0; 3] {
                self.start_node(self.node + 1);
            }
            if self.cut.is_done() {
                return 1;
            }
        }
        let cell = |i: usize| leaves.cell(&self.grid, i);
        self.cut.advance(&self.grid, entries, cell, budget) + 1
    }

    fn join<L: Leaves<S>, I: Index, T: Entry>(
        &mut self,
        memory: &mut Memory<'_, L, I, T>,
        budget: usize,
    ) -> usize {
        let Memory { leaves, nodes, entries, .. } = memory;
        let Self { layout, grid, .. } = self;
        let compute = |i: usize| leaves.cell(grid, i);
        let most = (budget / (4 * LEAF)).max(1);
        let from = self.at.saturating_sub(most);
        fill(layout, nodes, from..self.at, |i| {
            entries.get(i).map_or(Cell::NOTHING, |entry| entry.cell(compute))
        });
        let took = 4 * LEAF * (self.at - from);
        self.done += took as u64;
        self.at = from;
        if from == 0 {
            self.phase = Phase::Done;
        }
        took + 1
    }
}

/// The layout of a tree over `count` triangles or boxes, if it has these nodes.
pub(super) fn layout(count: usize, nodes: &[Node]) -> Result<Layout, MeshError> {
    let needed = Node::count_for(count);
    if nodes.len() == needed { Ok(Layout::new(count)) } else { Err(MeshError::Length { needed }) }
}

/// The same, if `order` has an element for each triangle or box.
pub(super) fn layout_in_order<I>(
    count: usize,
    nodes: &[Node],
    order: &[I],
) -> Result<Layout, MeshError> {
    let layout = layout(count, nodes)?;
    if order.len() == count { Ok(layout) } else { Err(MeshError::Length { needed: count }) }
}

/// About how many triangles a build looks at: every triangle in three phases and for each level of
/// nodes, and 16 for each node.
fn work(layout: &Layout, triangles: usize) -> u64 {
    let (mut levels, mut first) = (3, 0_usize);
    while first < layout.nodes {
        (levels, first) = (levels + 1, first.saturating_mul(4).saturating_add(1));
    }
    levels * triangles as u64 + 16 * layout.nodes as u64
}

/// Computes some nodes, from the last to the first; those below them are computed. `cell` is the grid box
/// of the item at a position in the tree's order.
pub(super) fn fill(
    layout: &Layout,
    nodes: &mut [Node],
    range: Range<usize>,
    cell: impl Fn(usize) -> Cell,
) {
    for k in range.rev() {
        let mut node = Node::EMPTY;
        for (child, place) in layout.children(k).enumerate() {
            node.set(child, around(layout, nodes, place, &cell));
        }
        if let Some(to) = nodes.get_mut(k) {
            *to = node;
        }
    }
}

/// The smallest grid box around everything below a place: the boxes of a node, or the triangles of
/// a leaf. `cell` returns the box of the triangle at a position in the tree's order.
pub(super) fn around(
    layout: &Layout,
    nodes: &[Node],
    place: usize,
    cell: impl Fn(usize) -> Cell,
) -> Cell {
    let mut all = Cell::NOTHING;
    match nodes.get(place) {
        Some(node) => {
            for k in 0..layout.children(place).len() {
                all.join(&node.cell(k));
            }
        }
        None => {
            for i in layout.leaf(place) {
                all.join(&cell(i));
            }
        }
    }
    all
}

#[cfg(test)]
mod tests;
