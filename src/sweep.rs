//! Shapes that move: whether they meet others on their way, exactly, and when first.
//!
//! A simulation that looks only at where its bodies are at each tick lets a fast one pass through
//! a thin wall. A sweep looks at all of the way. Its answer is exact, so nothing passes, and the
//! time that it tells is never late.
//!
//! ```
//! use septum::sweep::{Motion, Sweep};
//! use septum::{Aabb, Axis, Triangle};
//!
//! let wall = Triangle::new([0.0, -9.0, -9.0], [0.0, 9.0, -9.0], [0.0, 0.0, 9.0])?;
//! let body = Aabb::from_center_half_extents([5.0, 0.0, 0.0], [1.0, 1.0, 1.0])?;
//! let tick = Motion::new([5.0, 0.0, 0.0], [-3.0, 0.0, 0.0])?; // its centre, before and after
//!
//! assert!(body.meets_along(&tick, &wall));
//! let contact = body.first_contact(&tick, &wall).unwrap();
//! assert_eq!((contact.t, contact.axis), (0.5, Some(Axis::Face(0))));
//! # Ok::<(), septum::ShapeError>(())
//! ```
//!
//! | what moves | past |
//! | --- | --- |
//! | axis-aligned box | triangle, axis-aligned box, [a mesh](crate::mesh::Tree::first_contact) |
//! | triangle | axis-aligned box |
//!
//! Motion is translation. A body may stand still at t = 1, at its new place, or be stopped at the
//! time told: then it has not yet met what it would meet, or touches it.

pub use crate::query::{FirstContact, Motion, Sweep};
