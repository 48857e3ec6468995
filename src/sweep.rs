//! Continuous collision: whether a moving shape meets another on its way, exactly, and at what
//! time.
//!
//! A simulation that tests only positions at each tick lets a fast body pass through a thin wall. A
//! sweep tests all of the motion between two ticks. Its verdict is exact, so no body passes
//! through, and the time of impact that it returns is never late.
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
//! | sphere | triangle, axis-aligned box, [a mesh](crate::mesh::Tree::first_contact) |
//! | triangle | axis-aligned box |
//! | triangle or axis-aligned box [near](crate::near) the origin, as `near::Moving` | the other of the two; the box past a near mesh |
//!
//! The motion is a translation. If nothing is met, the body may stand at its new place, t = 1.
//! Otherwise [`Sweep::last_free`] returns the last place of the scalar on the way where the body
//! does not overlap the obstacle. The place at the time of impact, [`Motion::at`], is rounded, and
//! a body there may overlap the obstacle by a unit in the last place.
//!
//! A body that begins in touch meets the obstacle at time zero. [`Sweep::relation_along`] says
//! whether it is free to move, along the surface or away from it, and [`Sweep::last_free`] lets it.

pub use crate::query::{FirstContact, Motion, SphereContact, Sweep};
