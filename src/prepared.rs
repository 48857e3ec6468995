//! Shapes prepared for many questions: exact, and faster than the shapes themselves.

pub use crate::query::PreparedRay;
