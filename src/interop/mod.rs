//! Other crates' types, each behind a feature of its name.
//!
//! `mint`, `serde` and `defmt` add implementations of their traits to the shapes; `libm` and
//! `micromath` add unit normals in floats to [`Triangle`](crate::Triangle). Here are the
//! items that those features add beside the shapes.

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

#[cfg(feature = "fixed")]
pub use crate::scalar::FixedPoint;
#[cfg(feature = "heapless")]
pub use heapless::{Bounded, touched};
