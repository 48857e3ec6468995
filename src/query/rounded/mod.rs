//! Ray against triangle in the scalar's own arithmetic: the methods as published,
//! each as a kernel that takes one ray and one triangle and never branches on the
//! outcome. The scalar form calls it once, the lanes call it in a loop, so that
//! both give the same bits.

mod moller_trumbore;
mod projected;
mod seen_edge_on;
mod settle;
mod stored_normal;
mod vector;
mod volumes;
mod watertight;

pub(crate) use moller_trumbore::moller_trumbore;
pub use projected::ProjectedTriangle;
pub(crate) use settle::{Found, Limits, settle};
pub use stored_normal::NormalTriangle;
pub(crate) use stored_normal::{Stored, store, stored_normal};
pub(crate) use vector::{Triple, rounded};
pub use watertight::ShearedRay;
pub(crate) use watertight::{are_zero, edges};
