//! Whole meshes: triangles in the caller's memory, or in flash, and a tree over them.
//!
//! A [`Mesh`] is a slice of vertices and a slice of triangles, with indices of 16 or 32 bits. A
//! [`Tree`] is a bounding-volume hierarchy (BVH) over a mesh. It finds the triangles that a box
//! overlaps, the first triangle that a ray hits, whether a closed mesh contains a point, and the
//! overlapping pairs of two meshes, with the same exact answers as testing every triangle. It needs
//! no allocator. The nodes take 48 bytes for twelve triangles; a tree built at run time also takes
//! one index for each triangle.
//!
//! ```
//! use septum::Vec3;
//! use septum::mesh::{Mesh, Node, Tree};
//!
//! // An octahedron.
//! let corners = [
//!     [1.0_f32, 0.0, 0.0], [-1.0, 0.0, 0.0], [0.0, 1.0, 0.0],
//!     [0.0, -1.0, 0.0], [0.0, 0.0, 1.0], [0.0, 0.0, -1.0],
//! ].map(Vec3::from);
//! let faces: [[u16; 3]; 8] = [
//!     [0, 2, 4], [2, 1, 4], [1, 3, 4], [3, 0, 4], [2, 0, 5], [1, 2, 5], [3, 1, 5], [0, 3, 5],
//! ];
//! let mesh = Mesh::new(&corners, &faces)?;
//! mesh.check_closed(&mut [[0; 2]; 24])?;
//!
//! let (mut nodes, mut order) = ([Node::EMPTY; Node::count_for(8)], [0; 8]);
//! let tree = Tree::build(mesh, &mut nodes, &mut order)?;
//! assert!(tree.contains([0.25, 0.25, 0.5])); // on a face
//! assert!(!tree.contains([0.25, 0.25, 0.50000006])); // one unit in the last place off
//! # Ok::<(), septum::mesh::MeshError>(())
//! ```

// The order of modules sets the order of methods on the page of `Tree`: constructors first.
mod indexed;
mod tree;

mod overlapping;
mod ray;

mod closest;

mod pairs;
mod sweep;

// Boxes that move: `broad_phase`.
pub(crate) mod boxes;

mod approach;
mod build;
mod closed;
mod descent;
mod error;
mod from_origin;
mod grid_ray;
mod moving_box;
#[cfg(feature = "fixed")]
mod near;
mod node;
#[cfg(feature = "alloc")]
mod owned;
mod walk;

// Last, as on the pages of the shapes.
mod const_new;

pub use build::Scratch;
pub(crate) use closed::{by_place, sort};
pub use error::MeshError;
pub use indexed::{Index, Mesh};
pub use node::Node;
pub use overlapping::{Overlapping, Probe};
#[cfg(feature = "alloc")]
#[cfg_attr(docsrs, doc(cfg(feature = "alloc")))]
pub use owned::{OwnedTree, OwnedTreeBuilder};
pub use ray::Hits;
pub use sweep::Mover;
pub use tree::{Tree, TreeBuilder};
