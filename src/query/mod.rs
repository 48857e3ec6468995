//! The questions, a folder for each pair of shapes.
//!
//! `mod.rs` of a folder is its front: the question as a `Predicate`, the public methods and
//! their docs. Beside it are the kernel, the error bound with its derivation, and the exact
//! stage; a pair whose kernel is short has them in fewer files. What two pairs share is
//! here: `exact_aabb` and `exact_triangle`, shapes taken apart for exact sums; `line_aabb`,
//! the slabs of rays and segments, and `line_obb`, both against an oriented box; `orientation`,
//! the signs of volumes, for triangles, segments and points against triangles; `relation`, how
//! axes tell touching from overlapping; `either_order`, the same questions with the arguments in
//! the other order. `counts`, in unit tests, says how often questions escalate.

// In the order in which the pages of the shapes show them.
mod triangle_aabb;
mod triangle_obb;
mod triangle_triangle;

mod aabb_aabb;
mod aabb_obb;
mod either_order;
mod line_obb;
mod obb_obb;
mod obb_rows;
mod plane_aabb;
mod point_aabb;
mod point_obb;
mod point_triangle;
mod polygon_aabb;
mod segment_aabb;
mod segment_triangle;

mod ray_aabb;
mod ray_triangle;
mod row_triangle;

mod sweep;

mod normal;

#[cfg(all(test, feature = "fixed"))]
mod counts;
mod exact_aabb;
mod exact_triangle;
mod line_aabb;
mod orientation;
mod relation;

#[cfg(feature = "libm")]
pub(crate) use normal::direction;
pub use plane_aabb::Side;
pub use ray_aabb::PreparedRay;
pub(crate) use ray_triangle::{Candidate, clear_hit, clear_refined_hit, clearly_misses};
pub use ray_triangle::{Cull, Facing, Feature, Hit, HitRay, HitRules, HitTriangle};
pub use relation::{Relate, Relation};
pub(crate) use row_triangle::crossing;
pub use sweep::{FirstContact, Motion, Sweep};
pub use triangle_aabb::{Axis, PreparedTriangle};
pub(crate) use triangle_aabb::{OfOneSize, TriangleAxes, disjoint_rounded};

// The trait stands with the shapes, whose methods call it.
use crate::shape::Overlaps;
