//! Rays and triangles: an oracle that solves for the point and compares
//! fractions, sets of cases, and closed meshes to shoot through.

mod case;
mod fraction;
mod grid;
mod mesh;
mod method;
mod oracle;
mod sets;
mod shots;
mod winding;

pub use case::RayCase;
pub use fraction::Fraction;
pub use grid::{every_triangle, grid};
pub use mesh::Mesh;
pub use method::Method;
pub use oracle::{Truth, crossing, crossing_wide};
pub use sets::RaySet;
pub use shots::{Aim, Count, Scene, Shot};
pub use winding::winding;
