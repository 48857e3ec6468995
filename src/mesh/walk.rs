//! The walk through a tree, without a stack.

use core::ops::Range;

use super::node::{LEVELS, Layout, Node};

/// A walk through the leaves of a tree, from left to right.
///
/// `open` has four bits for each node on the current path, one for each child still to be visited;
/// the deepest node has the lowest four. The parent's number follows from a node's number, so the
/// path is not stored.
#[derive(Clone, Debug)]
pub(super) struct Walk {
    node: usize,
    open: u64,
    /// The number of nodes on the current path.
    depth: u32,
}

const _: () = assert!(4 * LEVELS <= u64::BITS as usize);

impl Walk {
    /// Starts at the root, if there is one, and visits its children in `mask`.
    #[inline(always)]
    pub(super) fn new(nodes: &[Node], mask: impl FnOnce(&Node) -> u32) -> Self {
        match nodes.first() {
            Some(root) => Self { node: 0, open: mask(root).into(), depth: 1 },
            None => Self { node: 0, open: 0, depth: 0 },
        }
    }

    /// Returns the triangles of the next leaf. `mask` returns the children of a node to visit, bit
    /// k for child k.
    #[inline(always)]
    pub(super) fn next(
        &mut self,
        nodes: &[Node],
        layout: &Layout,
        mut mask: impl FnMut(&Node) -> u32,
    ) -> Option<Range<usize>> {
        while self.depth > 0 {
            let children = self.open & 0xf;
            if children == 0 {
                self.open >>= 4;
                self.depth -= 1;
                self.node = self.node.saturating_sub(1) / 4;
                continue;
            }
            self.open &= self.open - 1;
            let place = 4 * self.node + 1 + children.trailing_zeros() as usize;
            match nodes.get(place) {
                Some(node) => {
                    self.open = self.open << 4 | u64::from(mask(node));
                    self.depth += 1;
                    self.node = place;
                }
                // Past the last leaf, `leaf` returns an empty range.
                None => return Some(layout.leaf(place)),
            }
        }
        None
    }
}
