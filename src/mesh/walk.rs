//! The walks through a tree: without a stack, and nearest first.

use core::ops::{ControlFlow, Range};

use super::node::{LEVELS, Layout, Node};
use crate::arithmetic::REGISTERS_ARE_WIDE;

/// The children of a node that the ray meets, and the order in which it reaches them.
pub(super) struct Met {
    /// Bit k stands for child k.
    pub(super) mask: u32,
    /// A sort key: lesser means sooner. Keys below zero need no order among themselves.
    pub(super) sooner: [i32; 4],
}

/// A moving object that descends a tree in the order in which it reaches the boxes.
pub(super) trait Descend {
    /// The boxes of a node that the object meets.
    fn meets(&self, node: &Node) -> Met;
    /// Whether a child with this key may still be met.
    fn reaches(&self, sooner: i32) -> bool;
}

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

/// The number of nodes that are tested at a time. On a wide processor the second costs little: each
/// step down a tree waits for the step before.
const AT_A_TIME: usize = if REGISTERS_ARE_WIDE { 2 } else { 1 };

/// The room for places still to be visited. Deeper places lie above others. A tested node leaves four
/// places at the next depth, and is gone itself: a depth below others keeps three for each node
/// tested at a time. A leaf next to the last node may add one; `LEVELS` exceeds the depth of any
/// tree, and has room for it.
const STACK: usize = 3 * AT_A_TIME * LEVELS + 4 * AT_A_TIME;

/// A place below its key: such numbers are in the order of the keys.
#[inline(always)]
fn entry(sooner: i32, place: usize) -> i64 {
    i64::from(sooner) << 32 | i64::from(place as u32)
}

/// Visits the leaves near a moving object, roughly in the order in which it reaches them, until a
/// visit breaks.
#[inline(always)]
pub(super) fn descend<D: Descend>(
    nodes: &[Node],
    layout: &Layout,
    descent: &mut D,
    mut visit: impl FnMut(&mut D, Range<usize>) -> ControlFlow<()>,
) -> ControlFlow<()> {
    let mut stack = [entry(i32::MIN, 0); STACK];
    let mut top = usize::from(!nodes.is_empty());
    let open = |entry: i64| {
        let place = entry as u32 as usize;
        (place, nodes.get(place))
    };
    while top > 0 {
        top -= 1;
        let Some(&entry) = stack.get(top) else { break };
        if !descent.reaches((entry >> 32) as i32) {
            continue;
        }
        let (place, node) = open(entry);
        let Some(node) = node else {
            visit(descent, layout.leaf(place))?;
            continue;
        };
        let below = if AT_A_TIME == 2 { stack.get(..top).and_then(|all| all.last()) } else { None };
        let met = descent.meets(node);
        if let Some((entry, (place, Some(node)))) = below.map(|&entry| (entry, open(entry))) {
            let mut met = descent.meets(node);
            if !descent.reaches((entry >> 32) as i32) {
                met.mask = 0;
            }
            top = store(&mut stack, top - 1, place, &met);
        }
        top = store(&mut stack, top, place, &met);
    }
    ControlFlow::Continue(())
}

/// Puts the children that are met on the stack, the nearest on top; returns the new top.
#[inline(always)]
fn store(stack: &mut [i64; STACK], top: usize, place: usize, met: &Met) -> usize {
    debug_assert!(top + 4 <= STACK);
    if let Some(to) = stack.get_mut(top..top + 4) {
        to.copy_from_slice(&farthest_first(met, place));
    }
    top + met.mask.count_ones() as usize
}

/// The entries of the children that are met, the nearest last; then the other children. A network of
/// comparisons sorts them, because no branch could be predicted.
#[inline(always)]
fn farthest_first(&Met { mask, sooner }: &Met, place: usize) -> [i64; 4] {
    let child = |k: usize| {
        let entry = entry(sooner[k % 4], 4 * place + 1 + k);
        if mask >> k & 1 == 1 { entry } else { i64::MIN }
    };
    let sorted = |a: i64, b: i64| if a > b { (a, b) } else { (b, a) };
    let (a, b) = sorted(child(0), child(1));
    let (c, d) = sorted(child(2), child(3));
    let ((a, c), (b, d)) = (sorted(a, c), sorted(b, d));
    let (b, c) = sorted(b, c);
    [a, b, c, d]
}

#[cfg(test)]
mod tests {
    use crate::arithmetic::Each;
    extern crate std;

    use std::vec::Vec;

    use super::*;
    use crate::mesh::node::Cell;
    use crate::random::Random;

    /// Boxes whose least x is the key, up to a limit.
    struct Upto(i32);

    impl Descend for Upto {
        fn meets(&self, node: &Node) -> Met {
            let key = |k: usize| i32::from(node.cell(k).low[0]);
            let mask = (0..4).filter(|&k| node.cell(k) != Cell::NOTHING).fold(0, |m, k| m | 1 << k);
            Met { mask, sooner: [key(0), key(1), key(2), key(3)] }
        }
        fn reaches(&self, sooner: i32) -> bool {
            sooner <= self.0
        }
    }

    /// All orders of keys, all sets of children.
    #[test]
    fn the_nearest_child_is_last() {
        for case in 0..16 * 256 {
            let (mask, keys) = (case & 15, case >> 4);
            let sooner = [0, 2, 4, 6].each(|shift| (keys >> shift & 3) as i32 - 1);
            let mut expected: Vec<i64> = (0..4)
                .filter(|k| mask >> k & 1 == 1)
                .map(|k| entry(sooner[k], 4 * 7 + 1 + k))
                .collect();
            expected.sort_unstable_by(|a, b| b.cmp(a));
            let found = farthest_first(&Met { mask, sooner }, 7);
            assert_eq!(found[..expected.len()], expected, "{mask} {sooner:?}");
        }
    }

    /// Every leaf within the limit is visited once, whatever the order of the keys.
    #[test]
    fn no_leaf_is_lost() {
        for triangles in (1..90).chain([1_000, 5_000]) {
            let mut random = Random(triangles as u64);
            let (layout, count) = (Layout::new(triangles), Node::count_for(triangles));
            let mut nodes = std::vec![Node::EMPTY; count];
            let mut keys = std::vec![0_u16; 4 * count + 1];
            for node in 0..count {
                for (k, place) in layout.children(node).enumerate() {
                    keys[place] = keys[node] + (random.bits() >> 60) as u16;
                    let low = [keys[place], 0, 0];
                    nodes[node].set(k, Cell { low, high: [u16::MAX; 3] });
                }
            }
            for limit in [0, 10, 25, i32::MAX] {
                let mut visited = Vec::new();
                let all = descend(&nodes, &layout, &mut Upto(limit), |_, leaf| {
                    visited.extend(leaf);
                    ControlFlow::Continue(())
                });
                assert!(all.is_continue());
                visited.sort_unstable();
                let places = (count..4 * count + 1).filter(|&p| i32::from(keys[p]) <= limit);
                let mut expected: Vec<usize> = places.flat_map(|p| layout.leaf(p)).collect();
                expected.sort_unstable();
                assert_eq!(visited, expected, "{triangles} {limit}");
            }
        }
    }
}
