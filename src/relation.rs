//! Whether two shapes are disjoint, touch or overlap, exactly.
//!
//! [`overlaps`](crate::Overlaps::overlaps) is `true` for shapes that touch. [`Relate::relation`]
//! also says whether their interiors meet.
//!
//! ```
//! use septum::relation::{Relate, Relation};
//! use septum::{Aabb, Triangle};
//!
//! let cell = Aabb::from_min_max([0.0; 3], [1.0; 3])?;
//! let on_top = Triangle::new([0.0, 0.0, 1.0], [1.0, 0.0, 1.0], [0.0, 1.0, 1.0])?;
//! assert_eq!(on_top.relation(&cell), Relation::Touching);
//! let next = Triangle::new([1.0, 0.0, 1.0], [1.0, 1.0, 1.0], [0.0, 1.0, 1.0])?;
//! assert_eq!(on_top.relation(&next), Relation::Touching); // they share an edge
//! let across = Triangle::new([0.5, 0.5, 0.0], [0.5, 0.5, 2.0], [2.0, 2.0, 2.0])?;
//! assert_eq!(across.relation(&cell), Relation::Overlapping);
//! # Ok::<(), septum::ShapeError>(())
//! ```
//!
//! | pair | |
//! | --- | --- |
//! | triangle | triangle, segment, axis-aligned box, oriented box, sphere, capsule |
//! | axis-aligned box | axis-aligned box, oriented box, triangle, sphere, capsule |
//! | oriented box | oriented box, axis-aligned box, triangle |
//! | segment | triangle, sphere, capsule |
//! | sphere | sphere, capsule, triangle, segment, axis-aligned box, plane, ray |
//! | capsule | capsule, sphere, triangle, segment, axis-aligned box, plane |

pub use crate::query::{Relate, Relation};
