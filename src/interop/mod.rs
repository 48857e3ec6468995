//! Other crates' types: one small file each, each behind a feature of its name.

#[cfg(feature = "libm")]
mod libm;
#[cfg(feature = "micromath")]
mod micromath;
#[cfg(feature = "mint")]
mod mint;
#[cfg(feature = "serde")]
mod serde;
