//! Ray and triangle by signed volumes.

use super::resolve::{Limits, resolve};
use super::stored_normal::{store, stored_normal};
use super::vector::rounded;
use crate::query::{Cull, Hit};
use crate::scalar::Scalar;
use crate::shape::{Ray, Triangle};

/// Where the ray crosses the triangle, by signed volumes in the scalar's own
/// arithmetic: now and then wrong.
///
/// Choose it for many rays on one triangle, by [`Rays`](crate::lanes::Rays), which then
/// share the normal; one by one it takes the time of
/// [`moller_trumbore`](super::moller_trumbore::hit), where the table is. It is
/// [`stored_normal`](super::stored_normal::hit) with the normal made on the
/// way, to the last bit.
///
/// *Geometry*, *Contact*, *Numerics*: as [`moller_trumbore`](super::moller_trumbore::hit).
///
/// *Panics*: never. *Cost*: 24 multiplications, 3 divisions, no early exit.
///
/// *Source*: A. Kensler, P. Shirley, "Optimizing Ray-Triangle Intersection via
/// Automated Search", *IEEE Symposium on Interactive Ray Tracing*, 2006. Ours
/// divides last.
#[inline]
#[must_use]
pub fn hit<S: Scalar>(ray: &Ray<S>, triangle: &Triangle<S>, cull: Cull) -> Option<Hit<S>> {
    let [a, b, c] = triangle.points();
    let fractions = stored_normal(
        rounded(ray.origin().to_array()),
        rounded(ray.direction().to_array()),
        store([rounded(a), rounded(b), rounded(c)]),
    );
    resolve(fractions, &Limits::new(ray, cull)).into_hit()
}
