//! Ray and triangle by signed volumes.

use super::stored_normal::{store, stored_normal};
use super::{Limits, line, resolve};
use crate::query::{Cull, Hit};
use crate::scalar::Scalar;
use crate::shape::{Ray, Triangle};

/// Where does the ray cross the triangle, by signed volumes? In the scalar's own arithmetic, and
/// occasionally wrong.
///
/// Choose it for many rays on one triangle, by [`Rays`](crate::lanes::Rays), which then share the
/// normal. One by one it takes as long as [`moller_trumbore`](super::moller_trumbore::hit), whose
/// page compares the methods. It equals [`stored_normal`](super::stored_normal::hit) to the last
/// bit, but computes the normal on the way.
///
/// *Geometry*, *Contact*, *Numerics*: as for [`moller_trumbore`](super::moller_trumbore::hit).
///
/// *Panics*: never. *Cost*: 24 multiplications, 3 divisions, no early exit.
///
/// *Source*: A. Kensler, P. Shirley, "Optimizing Ray-Triangle Intersection via Automated Search",
/// *IEEE Symposium on Interactive Ray Tracing*, 2006. Ours divides last.
#[inline]
#[must_use]
pub fn hit<S: Scalar>(ray: &Ray<S>, triangle: &Triangle<S>, cull: Cull) -> Option<Hit<S>> {
    let fractions = stored_normal(line(ray), store(triangle.points()));
    resolve(fractions, &Limits::new(ray, cull)).into_hit()
}
