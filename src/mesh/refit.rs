//! Trees whose boxes are computed anew, in the order of an earlier build.

use super::build::{Leaves, fill, layout_in_order};
use super::grid::Grid;
use super::node::Node;
use super::{Index, Mesh, MeshError, Tree};
use crate::scalar::Scalar;

impl<'a, S: Scalar, I: Index> Tree<'a, S, I> {
    /// The tree over a mesh whose vertices have moved. `order` is what [`build`](Self::build) made of
    /// it: the tree keeps that order, and its nodes are computed anew.
    ///
    /// A refitted tree never changes an answer, only its cost: build anew when triangles that were
    /// neighbours are far from each other. Iterators yield triangles in the order of the earlier build.
    ///
    /// *Panics*: never. *Cost*: two looks at each triangle, a fraction of a build.
    ///
    /// # Errors
    /// [`MeshError::Length`] unless `nodes` has [`Node::count_for`] elements and `order` has one element
    /// for each triangle; [`MeshError::Order`] unless `order` has each index once.
    ///
    /// ```
    /// use septum::mesh::{Mesh, Node, Tree};
    /// use septum::{Ray, Vec3};
    ///
    /// let mut corners = [[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]].map(Vec3::from);
    /// let faces = [[0_u16, 1, 2]];
    /// let (mut nodes, mut order) = ([Node::EMPTY], [0]);
    /// Tree::build(Mesh::new(&corners, &faces)?, &mut nodes, &mut order)?;
    ///
    /// corners[0].z = -1.0;
    /// let tree = Tree::refit(Mesh::new(&corners, &faces)?, &mut nodes, &order)?;
    /// let down = Ray::new([0.25, 0.25, 1.0], [0.0, 0.0, -1.0])?;
    /// assert_eq!(tree.first_hit(&down).unwrap().1.t, 1.5);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn refit(
        mesh: Mesh<'a, S, I>,
        nodes: &'a mut [Node],
        order: &'a [I],
    ) -> Result<Self, MeshError> {
        let layout = layout_in_order(mesh.triangles.len(), nodes, order)?;
        if !is_permutation(order, nodes) {
            return Err(MeshError::Order);
        }
        let grid = Grid::around(&mesh);
        let index = |place: usize| order.get(place).map_or(0, |i| i.get());
        fill(&layout, nodes, 0..layout.nodes, |place| mesh.cell(&grid, index(place)));
        Ok(Self { mesh, nodes, order, grid, layout })
    }
}

/// Whether a list has each index once. It marks them in the memory of the nodes, 16 in each: n nodes
/// have 12·n + 4 indices at most.
pub(super) fn is_permutation<I: Index>(order: &[I], nodes: &mut [Node]) -> bool {
    nodes.fill(Node([[0; 4]; 6]));
    order.iter().all(|i| {
        let i = i.get();
        let bit = 1 << (i % 16);
        let word = nodes.get_mut(i / 16).and_then(|node| node.0.as_flattened_mut().first_mut());
        i < order.len()
            && word.is_some_and(|word| {
                let is_new = *word & bit == 0;
                *word |= bit;
                is_new
            })
    })
}
