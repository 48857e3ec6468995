//! What the fuzz targets check. Each function takes raw bytes, makes shapes of them in
//! the scalar that the first byte names, asks the crate, and panics where the answer
//! is not that of the oracle: the one that the crate's tests have.

mod bytes;
mod checks;
#[cfg(test)]
mod random;
mod scalars;
mod shapes;
mod told;

pub use checks::{
    closed_mesh, constructors, contacts, flat_shapes, lanes, line_obb, oriented_pairs, plane_aabb,
    polygon_aabb, ray_aabb, ray_triangle, segment_aabb, sweeps, triangle_aabb, triangle_obb,
    unit_normal,
};
