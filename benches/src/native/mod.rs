//! The peers in C and C++, in `f32`: candidates with the feature `native`, none without it.

#[cfg(not(feature = "native"))]
mod absent;
#[cfg(feature = "native")]
mod candidates;
#[cfg(feature = "native")]
mod foreign;

#[cfg(not(feature = "native"))]
pub(crate) use absent::{boxes, contacts, rays, trees};
#[cfg(feature = "native")]
pub(crate) use candidates::{boxes, contacts, rays, trees};

/// The names of these peers.
pub(crate) const NAMES: [&str; 4] = ["Bullet", "embree", "Jolt", "tinybvh"];
