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
//! | cgmath | `cgmath::conv::array3(v)` | `Vector3::from(v.to_array())` |
//! | any of these with its own feature `mint` | `let v: mint::Vector3<f32> = v.into()` | `mint::Vector3::from(v).into()` |
//!
//! ## glam and Bevy
//!
//! ```
//! use glam::Vec3; // in Bevy: bevy::math::Vec3
//! use septum::{Ray, Triangle};
//!
//! let (eye, look) = (Vec3::new(0.2, 0.2, 5.0), Vec3::NEG_Z);
//! let ray = Ray::new(eye.to_array(), look.to_array())?;
//! let [a, b, c] = [Vec3::ZERO, Vec3::X, Vec3::Y].map(|v| v.to_array());
//! let hit = ray.hit(&Triangle::new(a, b, c)?).unwrap();
//! assert_eq!(eye + look * hit.t, Vec3::new(0.2, 0.2, 0.0));
//!
//! // Positions as a mesh loader returns them are arrays, and so are those of Bevy's meshes.
//! let positions: [[f32; 3]; 2] = [[0.0, 1.0, 2.0], [3.0, 0.5, 1.0]];
//! let vertices: Vec<septum::Vec3<f32>> = positions.iter().copied().map(Into::into).collect();
//! assert_eq!(Vec3::from(vertices[1].to_array()), Vec3::new(3.0, 0.5, 1.0));
//! # Ok::<(), septum::ShapeError>(())
//! ```
//!
//! ## nalgebra
//!
//! ```
//! use nalgebra::{Point3, Quaternion, Vector3};
//! use septum::{Aabb, Obb};
//!
//! let (min, max) = (Point3::new(0.0, 0.0, 0.0), Point3::new(1.0, 2.0, 3.0));
//! let of_point = |p: Point3<f64>| <[f64; 3]>::from(p.coords);
//! let room = Aabb::from_min_max(of_point(min), of_point(max))?;
//!
//! // `coords`, also of a `UnitQuaternion`, has the scalar part last, as septum expects it.
//! let turn = Quaternion::new(0.5, 0.5, 0.5, 0.5);
//! let center = <[f64; 3]>::from(Vector3::new(0.5, 1.0, 4.0));
//! let tool = Obb::from_quaternion(center, turn.coords.into(), [1.0, 0.5, 0.5])?;
//! assert!(!tool.overlaps(&room));
//! assert_eq!(Point3::from(tool.center().to_array()), Point3::new(0.5, 1.0, 4.0));
//! # Ok::<(), septum::ShapeError>(())
//! ```
//!
//! ## cgmath
//!
//! ```
//! use cgmath::conv::array3;
//! use cgmath::{InnerSpace, Point3, Vector3};
//! use septum::sweep::{Motion, Sweep};
//! use septum::{Aabb, Triangle};
//!
//! let (start, way) = (Point3::new(1.0_f32, 1.0, 4.0), Vector3::new(0.0, 0.0, -7.0));
//! let body = Aabb::from_center_half_extents(array3(start), [0.5; 3])?;
//! let fall = Motion::new(array3(start), array3(start + way))?;
//! let floor = Triangle::new([0.0; 3], [4.0, 0.0, 0.0], [0.0, 4.0, 0.0])?;
//! let first = body.first_contact(&fall, &floor).unwrap();
//! let normal = Vector3::from(first.normal(&fall, &floor).unwrap().to_array());
//! assert_eq!((first.t, normal.normalize()), (0.5, Vector3::unit_z()));
//! # Ok::<(), septum::ShapeError>(())
//! ```
//!
//! ## By `mint`
//!
//! With the feature `mint` of both crates, vectors of any crate convert in the same way.
//!
//! ```
//! # #[cfg(feature = "mint")] {
//! use septum::Triangle;
//!
//! let a: mint::Point3<f64> = nalgebra::Point3::new(0.0, 0.0, 1.0).into();
//! let b: mint::Vector3<f64> = cgmath::Vector3::new(1.0, 0.0, 1.0).into();
//! let t = Triangle::new(a, b, mint::Point3 { x: 0.0, y: 1.0, z: 1.0 })?;
//!
//! let [a, b, _] = *t.vertices();
//! assert_eq!(nalgebra::Point3::from(mint::Point3::from(a)).z, 1.0);
//! assert_eq!(cgmath::Vector3::from(mint::Vector3::from(b)).x, 1.0);
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
