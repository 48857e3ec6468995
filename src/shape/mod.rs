//! The shapes: their data, their invariants, and constructors that check them.

// Before `obb`, so that all constructors come first on the page of `Obb`.
mod rotated_obb;

mod aabb;
mod capsule;
mod error;
mod obb;
mod overlaps;
mod plane;
mod polygon;
mod ray;
mod segment;
mod sphere;
mod triangle;
mod vec3;

// After the constructors of all shapes.
mod bounds;

// Last, so that these methods come last on the pages of the shapes.
mod const_new;
mod near;

pub use aabb::Aabb;
pub(crate) use aabb::{Form as AabbForm, joined};
pub use capsule::Capsule;
pub use error::ShapeError;
pub use near::Near;
pub use obb::Obb;
pub use overlaps::Overlaps;
pub use plane::Plane;
pub use polygon::Polygon;
pub use ray::Ray;
pub(crate) use segment::Form as SegmentForm;
pub use segment::Segment;
pub use sphere::Sphere;
pub use triangle::Triangle;
pub use vec3::Vec3;

use crate::scalar::Scalar;

/// Returns the argument if all its coordinates are finite.
pub(crate) fn finite<S: Scalar>(
    argument: &'static str,
    v: impl Into<Vec3<S>>,
) -> Result<Vec3<S>, ShapeError> {
    finite_at(argument, None, v)
}

/// Returns an element of a list, or an argument, if all its coordinates are finite.
fn finite_at<S: Scalar>(
    argument: &'static str,
    index: Option<usize>,
    v: impl Into<Vec3<S>>,
) -> Result<Vec3<S>, ShapeError> {
    let v = v.into();
    if v.is_finite() { Ok(v) } else { Err(ShapeError::NotFinite { argument, index }) }
}
