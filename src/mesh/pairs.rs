//! Pairs of triangles of two meshes that overlap or cross.

use core::ops::ControlFlow;

use super::node::{Cell, LEVELS};
use super::{Index, Tree};
use crate::scalar::Scalar;
use crate::shape::{Aabb, Segment, Triangle};

/// The greatest number of pairs of places still to be visited: each step down, in either tree, adds
/// three.
const STACK: usize = 3 * 2 * LEVELS + 1;

impl<S: Scalar, I: Index> Tree<'_, S, I> {
    /// Visits every pair of triangles of two meshes that have a point in common, as an index in
    /// this mesh and an index in `other`. It ends early if `visit` breaks.
    ///
    /// *Geometry*: meshes are surfaces here. A mesh strictly inside another has no pair with it; to
    /// find that case, ask [`contains`](Self::contains) about any of its vertices.
    ///
    /// *Contact*: touching is overlap. *Numerics*: exact. *Panics*: never.
    ///
    /// *Cost*: boxes of one tree are converted to the second tree's grid. For two leaves that meet,
    /// each triangle is tested against the opposite leaf's box, and then against its triangles. The
    /// stack has room for 97 pairs, 776 bytes.
    ///
    /// *Source*: the descent in two trees is by S. Gottschalk, M. C. Lin, D. Manocha, "OBBTree: A
    /// Hierarchical Structure for Rapid Interference Detection", SIGGRAPH 1996. Leaves without a
    /// box for each triangle, and the test of a triangle against a box of the opposite tree, are by
    /// P. Terdiman, "Memory-Optimized Bounding-Volume Hierarchies", 2001.
    ///
    /// ```
    /// use core::ops::ControlFlow;
    /// use septum::Vec3;
    /// use septum::mesh::{Mesh, Node, Tree};
    ///
    /// let floor = [[0.0_f32; 3], [9.0, 0.0, 0.0], [0.0, 9.0, 0.0]].map(Vec3::from);
    /// let pin = [[1.0, 1.0, 0.0], [1.0, 1.0, 2.0], [2.0, 1.0, 2.0]].map(Vec3::from);
    /// let (mut a, mut b, mut c, mut d) = ([Node::EMPTY], [0], [Node::EMPTY], [0]);
    /// let floor = Tree::build(Mesh::new(&floor, &[[0_u16, 1, 2]])?, &mut a, &mut b)?;
    /// let pin = Tree::build(Mesh::new(&pin, &[[0_u16, 1, 2]])?, &mut c, &mut d)?;
    ///
    /// let mut pairs = 0;
    /// let _ = floor.overlapping_pairs(&pin, |_, _| {
    ///     pairs += 1; // the tip of the pin touches the floor
    ///     ControlFlow::<()>::Continue(())
    /// });
    /// assert_eq!(pairs, 1);
    /// # Ok::<(), septum::mesh::MeshError>(())
    /// ```
    #[doc(alias = "broad phase")]
    pub fn overlapping_pairs<J: Index, B>(
        &self,
        other: &Tree<'_, S, J>,
        mut visit: impl FnMut(usize, usize) -> ControlFlow<B>,
    ) -> ControlFlow<B> {
        self.near_pairs(other, |i, k, triangle, second| {
            if triangle.overlaps(second) { visit(i, k) } else { ControlFlow::Continue(()) }
        })
    }

    /// Visits every pair of triangles of two meshes that cross in a segment, as an index in this
    /// mesh, an index in `other`, and the segment. It ends early if `visit` breaks.
    ///
    /// The segments make up the curve in which the surfaces intersect; with outward normals it runs
    /// alike along each of its loops. The ends of adjacent segments have the same bits, except at a
    /// point in which an edge crosses an edge: in floats, different pairs may round it differently.
    ///
    /// *Contact*, *Numerics*: as [`Triangle::crossing`]: pairs that touch in a point or lie in one
    /// plane have no segment. An edge that lies in a triangle of the other mesh belongs to two
    /// triangles, and its segment is visited for both. *Panics*: never. *Cost*: the descent of
    /// [`overlapping_pairs`](Self::overlapping_pairs), and [`Triangle::crossing`] for each pair
    /// whose bounding boxes meet.
    ///
    /// ```
    /// use core::ops::ControlFlow;
    /// use septum::mesh::{Mesh, Node, Tree};
    /// use septum::{Segment, Vec3};
    ///
    /// let floor = [[0.0_f32; 3], [9.0, 0.0, 0.0], [0.0, 9.0, 0.0]].map(Vec3::from);
    /// let pin = [[1.0, 1.0, -2.0], [1.0, 1.0, 2.0], [3.0, 1.0, 2.0]].map(Vec3::from);
    /// let (mut a, mut b, mut c, mut d) = ([Node::EMPTY], [0], [Node::EMPTY], [0]);
    /// let floor = Tree::build(Mesh::new(&floor, &[[0_u16, 1, 2]])?, &mut a, &mut b)?;
    /// let pin = Tree::build(Mesh::new(&pin, &[[0_u16, 1, 2]])?, &mut c, &mut d)?;
    ///
    /// let flow = floor.crossings(&pin, |i, k, segment| ControlFlow::Break((i, k, segment)));
    /// let segment = Segment::new([2.0, 1.0, 0.0], [1.0, 1.0, 0.0])?;
    /// assert_eq!(flow, ControlFlow::Break((0, 0, segment)));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    #[doc(alias = "intersection curve")]
    pub fn crossings<J: Index, B>(
        &self,
        other: &Tree<'_, S, J>,
        mut visit: impl FnMut(usize, usize, Segment<S>) -> ControlFlow<B>,
    ) -> ControlFlow<B> {
        self.near_pairs(other, |i, k, triangle, second| match triangle.crossing(second) {
            Some(segment) => visit(i, k, segment),
            None => ControlFlow::Continue(()),
        })
    }

    /// Visits every pair of triangles of two meshes whose bounding boxes meet.
    #[inline(always)]
    fn near_pairs<J: Index, B>(
        &self,
        other: &Tree<'_, S, J>,
        mut visit: impl FnMut(usize, usize, &Triangle<S>, &Triangle<S>) -> ControlFlow<B>,
    ) -> ControlFlow<B> {
        let mut stack = [(0_u32, 0_u32); STACK];
        let mut top = usize::from(!self.nodes.is_empty() && !other.nodes.is_empty());
        while top > 0 {
            top -= 1;
            let Some(&(a, b)) = stack.get(top) else { break };
            let (a, b) = (a as usize, b as usize);
            // Descend in the tree whose place is nearer to its root.
            let goes_first = b >= other.nodes.len() || a <= b && a < self.nodes.len();
            let below = if goes_first {
                self.children_meeting(a, &other.corners_of(b)).map(|mask| (mask, a))
            } else {
                other.children_meeting(b, &self.corners_of(a)).map(|mask| (mask, b))
            };
            let Some((mask, place)) = below else {
                self.visit_leaves(a, other, b, &mut visit)?;
                continue;
            };
            for k in (0..4).filter(|k| mask >> k & 1 == 1) {
                let child = (4 * place + 1 + k) as u32;
                if let Some(to) = stack.get_mut(top) {
                    *to = if goes_first { (child, b as u32) } else { (a as u32, child) };
                }
                top += 1;
            }
        }
        ControlFlow::Continue(())
    }

    /// The children of a node whose boxes meet the box between these corners; `None` for a leaf.
    fn children_meeting(&self, place: usize, corners: &[[S; 3]; 2]) -> Option<u32> {
        self.nodes.get(place).map(|node| node.meeting(&self.grid.cell(*corners)))
    }

    /// The corners, in space, of the box at a place.
    fn corners_of(&self, place: usize) -> [[S; 3]; 2] {
        // The root has no box of its own.
        let Some(parent) = place.checked_sub(1) else { return self.grid.corners(&Cell::ALL) };
        let cell = self.nodes.get(parent / 4).map_or(Cell::ALL, |node| node.cell(parent % 4));
        self.grid.corners(&cell)
    }

    fn visit_leaves<J: Index, B>(
        &self,
        a: usize,
        other: &Tree<'_, S, J>,
        b: usize,
        visit: &mut impl FnMut(usize, usize, &Triangle<S>, &Triangle<S>) -> ControlFlow<B>,
    ) -> ControlFlow<B> {
        let [min, max] = other.corners_of(b);
        let around = Aabb::between(min.into(), max.into());
        for i in self.layout.leaf(a).map(|at| self.index(at)) {
            let triangle = self.mesh.known(i);
            if !triangle.may_overlap(&around) {
                continue;
            }
            for k in other.layout.leaf(b).map(|at| other.index(at)) {
                let second = other.mesh.known(k);
                if are_near(&triangle, &second) {
                    visit(i, k, &triangle, &second)?;
                }
            }
        }
        ControlFlow::Continue(())
    }
}

/// Whether the bounding boxes of two triangles meet: six comparisons, which most pairs fail.
#[inline(always)]
fn are_near<S: Scalar>(a: &Triangle<S>, b: &Triangle<S>) -> bool {
    let ([p, q], [r, s]) = (a.corners(), b.corners());
    (0..3).all(|i| (p[i] <= s[i]) & (r[i] <= q[i]))
}
