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
//!
//! # Vectors of other crates
//!
//! A constructor takes anything that converts to a [`Vec3`](crate::Vec3): arrays, and with the
//! feature `mint` its vectors and points.
//!
//! | crate | to septum | from septum |
//! | --- | --- | --- |
//! | glam, and Bevy, whose vectors are glam's | `v.to_array()` | `glam::Vec3::from(v.to_array())` |
//! | nalgebra | `<[f32; 3]>::from(v)`, for a point `p.coords.into()` | `Vector3::from(v.to_array())` |
//! | cgmath | `<[f32; 3]>::from(v)` | `Vector3::from(v.to_array())` |
//! | any of these with its own feature `mint` | `mint::Vector3::from(v)` | `mint::Vector3::from(v).into()` |
//!
//! ```
//! use septum::{Aabb, Vec3};
//!
//! // Positions as a mesh loader returns them.
//! let positions: [[f32; 3]; 2] = [[0.0, 1.0, 2.0], [3.0, 0.5, 1.0]];
//! let vertices: Vec<Vec3<f32>> = positions.iter().copied().map(Vec3::from).collect();
//! assert_eq!(Aabb::from_points(positions)?, Aabb::from_points(vertices)?);
//!
//! let corner = glam::Vec3::new(1.0, 2.0, 3.0);
//! let cell = Aabb::from_min_max([0.0; 3], corner.to_array())?;
//! let (_, max) = cell.min_max().unwrap();
//! assert_eq!(glam::Vec3::from(max.to_array()), corner);
//!
//! # #[cfg(feature = "mint")] {
//! // A vector of any crate that implements `mint`'s conversions.
//! let corner = mint::Vector3 { x: 1.0_f32, y: 2.0, z: 3.0 };
//! let cell = Aabb::from_min_max([0.0; 3], corner)?;
//! let (_, max) = cell.min_max().unwrap();
//! assert_eq!(mint::Point3::from(max), mint::Point3 { x: 1.0, y: 2.0, z: 3.0 });
//! # }
//! # Ok::<(), septum::ShapeError>(())
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
