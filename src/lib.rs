#![doc = include_str!("../README.md")]
#![no_std]
#![forbid(unsafe_code)]
#![warn(missing_docs)]

mod axis;
mod interop;
mod linear;
mod query;
mod robust;
mod scalar;
mod shape;

pub use axis::Axis;
pub use linear::Vec3;
pub use query::{MayOverlap, Order, Overlaps, Side};
pub use scalar::Scalar;
pub use shape::{Aabb, Obb, Plane, ShapeError, Triangle};
