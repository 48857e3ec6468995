//! The separating-axis kernels, on a box centred at the origin.
//!
//! By the separating axis theorem a triangle and a box are disjoint exactly if
//! their projections on one of 13 axes are: the box's three face normals
//! ([`faces`]), the triangle's normal ([`normal`]), and the nine cross products
//! of an edge of each ([`edges`]). For a box whose axes are numbers too, all of
//! them are in [`skewed`].

mod edges;
mod faces;
mod frame;
mod line;
mod name;
mod normal;
mod one_sided;
mod skewed;
mod split;

pub(crate) use edges::{edges, one_edge};
pub(crate) use faces::{faces, one_face};
pub(crate) use frame::{BoxForm, Frame};
pub(crate) use line::Slabs;
pub use name::Axis;
pub(crate) use normal::{normal, plane};
pub(crate) use one_sided::{Shadow, one_sided};
pub(crate) use skewed::{Skewed, skewed};
pub(crate) use split::Split;
