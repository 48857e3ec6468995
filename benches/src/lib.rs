//! The speed and the accuracy of septum's tests beside their peers: what the
//! programs of this package have in common.

mod accuracy;
mod candidate;
pub mod chart;
mod drawing;
mod geometry;
pub mod order;
mod pairs;
pub mod paper;
mod peer_shapes;
mod race;
pub mod ray_aabb;
pub mod ray_triangle;
mod report;
pub mod session;
pub mod slivers;
pub mod stability;
pub mod triangle_aabb;
mod unit;

// Cases and oracles, which the crate's tests and examples use too, for an older Rust.
#[allow(clippy::collapsible_if)]
#[path = "../../tests/support/ray_boxes.rs"]
mod ray_boxes;
#[allow(dead_code, clippy::manual_is_multiple_of)]
#[path = "../../examples/shared/mod.rs"]
mod shared;
#[path = "../../tests/support/mod.rs"]
mod support;
