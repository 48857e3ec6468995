//! Polygons of three or more vertices, in the caller's memory, against boxes.
//!
//! ```
//! use septum::polygon::Polygon;
//! use septum::{Aabb, Vec3};
//!
//! let hexagon = [[2, 0, 0], [2, 2, 1], [1, 2, 2], [0, 1, 2], [0, 0, 1], [1, 0, 0]];
//! let hexagon = hexagon.map(|p| Vec3::from(p.map(f64::from)));
//! let polygon = Polygon::new(&hexagon)?;
//! let cell = |x, y, z| Aabb::from_min_max([x, y, z], [x + 1.0, y + 1.0, z + 1.0]).unwrap();
//! assert!(polygon.overlaps(&cell(0.0, 0.0, 1.0)));
//! assert!(!polygon.overlaps(&cell(0.0, 1.0, 0.0)));
//! # Ok::<(), septum::ShapeError>(())
//! ```
//! The test against an axis-aligned box is exact. For every other query, use the polygon's
//! [`triangles`](Polygon::triangles).

pub use crate::shape::Polygon;
