//! One file for each target.

mod closed_mesh;
mod constructors;
mod contacts;
mod flat_shapes;
mod lanes;
mod line_obb;
mod once;
mod oriented_pairs;
mod plane_aabb;
mod polygon_aabb;
mod ray_aabb;
mod ray_triangle;
mod segment_aabb;
mod spheres;
mod sweeps;
mod triangle_aabb;
mod triangle_obb;
mod unit_normal;

pub use closed_mesh::closed_mesh;
pub use constructors::constructors;
pub use contacts::contacts;
pub use flat_shapes::flat_shapes;
pub use lanes::lanes;
pub use line_obb::line_obb;
pub use oriented_pairs::oriented_pairs;
pub use plane_aabb::plane_aabb;
pub use polygon_aabb::polygon_aabb;
pub use ray_aabb::ray_aabb;
pub use ray_triangle::ray_triangle;
pub use segment_aabb::segment_aabb;
pub use spheres::spheres;
pub use sweeps::sweeps;
pub use triangle_aabb::triangle_aabb;
pub use triangle_obb::triangle_obb;
pub use unit_normal::unit_normal;
