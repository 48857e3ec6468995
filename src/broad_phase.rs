//! A broad phase: which of many moving boxes meet.
//!
//! A [`BoxTree`] is a bounding-volume hierarchy (BVH) over boxes in the caller's memory. It finds all
//! pairs of boxes that overlap, the boxes that a shape overlaps, and the first box that a ray enters
//! or that a moving box meets. It allocates nothing.
//!
//! Each tick, after the boxes have moved, [`refit`](BoxTree::refit) keeps the order of the boxes in
//! the tree and computes its nodes anew, in a fraction of the time of [`build`](BoxTree::build).
//!
//! # The same answers, whatever the history
//!
//! No answer depends on the order of the boxes in the tree, and each list is sorted. So a world that
//! was rolled back, loaded or sent need not bring its tree: a tree that is built anew gives the same
//! bits, on every machine.
//!
//! # When to build anew
//!
//! A refitted tree is slower the further boxes have moved from those beside which they were when the
//! tree was built. Build anew about once in as many ticks as a typical box needs to pass one other,
//! and when boxes are added, removed or teleported. In a world in which all boxes move, each by a
//! tenth of its size a tick, that is every 10 to 20 ticks.
//!
//! # A body as large as the world
//!
//! The bounds of nodes lie on a grid of 65,534 steps over all boxes. If a ground plane makes one step as
//! large as the other boxes, nodes no longer tell these apart, and each is tested with each other. Keep
//! such a body out of the tree, and test it alone.
//!
//! ```
//! use septum::Aabb;
//! use septum::broad_phase::BoxTree;
//! use septum::mesh::Node;
//!
//! let at = |x: f32| Aabb::from_center_half_extents([x, 0.0, 0.0], [0.5; 3]).unwrap();
//! let mut bodies = [at(0.0), at(5.0), at(1.0), at(9.0)];
//! let (mut nodes, mut order) = ([Node::EMPTY; Node::count_for(4)], [0_u16; 4]);
//!
//! let mut found = [[0; 2]; 6];
//! let tree = BoxTree::build(&bodies, &mut nodes, &mut order)?;
//! assert_eq!(tree.pairs(&mut found)?, [[0, 2]]); // they touch where x = 0.5
//!
//! bodies[3] = at(5.5);
//! let tree = BoxTree::refit(&bodies, &mut nodes, &order)?;
//! assert_eq!(tree.pairs(&mut found)?, [[0, 2], [1, 3]]);
//! # Ok::<(), septum::mesh::MeshError>(())
//! ```

pub use crate::mesh::boxes::{BoxProbe, BoxTree};
