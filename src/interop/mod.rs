//! Other crates' types: one small file each, each behind a feature of its name.

#[cfg(feature = "defmt")]
mod defmt;
#[cfg(feature = "heapless")]
mod heapless;
#[cfg(feature = "libm")]
mod libm;
#[cfg(feature = "micromath")]
mod micromath;
#[cfg(feature = "mint")]
mod mint;
#[cfg(feature = "serde")]
mod serde;

#[cfg(feature = "defmt")]
pub use defmt::Logged;
#[cfg(feature = "heapless")]
pub use heapless::{Bounded, touched};

/// Asks nothing of a scalar, where there is no logging.
#[cfg(not(feature = "defmt"))]
pub trait Logged {}

#[cfg(not(feature = "defmt"))]
impl<S> Logged for S {}
