//! Rays and triangles: an oracle that solves for the point and compares
//! fractions, sets of cases, and closed meshes to shoot through.

mod case;
mod fraction;
mod mesh;
mod method;
mod oracle;
mod sets;
mod shots;

pub(crate) use case::RayCase;
pub(crate) use fraction::Fraction;
pub(crate) use mesh::Mesh;
pub(crate) use method::Method;
pub(crate) use oracle::{Truth, crossing, crossing_wide};
pub(crate) use sets::RaySet;
pub(crate) use shots::{Aim, Count, Scene, Shot};
