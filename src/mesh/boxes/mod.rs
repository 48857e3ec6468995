//! A tree over boxes that move.

mod moving;
mod overlapping;

use crate::mesh::build::{Build, Leaves, Memory, fill, layout_in_order};
use crate::mesh::node::{Grid, Layout, Node};
use crate::mesh::overlapping::sealed::Bounded;
use crate::mesh::tree::is_permutation;
use crate::mesh::{Index, MeshError};
use crate::scalar::Scalar;
use crate::shape::{Aabb, joined};

pub(super) use moving::is_before;
pub use overlapping::BoxProbe;

/// Boxes and a bounding-volume hierarchy (BVH) over them: see [`broad_phase`](crate::broad_phase).
///
/// It has the nodes of [`mesh::Tree`](crate::mesh::Tree), 48 bytes with four 16-bit boxes
/// each, for about twelve boxes, and an index of 16 or 32 bits for each box.
///
/// Queries return the indices of boxes in the slice, and every list in ascending order.
#[doc(alias = "BVH")]
#[doc(alias = "broad phase")]
#[doc(alias = "dynamic tree")]
#[derive(Clone, Copy, Debug)]
pub struct BoxTree<'a, S: Scalar, I> {
    boxes: &'a [Aabb<S>],
    nodes: &'a [Node],
    order: &'a [I],
    grid: Grid<S>,
    layout: Layout,
    /// Whether a box extends beyond the range of the scalar, where the grid does not reach: then each
    /// box is tested.
    is_beyond: bool,
}

impl<'a, S: Scalar, I: Index> BoxTree<'a, S, I> {
    /// Builds a tree over boxes, into `nodes` and `order`.
    ///
    /// *Panics*: never. *Cost*: sorts the boxes, n·log n steps.
    ///
    /// # Errors
    /// [`MeshError::Length`] unless `nodes` has [`Node::count_for`] elements and `order` has one
    /// element for each box; [`MeshError::TooManyTriangles`] if `I` has fewer values than there are
    /// boxes.
    pub fn build(
        boxes: &'a [Aabb<S>],
        nodes: &'a mut [Node],
        order: &'a mut [I],
    ) -> Result<Self, MeshError> {
        let (layout, _, is_beyond) = Self::frame(boxes, nodes, order)?;
        let mut build = Build::over(layout, boxes.len());
        let mut memory =
            Memory { leaves: boxes, nodes, entries: order, order: &mut [] as &mut [I] };
        while !build.advance(&mut memory, usize::MAX) {}
        let grid = build.grid;
        Ok(Self { boxes, nodes, order, grid, layout, is_beyond })
    }

    /// The tree over boxes that have moved. `order` comes from [`build`](Self::build): the tree keeps
    /// that order, and its nodes are computed anew.
    ///
    /// It answers as a new tree does. `order` may come from any earlier build over as many
    /// boxes, so that a rollback need not restore it.
    ///
    /// *Panics*: never. *Cost*: one look at each box.
    ///
    /// # Errors
    /// As [`build`](Self::build), and [`MeshError::Order`] unless `order` has each index once.
    pub fn refit(
        boxes: &'a [Aabb<S>],
        nodes: &'a mut [Node],
        order: &'a [I],
    ) -> Result<Self, MeshError> {
        let (layout, grid, is_beyond) = Self::frame(boxes, nodes, order)?;
        if !is_permutation(order, nodes) {
            return Err(MeshError::Order);
        }
        let index = |place: usize| order.get(place).map_or(0, |i| i.get());
        fill(&layout, nodes, 0..layout.nodes, |place| boxes.cell(&grid, index(place)));
        Ok(Self { boxes, nodes, order, grid, layout, is_beyond })
    }

    /// The layout and the grid, if the slices have the right lengths.
    fn frame(
        boxes: &[Aabb<S>],
        nodes: &[Node],
        order: &[I],
    ) -> Result<(Layout, Grid<S>, bool), MeshError> {
        if boxes.len() as u64 > I::COUNT {
            return Err(MeshError::TooManyTriangles);
        }
        let layout = layout_in_order(boxes.len(), nodes, order)?;
        let (mut ends, mut is_beyond) = (None, false);
        for aabb in boxes {
            is_beyond |= is_clamped(aabb);
            if let Some(corners) = aabb.corners() {
                ends = Some(ends.map_or(corners, |ends| joined(ends, corners)));
            }
        }
        let grid = Grid::between(ends.unwrap_or([[S::ZERO; 3]; 2]));
        Ok((layout, grid, is_beyond))
    }

    /// The boxes.
    #[inline]
    #[must_use]
    pub const fn boxes(&self) -> &'a [Aabb<S>] {
        self.boxes
    }

    /// The index of the box at position `place` of the tree's order.
    #[inline(always)]
    fn index(&self, place: usize) -> usize {
        self.order.get(place).map_or(0, |i| i.get())
    }
}

impl<S: Scalar> Leaves<S> for &[Aabb<S>] {
    #[inline(always)]
    fn corners(&self, i: usize) -> Option<[[S; 3]; 2]> {
        self.get(i).and_then(Bounded::corners)
    }
}

/// Whether a box extends beyond the range of the scalar. A box of floats that ends there may count as one that
/// does.
fn is_clamped<S: Scalar>(aabb: &Aabb<S>) -> bool {
    let Some((center, half)) = aabb.center_half_extents() else { return false };
    let (center, half) = (center.to_array(), half.to_array());
    let Some([min, max]) = aabb.corners() else { return true };
    // At the end of fixed point a number reaches no further, and a clamped one does not reach back.
    (0..3).any(|k| {
        let ([low, back_up], [back_down, high]) = (min[k].reach(half[k]), max[k].reach(half[k]));
        let is_past = |end: S, next: S, back: S| next == end && back != center[k];
        half[k] > S::ZERO && (is_past(min[k], low, back_up) || is_past(max[k], high, back_down))
    })
}

#[cfg(all(test, feature = "fixed"))]
mod tests {
    use fixed::FixedI8;
    use fixed::types::extra::U0;

    use super::is_clamped;
    use crate::shape::Aabb;

    /// All intervals of eight bits, by whole numbers.
    #[test]
    fn only_what_is_beyond_the_range_is_clamped() {
        for center in i8::MIN..=i8::MAX {
            for half in 0..=i8::MAX {
                let of = |x: i8| [FixedI8::<U0>::ZERO, FixedI8::from_bits(x), FixedI8::ZERO];
                let aabb = Aabb::from_center_half_extents(of(center), of(half)).unwrap();
                let [low, high] = [-1, 1].map(|side| i32::from(center) + side * i32::from(half));
                let is_beyond = low < i32::from(i8::MIN) || high > i32::from(i8::MAX);
                assert_eq!(is_clamped(&aabb), is_beyond, "{center} {half}");
            }
        }
    }
}
