//! Shapes near the origin: queries in 32-bit words alone, with no stage for what is far out.
//!
//! For firmware that has to know its flash and its time. A query on any shape of a 32-bit type has
//! a second stage, in wider words, for coordinates far out. Who knows that the shapes are near
//! says so once, when they are made, and is told if they are not. Then that stage is not linked,
//! and its time cannot occur. `docs/worst-case.md` has the most instructions that each query takes
//! with it and without it.
//!
//! *Near* is within 2¹⁷ units in the last place of zero, on every axis: 2 in `I16F16`, and 131 mm
//! where a unit is a thousandth of one. What has no place may be longer: directions, axes and
//! half-extents are below 2¹⁹ units. Types of 8 and 16 bits have no such stage anyway.
//!
//! ```
//! use fixed::types::I16F16;
//! use septum::near::Near;
//! use septum::{Aabb, Ray, ShapeError, Triangle, Vec3};
//!
//! /// In sixteenths.
//! const fn at(x: i32, y: i32, z: i32) -> Vec3<I16F16> {
//!     let unit = 1 << 12;
//!     Vec3::new(
//!         I16F16::from_bits(x * unit),
//!         I16F16::from_bits(y * unit),
//!         I16F16::from_bits(z * unit),
//!     )
//! }
//! // In flash. The compiler says if it is too far out.
//! static FLOOR: Near<Triangle<I16F16>> = {
//!     let floor = Triangle::<I16F16>::const_new(at(0, 0, 0), at(16, 0, 0), at(0, 16, 0));
//!     ShapeError::unwrap(ShapeError::unwrap(floor).near())
//! };
//!
//! let ray = Ray::new(at(2, 2, 16), at(0, 0, -16))?.near()?;
//! assert_eq!(ray.hit(&FLOOR).unwrap().t, 1);
//! let cell = Aabb::from_min_max(at(0, 0, 0), at(1, 1, 1))?.near()?;
//! assert!(FLOOR.overlaps(&cell));
//!
//! let far = Ray::new(at(2, 2, 90), at(0, 0, -16))?.near();
//! assert_eq!(far, Err(ShapeError::NotNear));
//! # Ok::<(), ShapeError>(())
//! ```
//!
//! | pair | |
//! | --- | --- |
//! | ray, triangle | `hit`, `hit_once`, `hit_with`, `is_hit`, `is_hit_with` |
//! | triangle, axis-aligned box | `overlaps`, `may_overlap` |
//! | triangle, oriented box | `overlaps`, `may_overlap` |
//!
//! Answers are the same bits as those of the shapes as they were.

pub use crate::shape::Near;
