//! The checks of the fuzz targets. Each function takes raw bytes, makes shapes from them in the
//! scalar that the first byte selects, queries the crate, and panics if the answer differs from the
//! oracle's. The oracles are those of the crate's tests.

mod bytes;
mod checks;
#[cfg(test)]
mod random;
mod scalars;
mod shapes;
mod told;

pub use checks::{
    closed_mesh, constructors, contacts, flat_shapes, lanes, line_obb, oriented_pairs, plane_aabb,
    polygon_aabb, ray_aabb, ray_triangle, round_contacts, segment_aabb, spheres, sweeps,
    triangle_aabb, triangle_obb, unit_normal,
};
