//! Shapes prepared for many queries: the same exact answers, faster.
//!
//! [`PreparedRay`] is for one ray and many boxes, [`PreparedTriangle`] for one triangle and many
//! boxes, [`HitRay`] and [`HitTriangle`] for many rays and many triangles.
//!
//! ```
//! use septum::prepared::PreparedRay;
//! use septum::{Aabb, Ray};
//!
//! let ray = PreparedRay::new(&Ray::new([-1.0_f32, 0.5, 0.5], [1.0, 0.0, 0.0])?);
//! let cells: [_; 4] = core::array::from_fn(|k| {
//!     let y = k as f32 * 0.25;
//!     Aabb::from_min_max([0.0, y, 0.0], [1.0, y + 0.25, 1.0]).unwrap()
//! });
//! assert_eq!(cells.map(|cell| ray.overlaps(&cell)), [false, true, true, false]);
//! # Ok::<(), septum::ShapeError>(())
//! ```

pub use crate::query::{HitRay, HitTriangle, PreparedRay, PreparedTriangle};
