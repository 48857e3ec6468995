use alloc::vec;
use alloc::vec::Vec;

use super::build::{Build, Memory};
use super::node::{Grid, Layout};
use super::{Index, Mesh, MeshError, Node, Scratch, Tree};
use crate::scalar::Scalar;
use crate::shape::Vec3;

/// A mesh and its tree in memory of their own, for a struct to keep.
///
/// It is made from vertices and triangles in any order, which are checked once.
/// [`as_tree`](Self::as_tree) lends it as a [`Tree`], which has the queries. With the feature
/// `serde` it is written as its vertices and triangles; what is read is checked, and its tree
/// built again, by [`new`](Self::new).
///
/// ```
/// use septum::Ray;
/// use septum::mesh::{MeshError, OwnedTree};
///
/// struct Level {
///     ground: OwnedTree<f32>,
/// }
///
/// // A tetrahedron.
/// let corners = [[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
/// let faces = [[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]];
/// let level = Level { ground: OwnedTree::new(corners, faces)? };
///
/// let ray = Ray::new([0.25, 0.25, 2.0], [0.0, 0.0, -1.0])?;
/// let (face, hit) = level.ground.as_tree().first_hit(&ray).unwrap();
/// assert_eq!((face, hit.t), (3, 1.5));
///
/// let bad = OwnedTree::<f32>::new(corners, [[0, 1, 4]]);
/// assert_eq!(bad.unwrap_err(), MeshError::NoSuchVertex { triangle: 0 });
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[doc(alias = "TriMesh")]
#[doc(alias = "BVH")]
#[derive(Clone, Debug)]
pub struct OwnedTree<S: Scalar, I = u32> {
    vertices: Vec<Vec3<S>>,
    triangles: Vec<[I; 3]>,
    nodes: Vec<Node>,
    order: Vec<I>,
    grid: Grid<S>,
    layout: Layout,
}

impl<S: Scalar, I: Index> OwnedTree<S, I> {
    /// A tree over these vertices and triangles. A `Vec` of [`Vec3`] or arrays keeps its memory.
    ///
    /// *Panics*: if there is no memory.
    ///
    /// # Errors
    /// As [`Mesh::new`].
    pub fn new(
        vertices: impl IntoIterator<Item = impl Into<Vec3<S>>>,
        triangles: impl IntoIterator<Item = [I; 3]>,
    ) -> Result<Self, MeshError> {
        Ok(Self::builder(vertices, triangles)?.finish())
    }

    /// Starts a tree that is built in steps, so that a page or a game need not wait for a large
    /// mesh.
    ///
    /// *Panics*: if there is no memory.
    ///
    /// # Errors
    /// As [`Mesh::new`].
    ///
    /// ```
    /// use septum::mesh::OwnedTree;
    ///
    /// let corners: Vec<[f32; 3]> = (0..300).map(|i| [i as f32, (i * i % 97) as f32, 0.0]).collect();
    /// let faces: Vec<[u32; 3]> = (0..298).map(|i| [i, i + 1, i + 2]).collect();
    /// let mut builder = OwnedTree::builder(corners, faces)?;
    /// while !builder.advance(1000) {
    ///     // Draw the next frame here.
    ///     assert!((0.0..1.0).contains(&builder.progress()));
    /// }
    /// let tree = builder.finish();
    /// assert_eq!(tree.mesh().triangles().len(), 298);
    /// # Ok::<(), septum::mesh::MeshError>(())
    /// ```
    pub fn builder(
        vertices: impl IntoIterator<Item = impl Into<Vec3<S>>>,
        triangles: impl IntoIterator<Item = [I; 3]>,
    ) -> Result<OwnedTreeBuilder<S, I>, MeshError> {
        let vertices: Vec<_> = vertices.into_iter().map(Into::into).collect();
        let triangles: Vec<_> = triangles.into_iter().collect();
        let mesh = Mesh::new(&vertices, &triangles)?;
        let n = triangles.len();
        let (nodes, order) = (vec![Node::EMPTY; Node::count_for(n)], vec![I::of(0); n]);
        let build = Build::new(mesh.triangles.len(), &nodes, &order)?;
        let Build { grid, layout, .. } = build;
        let tree = Self { vertices, triangles, nodes, order, grid, layout };
        Ok(OwnedTreeBuilder { tree, scratch: vec![Scratch::EMPTY; n], build })
    }

    /// The tree as its queries take it, without another check.
    #[inline]
    #[must_use]
    pub fn as_tree(&self) -> Tree<'_, S, I> {
        let Self { nodes, order, grid, layout, .. } = self;
        Tree { mesh: self.mesh(), nodes, order, grid: *grid, layout: *layout }
    }

    /// The mesh, without another check.
    #[inline]
    #[must_use]
    pub fn mesh(&self) -> Mesh<'_, S, I> {
        Mesh { vertices: &self.vertices, triangles: &self.triangles }
    }

    /// The vertices and triangles, as they were given.
    #[must_use]
    pub fn into_parts(self) -> (Vec<Vec3<S>>, Vec<[I; 3]>) {
        (self.vertices, self.triangles)
    }
}

/// An [`OwnedTree`] that is being built: see [`OwnedTree::builder`].
#[derive(Clone, Debug)]
pub struct OwnedTreeBuilder<S: Scalar, I = u32> {
    /// Without a valid tree yet.
    tree: OwnedTree<S, I>,
    scratch: Vec<Scratch>,
    build: Build<S>,
}

impl<S: Scalar, I: Index> OwnedTreeBuilder<S, I> {
    /// As [`TreeBuilder::advance`](super::TreeBuilder::advance).
    pub fn advance(&mut self, triangles: usize) -> bool {
        let OwnedTree { vertices, triangles: faces, nodes, order, .. } = &mut self.tree;
        let mesh = Mesh { vertices: &vertices[..], triangles: &faces[..] };
        self.build.advance(
            &mut Memory { leaves: mesh, nodes, entries: &mut self.scratch, order },
            triangles,
        )
    }

    /// The share of the work that is done, from 0 to 1.
    #[must_use]
    pub fn progress(&self) -> f32 {
        self.build.progress()
    }

    /// Does what remains, and returns the tree.
    #[must_use]
    pub fn finish(mut self) -> OwnedTree<S, I> {
        while !self.advance(usize::MAX) {}
        let Build { grid, layout, .. } = self.build;
        OwnedTree { grid, layout, ..self.tree }
    }
}
