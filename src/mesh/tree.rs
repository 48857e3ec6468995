use super::build::{Build, Leaves, Memory, around, fill, layout, layout_in_order};
use super::node::{Grid, Layout, Node};
use super::{Index, Mesh, MeshError, Scratch};
use crate::scalar::Scalar;

/// A mesh and a bounding-volume hierarchy (BVH) over it: the same answers as testing each triangle,
/// sooner.
///
/// The nodes are in the caller's memory: [`build`](Self::build) fills a slice of them, and
/// [`new`](Self::new) takes a finished table, for example from flash. Each [`Node`] has four boxes
/// with 16-bit coordinates, rounded outward. A leaf is a box with up to four triangles, which have
/// no boxes of their own.
///
/// The tree never changes an answer. Queries return triangles by their indices in the mesh;
/// iterators yield them in the tree's order.
///
/// ```
/// use septum::mesh::{Mesh, Node, Tree};
/// use septum::{Aabb, Ray, Vec3};
///
/// // A tetrahedron.
/// let corners = [[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]].map(Vec3::from);
/// let faces = [[0_u16, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]];
/// let mesh = Mesh::new(&corners, &faces)?;
/// let (mut nodes, mut order) = ([Node::EMPTY; Node::count_for(4)], [0; 4]);
/// let tree = Tree::build(mesh, &mut nodes, &mut order)?;
///
/// let cell = Aabb::from_min_max([0.5, 0.0, 0.0], [2.0; 3])?;
/// assert_eq!(tree.overlapping(&cell).max(), Some(3));
/// let (face, hit) = tree.first_hit(&Ray::new([0.25, 0.25, 2.0], [0.0, 0.0, -1.0])?).unwrap();
/// assert_eq!((face, hit.t), (3, 1.5));
/// assert!(tree.contains([0.25, 0.25, 0.25]) && !tree.contains([0.5, 0.5, 0.5]));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[doc(alias = "BVH")]
#[doc(alias = "bounding volume hierarchy")]
#[derive(Clone, Copy, Debug)]
pub struct Tree<'a, S: Scalar, I> {
    pub(super) mesh: Mesh<'a, S, I>,
    pub(super) nodes: &'a [Node],
    /// The triangles' indices in the tree's order; empty if the mesh itself has that order.
    pub(super) order: &'a [I],
    pub(super) grid: Grid<S>,
    pub(super) layout: Layout,
}

impl<'a, S: Scalar, I: Index> Tree<'a, S, I> {
    /// Builds a tree over a mesh, into `nodes` and `order`.
    ///
    /// *Panics*: never. *Cost*: sorts the triangles, n·log n steps. A
    /// [`TreeBuilder`] computes the box of each triangle once, which takes a
    /// tenth of the time, and can pause.
    ///
    /// # Errors
    /// [`MeshError::Length`] unless `nodes` has [`Node::count_for`] elements and `order` has one
    /// element for each triangle.
    pub fn build(
        mesh: Mesh<'a, S, I>,
        nodes: &'a mut [Node],
        order: &'a mut [I],
    ) -> Result<Self, MeshError> {
        let mut build = Build::new(mesh.triangles.len(), nodes, order)?;
        let mut memory = Memory { leaves: mesh, nodes, entries: order, order: &mut [] as &mut [I] };
        while !build.advance(&mut memory, usize::MAX) {}
        let Build { grid, layout, .. } = build;
        Ok(Self { mesh, nodes, order, grid, layout })
    }

    /// Takes a finished tree, for example from flash. The mesh must list its triangles in the
    /// tree's order, which [`order`](Self::order) returns for a tree that was built.
    ///
    /// *Panics*: never. *Cost*: checks for each node and each triangle that the boxes enclose it.
    /// This refuses each table with which an answer might be wrong, as of another mesh.
    ///
    /// # Errors
    /// [`MeshError::Length`] unless `nodes` has [`Node::count_for`] elements; [`MeshError::Node`]
    /// if a box is too small.
    ///
    /// ```
    /// use septum::Vec3;
    /// use septum::mesh::{Mesh, MeshError, Node, Tree};
    ///
    /// static CORNERS: [Vec3<f32>; 3] =
    ///     [Vec3::new(0.0, 0.0, 0.0), Vec3::new(1.0, 0.0, 0.0), Vec3::new(0.0, 1.0, 0.0)];
    /// static FACES: [[u16; 3]; 1] = [[0, 1, 2]];
    /// static NODES: [Node; 1] = [Node::from_bits([
    ///     [0; 4], [0; 4], [0; 4],
    ///     [32_768, 0, 0, 0], [32_768, 0, 0, 0], [0; 4],
    /// ])];
    ///
    /// let mesh = Mesh::new(&CORNERS, &FACES)?;
    /// let tree = Tree::new(mesh, &NODES)?;
    /// assert!(!tree.contains([0.75, 0.75, 0.0]));
    ///
    /// let broken = Tree::new(mesh, &[Node::EMPTY]);
    /// assert_eq!(broken.unwrap_err(), MeshError::Node { node: 0 });
    /// # Ok::<(), MeshError>(())
    /// ```
    pub fn new(mesh: Mesh<'a, S, I>, nodes: &'a [Node]) -> Result<Self, MeshError> {
        let layout = layout(mesh.triangles.len(), nodes)?;
        let grid = Grid::around(&mesh);
        for (k, node) in nodes.iter().enumerate() {
            for (child, place) in layout.children(k).enumerate() {
                let below = around(&layout, nodes, place, |i| grid.cell(mesh.known(i).corners()));
                if !node.cell(child).encloses(&below) {
                    return Err(MeshError::Node { node: k });
                }
            }
        }
        Ok(Self { mesh, nodes, order: &[], grid, layout })
    }

    /// The indices of the triangles in the tree's order. To make a table for [`new`](Self::new),
    /// write the triangles in this order, and the [nodes](Self::nodes) unchanged.
    pub fn order(&self) -> impl ExactSizeIterator<Item = usize> + '_ {
        (0..self.mesh.triangles.len()).map(|place| self.index(place))
    }

    /// The index in the mesh of the triangle at position `place` of the tree's order.
    #[inline(always)]
    pub(super) fn index(&self, place: usize) -> usize {
        self.order.get(place).map_or(place, |i| i.get())
    }
}

impl<'a, S: Scalar, I> Tree<'a, S, I> {
    /// The mesh.
    #[inline]
    #[must_use]
    pub const fn mesh(&self) -> &Mesh<'a, S, I> {
        &self.mesh
    }

    /// The nodes.
    #[inline]
    #[must_use]
    pub const fn nodes(&self) -> &'a [Node] {
        self.nodes
    }
}

/// Builds a tree with scratch memory: fast, and in steps of bounded length.
///
/// The box of each triangle is computed once, and the triangles are sorted by their boxes. The tree
/// is the tree of [`Tree::build`], whatever the steps.
///
/// ```
/// use septum::Vec3;
/// use septum::mesh::{Mesh, Node, Scratch, Tree, TreeBuilder};
///
/// let vertices: Vec<Vec3<f32>> =
///     (0..300).map(|i| Vec3::new(i as f32, (i * i % 97) as f32, (i % 7) as f32)).collect();
/// let faces: Vec<[u32; 3]> = (0..298).map(|i| [i, i + 1, i + 2]).collect();
/// let mesh = Mesh::new(&vertices, &faces)?;
///
/// let mut nodes = vec![Node::EMPTY; Node::count_for(faces.len())];
/// let mut order = vec![0; faces.len()];
/// let mut scratch = vec![Scratch::EMPTY; faces.len()];
/// let mut builder = TreeBuilder::new(mesh, &mut nodes, &mut order, &mut scratch)?;
/// while !builder.advance(1000) {
///     // Draw the next frame here.
///     assert!((0.0..1.0).contains(&builder.progress()));
/// }
/// let tree = builder.finish();
/// # let (mut nodes, mut order) = (nodes_of(&tree), vec![0; faces.len()]);
/// # fn nodes_of(tree: &Tree<'_, f32, u32>) -> Vec<Node> { vec![Node::EMPTY; tree.nodes().len()] }
/// assert_eq!(tree.nodes(), Tree::build(mesh, &mut nodes, &mut order)?.nodes());
/// # Ok::<(), septum::mesh::MeshError>(())
/// ```
#[derive(Debug)]
pub struct TreeBuilder<'a, 's, S: Scalar, I> {
    mesh: Mesh<'a, S, I>,
    nodes: &'a mut [Node],
    order: &'a mut [I],
    scratch: &'s mut [Scratch],
    build: Build<S>,
}

impl<'a, 's, S: Scalar, I: Index> TreeBuilder<'a, 's, S, I> {
    /// Starts a tree over a mesh, in `nodes` and `order`.
    ///
    /// # Errors
    /// [`MeshError::Length`] unless `nodes` has [`Node::count_for`] elements, and `order` and
    /// `scratch` have one element for each triangle.
    pub fn new(
        mesh: Mesh<'a, S, I>,
        nodes: &'a mut [Node],
        order: &'a mut [I],
        scratch: &'s mut [Scratch],
    ) -> Result<Self, MeshError> {
        let build = Build::new(mesh.triangles.len(), nodes, order)?;
        if scratch.len() != order.len() {
            return Err(MeshError::Length { needed: order.len() });
        }
        Ok(Self { mesh, nodes, order, scratch, build })
    }

    /// Looks at about as many triangles as `triangles` says, at least one, and returns whether the
    /// tree is finished. All steps together look at each triangle some dozens of times, and more often
    /// if many have the same middle.
    ///
    /// *Panics*: never.
    pub fn advance(&mut self, triangles: usize) -> bool {
        let Self { mesh, nodes, order, scratch, build } = self;
        build.advance(&mut Memory { leaves: *mesh, nodes, entries: scratch, order }, triangles)
    }

    /// The share of the work that is done, from 0 to 1.
    #[must_use]
    pub fn progress(&self) -> f32 {
        self.build.progress()
    }

    /// Does what remains, and returns the tree.
    #[must_use]
    pub fn finish(mut self) -> Tree<'a, S, I> {
        while !self.advance(usize::MAX) {}
        let Self { mesh, nodes, order, build: Build { grid, layout, .. }, .. } = self;
        Tree { mesh, nodes, order, grid, layout }
    }
}

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
