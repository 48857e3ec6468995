//! The boxes that a shape overlaps, and all pairs of boxes that overlap.

use super::BoxTree;
use crate::mesh::node::{Cell, LEVELS, Node};
use crate::mesh::overlapping::{mask, sealed::Bounded};
use crate::mesh::walk::Walk;
use crate::mesh::{Index, MeshError, sort};
use crate::scalar::Scalar;
use crate::shape::{Aabb, Overlaps};

/// A shape that [`BoxTree::overlapping`] accepts: an [`Aabb`], an [`Obb`](crate::Obb), a
/// [`Triangle`](crate::Triangle), a [`Segment`](crate::Segment), a [`Sphere`](crate::Sphere) or a
/// [`Capsule`](crate::Capsule).
///
/// The trait is sealed.
pub trait BoxProbe<S: Scalar>: Overlaps<Aabb<S>> + Bounded<S> {}

impl<S: Scalar, P: Overlaps<Aabb<S>> + Bounded<S>> BoxProbe<S> for P {}

impl<S: Scalar, I: Index> BoxTree<'_, S, I> {
    /// The boxes that a shape overlaps, in ascending order, at the front of `found`.
    ///
    /// *Contact*: touching is overlap. *Numerics*: exact, as [`Overlaps::overlaps`]. *Panics*: never.
    ///
    /// *Cost*: as for [`mesh::Tree::overlapping`](crate::mesh::Tree::overlapping), and a sort of what
    /// was found. If a box of the tree extends beyond the range of the scalar, a test of each box.
    ///
    /// # Errors
    /// [`MeshError::Length`] with their number if there are more than `found` can hold.
    ///
    /// ```
    /// use septum::Aabb;
    /// use septum::broad_phase::BoxTree;
    /// use septum::mesh::Node;
    ///
    /// let boxes = [3.0, 1.0, 2.0]
    ///     .map(|x| Aabb::from_min_max([x, 0.0, 0.0], [x + 0.5, 1.0, 1.0]).unwrap());
    /// let (mut nodes, mut order) = ([Node::EMPTY], [0_u16; 3]);
    /// let tree = BoxTree::build(&boxes, &mut nodes, &mut order)?;
    /// let blast = Aabb::from_center_half_extents([2.5, 0.5, 0.5], [0.5; 3])?;
    /// assert_eq!(tree.overlapping(&blast, &mut [0; 3])?, [0, 2]);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn overlapping<'f, P: BoxProbe<S>>(
        &self,
        shape: &P,
        found: &'f mut [I],
    ) -> Result<&'f [I], MeshError> {
        let mut count = 0;
        let cell = shape.corners().map_or(Cell::ALL, |corners| self.grid.cell(corners));
        let mask = |node: &Node| mask(&self.grid, node, &cell, shape);
        let mut walk = Walk::new(self.nodes, mask);
        let mut all = self.is_beyond.then_some(0..self.boxes.len());
        let mut next = || {
            if self.is_beyond { all.take() } else { walk.next(self.nodes, &self.layout, mask) }
        };
        while let Some(leaf) = next() {
            for i in leaf.map(|place| self.index(place)) {
                if self.boxes.get(i).is_some_and(|aabb| shape.overlaps(aabb)) {
                    if let Some(to) = found.get_mut(count) {
                        *to = I::of(i);
                    }
                    count += 1;
                }
            }
        }
        sorted(found, count)
    }
}

/// The first `needed` elements in ascending order, if there is room for them.
fn sorted<T: Copy + Ord>(found: &mut [T], needed: usize) -> Result<&[T], MeshError> {
    let found = found.get_mut(..needed).ok_or(MeshError::Length { needed })?;
    sort(found, Ord::cmp);
    Ok(found)
}

/// The greatest number of pairs of places still to be visited: 16 pairs of children take the place of
/// a pair, on each level and on one below it.
const STACK: usize = 15 * (LEVELS + 1) + 1;

impl<S: Scalar, I: Index> BoxTree<'_, S, I> {
    /// All pairs of boxes that overlap, at the front of `found`: the lesser index first, in ascending
    /// order.
    ///
    /// *Contact*: touching is overlap. *Numerics*: exact, as
    /// [`Overlaps::overlaps`]. *Panics*: never.
    ///
    /// *Cost*: 6 integer comparisons for each pair of nodes that are near, 6 comparisons for each pair
    /// of boxes in leaves that meet, and a sort of what was found. The stack has room for 256 pairs of
    /// nodes, 2 KiB.
    ///
    /// # Errors
    /// [`MeshError::Length`] with the number of pairs if there are more than `found` can hold.
    ///
    /// See [`broad_phase`](crate::broad_phase) for an example.
    pub fn pairs<'f>(&self, found: &'f mut [[I; 2]]) -> Result<&'f [[I; 2]], MeshError> {
        let mut count = 0;
        self.each_pair(|i, j| {
            if let Some(to) = found.get_mut(count) {
                *to = [I::of(i.min(j)), I::of(i.max(j))];
            }
            count = usize::saturating_add(count, 1);
        });
        sorted(found, count)
    }

    fn each_pair(&self, mut visit: impl FnMut(usize, usize)) {
        let mut stack = [(0_u32, 0_u32); STACK];
        let mut top = usize::from(!self.nodes.is_empty());
        while top > 0 {
            top -= 1;
            let Some(&(a, b)) = stack.get(top) else { break };
            let (a, b) = (a as usize, b as usize);
            let mut push = |a: usize, b: usize| {
                if let Some(to) = stack.get_mut(top) {
                    *to = (a as u32, b as u32);
                }
                top += 1;
            };
            match (self.nodes.get(a), self.nodes.get(b)) {
                (Some(node), Some(_)) if a == b => {
                    let children = self.layout.children(a);
                    for (k, child) in children.clone().enumerate() {
                        push(child, child);
                        let mask = node.meeting(&node.cell(k));
                        for j in (k + 1..children.len()).filter(|j| mask >> j & 1 == 1) {
                            push(child, children.start + j);
                        }
                    }
                }
                (Some(first), Some(second)) => {
                    for (k, child) in self.layout.children(a).enumerate() {
                        let mask = second.meeting(&first.cell(k));
                        for j in (0..4).filter(|j| mask >> j & 1 == 1) {
                            push(child, 4 * b + 1 + j);
                        }
                    }
                }
                (Some(node), None) | (None, Some(node)) => {
                    let (inner, leaf) = if a < self.nodes.len() { (a, b) } else { (b, a) };
                    let mask = node.meeting(&self.cell(leaf));
                    for j in (0..4).filter(|j| mask >> j & 1 == 1) {
                        push(4 * inner + 1 + j, leaf);
                    }
                }
                (None, None) => self.leaves(a, b, &mut visit),
            }
        }
    }

    /// The box of a place that is not the root.
    fn cell(&self, place: usize) -> Cell {
        let parent = place.saturating_sub(1) / 4;
        self.nodes.get(parent).map_or(Cell::ALL, |node| node.cell((place + 3) % 4))
    }

    /// The pairs of boxes of two leaves, or of one.
    fn leaves(&self, a: usize, b: usize, visit: &mut impl FnMut(usize, usize)) {
        let [low, high] = self.grid.corners(&self.cell(b));
        for place in self.layout.leaf(a) {
            let i = self.index(place);
            let Some(first) = self.boxes.get(i) else { continue };
            let is_near =
                |[min, max]: [[S; 3]; 2]| (0..3).all(|k| (min[k] <= high[k]) & (low[k] <= max[k]));
            if !first.corners().is_none_or(is_near) {
                continue;
            }
            let others = self.layout.leaf(b);
            let from = if a == b { place + 1 } else { others.start };
            for j in (from..others.end).map(|place| self.index(place)) {
                if self.boxes.get(j).is_some_and(|second| first.overlaps(second)) {
                    visit(i, j);
                }
            }
        }
    }
}
