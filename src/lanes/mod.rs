//! Many at once: structures of arrays, and plain loops over them that the
//! compiler turns into vector instructions.

mod aabbs;
mod each_exactly;
mod each_ray;
mod each_triangle;
mod hits;
mod normal_triangles;
mod ranges;
mod rays;
mod slab_rays;
mod triangles;

pub use aabbs::Aabbs;
pub use hits::Hits;
pub use normal_triangles::NormalTriangles;
pub use ranges::Ranges;
pub use rays::Rays;
pub use slab_rays::SlabRays;
pub use triangles::Triangles;
