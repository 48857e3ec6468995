//! The nodes of a tree, their order in memory, and the grid on which their boxes lie: between
//! coordinates in space and 16-bit steps.

use core::ops::Range;

use super::{Index, Mesh};
use crate::arithmetic::{Each, REGISTERS_ARE_WIDE};
use crate::scalar::Scalar;
use crate::shape::{Aabb, joined};

/// The number of triangles in each leaf except the last.
pub(super) const LEAF: usize = 4;

/// The maximum depth of a tree: 2³² triangles have 2³⁰ leaves, in 15 levels of four.
pub(super) const LEVELS: usize = 16;

/// A node of a tree: four boxes, on the tree's grid.
///
/// A node is 48 bytes. The position of its children follows from its own position, so a node holds
/// no links that could be damaged.
///
/// ```
/// use septum::mesh::Node;
///
/// let tree = [Node::EMPTY; Node::count_for(968)];
/// assert_eq!(size_of_val(&tree), 3_888);
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[repr(transparent)]
pub struct Node(pub(super) [[u16; 4]; 6]);

impl Node {
    /// A node without children, to initialize the slice for [`Tree::build`](super::Tree::build).
    pub const EMPTY: Self =
        Self([[u16::MAX; 4], [u16::MAX; 4], [u16::MAX; 4], [0; 4], [0; 4], [0; 4]]);

    /// The number of nodes of a tree over `triangles` triangles: about one for twelve.
    #[must_use]
    pub const fn count_for(triangles: usize) -> usize {
        let leaves = triangles.div_ceil(LEAF);
        match leaves {
            0 => 0,
            1 => 1,
            // Each further node replaces one leaf by four: three leaves more.
            _ => (leaves - 1).div_ceil(3),
        }
    }

    /// A node from its bits, for a table in flash: the least x of the four boxes, then the least y
    /// and z, then the greatest x, y and z.
    #[must_use]
    pub const fn from_bits(bits: [[u16; 4]; 6]) -> Self {
        Self(bits)
    }

    /// The bits of the node, for [`from_bits`](Self::from_bits).
    #[must_use]
    pub const fn to_bits(self) -> [[u16; 4]; 6] {
        self.0
    }

    /// Box `k`.
    #[inline(always)]
    pub(super) fn cell(&self, k: usize) -> Cell {
        let [a, b, c, d, e, f] = &self.0;
        let k = k % 4;
        Cell { low: [a[k], b[k], c[k]], high: [d[k], e[k], f[k]] }
    }

    pub(super) fn set(&mut self, k: usize, cell: Cell) {
        let k = k % 4;
        for i in 0..3 {
            self.0[i][k] = cell.low[i];
            self.0[3 + i][k] = cell.high[i];
        }
    }

    /// The boxes that meet this one: bit k stands for box k.
    #[cfg_attr(not(feature = "small"), inline(always))]
    #[cfg_attr(feature = "small", inline(never))]
    pub(super) fn meeting(&self, cell: &Cell) -> u32 {
        if !REGISTERS_ARE_WIDE {
            // Most boxes are excluded by the first comparisons.
            let on = |i: usize, k: usize| {
                self.0[i][k] <= cell.high[i] && self.0[3 + i][k] >= cell.low[i]
            };
            let meets = |k| on(0, k) && on(1, k) && on(2, k);
            return (0..4).fold(0, |mask, k| mask | u32::from(meets(k)) << k);
        }
        let mut meet = [true; 4];
        for i in 0..3 {
            for k in 0..4 {
                meet[k] &= (self.0[i][k] <= cell.high[i]) & (self.0[3 + i][k] >= cell.low[i]);
            }
        }
        let [a, b, c, d] = meet.each(u32::from);
        a | b << 1 | c << 2 | d << 3
    }
}

/// A box on the grid, both ends included.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Cell {
    pub(super) low: [u16; 3],
    pub(super) high: [u16; 3],
}

impl Cell {
    /// A box that contains no grid point.
    pub(super) const NOTHING: Self = Self { low: [u16::MAX; 3], high: [0; 3] };
    /// The box that contains all grid points.
    pub(super) const ALL: Self = Self { low: [0; 3], high: [u16::MAX; 3] };

    /// Grows the box to enclose `other`.
    pub(super) fn join(&mut self, other: &Self) {
        for i in 0..3 {
            self.low[i] = self.low[i].min(other.low[i]);
            self.high[i] = self.high[i].max(other.high[i]);
        }
    }

    /// Whether this box encloses `other`.
    pub(super) fn encloses(&self, other: &Self) -> bool {
        (0..3).all(|i| self.low[i] <= other.low[i] && other.high[i] <= self.high[i])
    }
}

/// The order of nodes and leaves in memory.
///
/// It is the order of a heap with four children to a node: child k of node i is at place 4·i + 1 +
/// k. A place beyond the last node is a leaf. Leaves from left to right are the leaves of the last
/// level, followed by the leaves of the level above it, and triangles are sorted in that order.
#[derive(Clone, Copy, Debug)]
pub(super) struct Layout {
    /// The number of triangles, of nodes, and of nodes and leaves together.
    triangles: usize,
    pub(super) nodes: usize,
    places: usize,
    /// The first place of the last level.
    last_level: usize,
}

impl Layout {
    pub(super) fn new(triangles: usize) -> Self {
        let nodes = Node::count_for(triangles);
        let places = nodes + triangles.div_ceil(LEAF);
        let mut last_level = 0_usize;
        while let Some(next) = last_level.checked_mul(4).filter(|next| next + 1 < places) {
            last_level = next + 1;
        }
        Self { triangles, nodes, places, last_level }
    }

    /// The places of a node's children.
    #[inline(always)]
    pub(super) fn children(&self, node: usize) -> Range<usize> {
        let first = 4 * node + 1;
        first..self.places.min(first + 4)
    }

    /// The positions of the triangles of the leaf at this place. The last node may have fewer than
    /// four children; a box that covers the whole grid also meets the missing ones, which are
    /// empty.
    #[inline(always)]
    pub(super) fn leaf(&self, place: usize) -> Range<usize> {
        if place >= self.places {
            return 0..0;
        }
        let rank = if place >= self.last_level {
            place - self.last_level
        } else {
            (place + self.places - self.last_level).saturating_sub(self.nodes)
        };
        let first = rank * LEAF;
        first.min(self.triangles)..(first + LEAF).min(self.triangles)
    }

    /// The positions of all triangles below a place.
    pub(super) fn below(&self, place: usize) -> Range<usize> {
        let (mut first, mut last) = (place, place);
        while first < self.nodes {
            first = 4 * first + 1;
        }
        while last < self.nodes {
            last = self.children(last).end - 1;
        }
        self.leaf(first).start..self.leaf(last).end
    }
}

/// The steps along each axis.
#[derive(Clone, Copy, Debug)]
pub(super) struct Grid<S: Scalar>(pub(super) [S::SeptumSteps; 3]);

impl<S: Scalar> Grid<S> {
    /// The grid that encloses all triangles of a mesh.
    pub(super) fn around<I: Index>(mesh: &Mesh<'_, S, I>) -> Self {
        let all = mesh.iter().map(|triangle| triangle.corners()).reduce(joined);
        Self::between(all.unwrap_or([[S::ZERO; 3]; 2]))
    }

    /// The grid between two corners.
    pub(super) fn between([min, max]: [[S; 3]; 2]) -> Self {
        // By pattern, because indices are checked in builds for small code.
        let ([a, b, c], [d, e, f]) = (min, max);
        Self([S::steps(a, d), S::steps(b, e), S::steps(c, f)])
    }

    /// The smallest grid box around the box between two corners, clamped to the grid. It meets
    /// every grid box that encloses a point of the given box.
    #[cfg_attr(not(feature = "small"), inline(always))]
    #[cfg_attr(feature = "small", inline(never))]
    pub(super) fn cell(&self, [min, max]: [[S; 3]; 2]) -> Cell {
        let [x, y, z] = &self.0;
        Cell {
            low: [min[0].point_below(x), min[1].point_below(y), min[2].point_below(z)],
            high: [max[0].point_above(x), max[1].point_above(y), max[2].point_above(z)],
        }
    }

    /// The corners of a grid box, in space.
    #[inline(always)]
    pub(super) fn corners(&self, cell: &Cell) -> [[S; 3]; 2] {
        let [x, y, z] = &self.0;
        let at = |q: [u16; 3]| [S::point(x, q[0]), S::point(y, q[1]), S::point(z, q[2])];
        [at(cell.low), at(cell.high)]
    }

    /// The length of a number of steps along an axis, comparable between axes: its logarithm, with
    /// 17 bits after the exponent.
    pub(super) fn size(&self, axis: usize, steps: u32) -> i64 {
        let Some(log) = steps.checked_ilog2() else { return i64::MIN };
        let digits = (u64::from(steps) << 32 >> log) as u32 >> 15;
        let exponent = S::exponent(&self.0[axis % 3]) + log as i32;
        i64::from(exponent) << 17 | i64::from(digits)
    }

    /// A grid box, in space.
    #[inline(always)]
    pub(super) fn aabb(&self, cell: &Cell) -> Aabb<S> {
        let [min, max] = self.corners(cell);
        Aabb::between(min.into(), max.into())
    }
}

#[cfg(test)]
mod tests {
    use super::{LEAF, LEVELS, Layout, Node};

    /// Each triangle is in one leaf, and below the nodes above that.
    #[test]
    fn every_triangle_has_one_leaf() {
        for n in (1..600).chain([968, 4096, 4097, 16_384, 16_385]) {
            let layout = Layout::new(n);
            assert_eq!(layout.below(0), 0..n, "{n}");
            let (mut leaves, mut deepest) = (0, 0);
            let mut levels = [0; 100_000];
            for node in 0..layout.nodes {
                let mut next = layout.below(node).start;
                let children = layout.children(node);
                assert!(!children.is_empty());
                for place in children {
                    levels[place] = levels[node] + 1;
                    let below = layout.below(place);
                    assert!(below.start == next && below.end > next, "{n}: {place}");
                    next = below.end;
                    if place >= layout.nodes {
                        assert!(below.len() <= LEAF && layout.leaf(place) == below);
                        leaves += 1;
                        deepest = deepest.max(levels[place]);
                    }
                }
                assert_eq!(next, layout.below(node).end);
            }
            assert_eq!(leaves, n.div_ceil(LEAF));
            assert!(4_usize.pow(deepest - 1) < leaves.max(2), "{n}: {deepest}");
        }
        assert!(4_u64.pow(LEVELS as u32 - 1) >= (1 << 32) / LEAF as u64);
        assert_eq!([0, 1, 4, 5, 16, 17, 28, 29].map(Node::count_for), [0, 1, 1, 1, 1, 2, 2, 3]);
    }
}
