#![doc = include_str!("../README.md")]
#![no_std]
#![forbid(unsafe_code)]
#![warn(missing_docs)]

// Unit tests share questions with an example, which knows the crate by its name.
#[cfg(all(test, feature = "fixed"))]
extern crate self as septum;

mod axis;
mod interop;
mod lanes;
mod linear;
mod query;
mod robust;
mod scalar;
mod shape;

pub use axis::Axis;
#[cfg(feature = "heapless")]
pub use interop::{Bounded, touched};
pub use lanes::{Aabbs, Hits, NormalTriangles, Ranges, Rays, SlabRays, Triangles};
pub use linear::Vec3;
pub use query::{Cull, Facing, Feature, Hit, HitRules, MayOverlap, Order, Overlaps, Side};
pub use query::{NormalTriangle, ProjectedTriangle, ShearedRay};
pub use query::{SlabRay, SlopeRay};
#[cfg(feature = "fixed")]
pub use scalar::FixedPoint;
pub use scalar::Scalar;
pub use shape::{Aabb, Obb, Plane, Ray, Segment, ShapeError, Triangle};
