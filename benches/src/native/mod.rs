//! The peers in C and C++, in `f32`: candidates with the feature `native`, none without it.

#[cfg(not(feature = "native"))]
mod absent;
#[cfg(feature = "native")]
mod balls;
#[cfg(feature = "native")]
mod candidates;
#[cfg(feature = "native")]
mod foreign;

#[cfg(not(feature = "native"))]
pub(crate) use absent::{boxes, contacts, rays, trees};
#[cfg(feature = "native")]
pub(crate) use candidates::{boxes, contacts, rays, trees};

#[cfg(not(feature = "native"))]
pub use absent::balls;
#[cfg(feature = "native")]
pub use balls::balls;

/// A peer's spheres near triangles, and its answers about each, by number.
pub struct Balls {
    /// Of the three functions below.
    pub names: [&'static str; 3],
    /// When it meets the triangle on its way.
    pub cast: Box<dyn Fn(usize) -> Option<f32>>,
    /// The depth of their contact.
    pub depth: Box<dyn Fn(usize) -> Option<f32>>,
    /// The point of the triangle that is closest to the center.
    pub closest: Box<dyn Fn(usize) -> [f32; 3]>,
}

/// The names of these peers.
pub(crate) const NAMES: [&str; 4] = ["Bullet", "embree", "Jolt", "tinybvh"];
