//! Speed and accuracy of septum's tests beside their peers: the common parts of the programs in
//! this package.

mod accuracy;
mod candidate;
pub mod chart;
pub mod contact;
pub mod distance;
mod drawing;
mod geometry;
pub mod line_obb;
pub mod native;
pub mod obb_obb;
pub mod obj;
pub mod order;
mod pairs;
pub mod paper;
mod peer_shapes;
pub mod polygon_aabb;
mod race;
pub mod ray_aabb;
pub mod ray_tree;
pub mod ray_triangle;
mod report;
pub mod session;
pub mod slivers;
pub mod stability;
pub mod sweep;
pub mod triangle_aabb;
pub mod triangle_triangle;
pub mod turns;
mod unit;
