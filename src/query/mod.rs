//! The queries, with a folder for each pair of shapes.
//!
//! The folder's `mod.rs` defines the question as a `Predicate` and the public methods with their
//! documentation. The kernel and the error bound with its derivation are in files
//! beside it; a pair with a short kernel has fewer files.
//!
//! `sphere` holds all pairs with a sphere, `capsule` those with a capsule, by the same kernel, and
//! `point` those with a point.
//!
//! Shared by several pairs:
//! * `line_aabb`: the slabs of rays and segments; `line_obb`: rays and segments against an oriented
//!   box;
//! * `crossing`: the faces through which a ray enters a box and leaves it;
//! * `orientation`: signs of volumes, for triangles, segments and points against triangles;
//! * `obb_rows`, `obb_short`: oriented boxes in vectors of floats, and in short integers;
//! * `one_sided`: triangle and axis-aligned box in machine words;
//! * `relation`: disjoint, touching or overlapping, from separating axes;
//! * `surd`: roots of quadratic equations, rounded, for rays and sweeps with spheres;
//! * `either_order`: the pairs with their arguments exchanged;
//! * `counts`: unit tests of how often questions escalate.

// The order of modules sets the order of methods on the pages of the shapes.
mod triangle_aabb;
mod triangle_obb;
mod triangle_triangle;

mod aabb_aabb;
mod axis;
mod capsule;
mod crossing;
mod either_order;
mod line_obb;
mod obb_obb;
mod obb_rows;
mod obb_short;
mod one_sided;
mod plane_aabb;
mod point;
mod polygon_aabb;
mod segment_aabb;
mod segment_triangle;
mod sphere;

mod ray_aabb;
mod ray_triangle;
mod row_triangle;

mod sweep;

mod normal;

#[cfg(all(test, feature = "fixed"))]
mod counts;
mod line_aabb;
mod orientation;
mod relation;
mod surd;

pub use axis::{Axis, HasAxes};
pub use crossing::Crossing;
#[cfg(feature = "libm")]
pub(crate) use normal::direction;
pub(crate) use orientation::{Vector, from};
pub use plane_aabb::Side;
pub use ray_aabb::PreparedRay;
pub(crate) use ray_triangle::{
    Candidate, clear_hit, clear_misses, clear_refined_hit, line_clearly_misses,
};
pub use ray_triangle::{Cull, Facing, Feature, Hit, HitRay, HitRules, HitTriangle};
pub use relation::{Relate, Relation};
pub(crate) use row_triangle::crossing;
pub use sphere::Closest;
pub(crate) use sphere::{along, compare_distances, product};
#[cfg(feature = "fixed")]
pub use sweep::Moving;
pub use sweep::{FirstContact, Motion, SphereContact, Sweep};
pub use triangle_aabb::PreparedTriangle;
pub(crate) use triangle_aabb::{bound_of_size, disjoint_rounded, range};
pub use triangle_obb::PreparedObb;

// The trait stands with the shapes, whose methods call it.
use crate::shape::Overlaps;
