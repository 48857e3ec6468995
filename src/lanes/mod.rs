//! Many at once: structures of arrays, and plain loops over them that the
//! compiler turns into vector instructions.

mod aabbs;
mod each_exactly;
mod each_ray;
mod each_triangle;
mod hits;
mod normal_triangles;
mod rays;
mod triangles;

pub use aabbs::{Aabbs, Ranges};
pub use hits::Hits;
pub use normal_triangles::NormalTriangles;
pub use rays::Rays;
pub use triangles::Triangles;
