use super::build::{Build, Memory};
use super::{Index, Mesh, MeshError, Node, Scratch, Tree};
use crate::scalar::Scalar;

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
        let build = Build::new(&mesh, nodes, order)?;
        if scratch.len() != order.len() {
            return Err(MeshError::Length { needed: order.len() });
        }
        Ok(Self { mesh, nodes, order, scratch, build })
    }

    /// Looks at about as many triangles as `triangles` says, at least one, and returns whether the
    /// tree is finished. All steps together look at each triangle 40 to 80 times.
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
