//! Interoperation with other crates, each behind a feature of the crate's name.
//!
//! `mint`, `serde` and `defmt` implement their traits for the shapes. `libm` and `micromath` add
//! unit normals in floats to [`Triangle`](crate::Triangle). This module holds the remaining items.
//!
//! ```
//! # #[cfg(feature = "heapless")] {
//! use septum::interop::{Bounded, touched};
//! use septum::{Aabb, Triangle};
//!
//! let wall = |x| Triangle::new([x, 0.0, 0.0], [x, 1.0, 0.0], [x, 0.0, 1.0]).unwrap();
//! let tool = Aabb::from_min_max([1.0, 0.0, 0.0], [3.0, 1.0, 1.0]).unwrap();
//! let found: Bounded<usize, 4> = touched(&[wall(0.0), wall(1.0), wall(2.0)], &tool);
//! assert_eq!(found.kept(), [1, 2]); // indices, without an allocator
//! # }
//! ```

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
