//! Points and directions.

mod vec3;

pub use vec3::Vec3;
