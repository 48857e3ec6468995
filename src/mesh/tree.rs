use super::grid::{Grid, corners};
use super::node::{Cell, LEAF, Layout, Node};
use super::{Index, Mesh, MeshError};
use crate::arithmetic::three;
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
    /// *Panics*: never. *Cost*: sorts the triangles, n·log n steps.
    ///
    /// # Errors
    /// [`MeshError::Length`] unless `nodes` has [`Node::count_for`] elements and `order` has one
    /// element for each triangle.
    pub fn build(
        mesh: Mesh<'a, S, I>,
        nodes: &'a mut [Node],
        order: &'a mut [I],
    ) -> Result<Self, MeshError> {
        let layout = layout(&mesh, nodes)?;
        let grid = Grid::around(&mesh);
        if order.len() != mesh.triangles.len() {
            return Err(MeshError::Length { needed: mesh.triangles.len() });
        }
        for (i, place) in order.iter_mut().enumerate() {
            *place = I::of(i);
        }
        sort(&mesh, &grid, &layout, order);
        for k in (0..nodes.len()).rev() {
            let mut node = Node::EMPTY;
            for (child, place) in layout.children(k).enumerate() {
                let index = |i: usize| order.get(i).map_or(0, |i| i.get());
                node.set(child, around(&mesh, &grid, &layout, nodes, index, place));
            }
            if let Some(to) = nodes.get_mut(k) {
                *to = node;
            }
        }
        Ok(Self { mesh, nodes, order, grid, layout })
    }

    /// Takes a finished tree, for example from flash. The mesh must list its triangles in the
    /// tree's order, which [`order`](Self::order) returns for a tree that was built.
    ///
    /// *Panics*: never. *Cost*: checks for each node and each triangle that the boxes enclose it.
    /// This refuses a damaged table, or a table of another mesh.
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
        let layout = layout(&mesh, nodes)?;
        let grid = Grid::around(&mesh);
        for (k, node) in nodes.iter().enumerate() {
            for (child, place) in layout.children(k).enumerate() {
                let below = around(&mesh, &grid, &layout, nodes, |i| i, place);
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

fn layout<S, I>(mesh: &Mesh<'_, S, I>, nodes: &[Node]) -> Result<Layout, MeshError> {
    let needed = Node::count_for(mesh.triangles.len());
    if nodes.len() == needed {
        Ok(Layout::new(mesh.triangles.len()))
    } else {
        Err(MeshError::Length { needed })
    }
}

/// The smallest grid box around everything below a place: the boxes of a node, or the triangles of
/// a leaf. `index` maps a position in the tree's order to a triangle's index.
fn around<S: Scalar, I: Index>(
    mesh: &Mesh<'_, S, I>,
    grid: &Grid<S>,
    layout: &Layout,
    nodes: &[Node],
    index: impl Fn(usize) -> usize,
    place: usize,
) -> Cell {
    let mut all = Cell::NOTHING;
    match nodes.get(place) {
        Some(node) => {
            for k in 0..layout.children(place).len() {
                all.join(&node.cell(k));
            }
        }
        None => {
            for i in layout.leaf(place) {
                all.join(&grid.cell(corners(&mesh.known(index(i)))));
            }
        }
    }
    all
}

/// Sorts the triangles so that neighbours are close in space: each node cuts its triangles in two
/// along the axis on which they spread most, and each half again.
fn sort<S: Scalar, I: Index>(
    mesh: &Mesh<'_, S, I>,
    grid: &Grid<S>,
    layout: &Layout,
    order: &mut [I],
) {
    for node in 0..layout.nodes {
        let children = layout.children(node);
        let ends = three(|k| {
            let place = children.start + k;
            if place < children.end { layout.below(place).end } else { layout.below(node).end }
        });
        let Some(all) = order.get_mut(layout.below(node)) else { continue };
        let start = layout.below(node).start;
        let [first, half, third] = ends.map(|end| (end - start).min(all.len()));
        cut(mesh, grid, all, half);
        let (left, right) = all.split_at_mut(half);
        cut(mesh, grid, left, first);
        cut(mesh, grid, right, third - half);
    }
    order.chunks_mut(LEAF).for_each(<[I]>::sort_unstable);
}

/// Moves to the front the `count` triangles that come first along the axis on which all of them
/// spread most. Ties are broken by index.
fn cut<S: Scalar, I: Index>(mesh: &Mesh<'_, S, I>, grid: &Grid<S>, order: &mut [I], count: usize) {
    if count == 0 || count >= order.len() {
        return;
    }
    // Twice the centre of the box around a triangle.
    let middles = |i: &I| {
        let cell = grid.cell(corners(&mesh.known(i.get())));
        three(|k| u32::from(cell.low[k]) + u32::from(cell.high[k]))
    };
    let (mut low, mut high) = ([u32::MAX; 3], [0; 3]);
    for middle in order.iter().map(middles) {
        for k in 0..3 {
            low[k] = low[k].min(middle[k]);
            high[k] = high[k].max(middle[k]);
        }
    }
    let spread = three(|k| grid.size(k, high[k] - low[k]));
    let axis = if spread[0] >= spread[1] && spread[0] >= spread[2] {
        0
    } else if spread[1] >= spread[2] {
        1
    } else {
        2
    };
    order.select_nth_unstable_by_key(count, |i| (middles(i)[axis], *i));
}
