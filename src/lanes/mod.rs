//! Many shapes at once: structures of arrays, with loops that the compiler turns into vector
//! instructions.
//!
//! ```
//! use septum::lanes::Triangles;
//! use septum::{Ray, Triangle};
//!
//! let floor = |z: f32| Triangle::new([0.0, 0.0, z], [1.0, 0.0, z], [0.0, 1.0, z]);
//! let four = Triangles::new(&[floor(1.0)?, floor(-1.0)?, floor(0.5)?, floor(9.0)?]);
//! let hits = four.hit(&Ray::new([0.25, 0.25, 0.0], [0.0, 0.0, 1.0])?);
//! assert_eq!(hits.mask, [true, false, true, true]);
//! assert_eq!(hits.nearest().unwrap().0, 2); // the lane of the nearest hit
//! # Ok::<(), septum::ShapeError>(())
//! ```
//!
//! | type | query | exact | rounded |
//! | --- | --- | --- | --- |
//! | [`Triangles`] | one ray, N triangles | [`hit`](Triangles::hit) | [`hit_moller_trumbore`](Triangles::hit_moller_trumbore), [`hit_volumes`](Triangles::hit_volumes), [`hit_watertight`](Triangles::hit_watertight) |
//! | [`NormalTriangles`] | one ray, N triangles with stored normals | | [`hit`](NormalTriangles::hit) |
//! | [`Triangles`] | one box, N triangles | [`overlaps`](Triangles::overlaps) | |
//! | [`Aabbs`] | one triangle, N boxes | [`overlaps`](Aabbs::overlaps) | |
//! | [`Cells`] | one triangle, N boxes of one size | [`overlaps`](Cells::overlaps) | |
//! | [`CellTriangle`] | one prepared triangle, N boxes of one size | [`overlaps`](CellTriangle::overlaps) | |
//! | [`Rays`] | N rays, one triangle | | [`hit_moller_trumbore`](Rays::hit_moller_trumbore), [`hit_stored_normal`](Rays::hit_stored_normal), [`hit_volumes`](Rays::hit_volumes) |
//! | [`Aabbs`] | one prepared ray, N boxes | | [`t_range_rounded`](Aabbs::t_range_rounded) |
//! | [`SlabRays`] | N prepared rays, one box | | [`t_range_rounded`](SlabRays::t_range_rounded) |
//!
//! Each lane returns the same bits as the same query on single shapes. N may be any number, in
//! every scalar; 4 suits SSE2, NEON and simd128, and 8 suits AVX2. Without a vector unit, as on a
//! microcontroller, lanes gain nothing.
//!
//! Nothing here panics.

mod aabbs;
mod each_exactly;
mod hits;
mod rays;
mod triangle_axes;
mod triangles;

pub use aabbs::{Aabbs, CellTriangle, Cells};
pub use hits::{Hits, Ranges};
pub use rays::{Rays, SlabRays};
pub use triangles::{NormalTriangles, Triangles};
