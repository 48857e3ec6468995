//! One ray against N triangles.

use super::{Hits, NormalTriangles, Triangles};
use crate::published::moller_trumbore::moller_trumbore;
use crate::published::stored_normal::{store, stored_normal};
use crate::published::watertight::{ShearedRay, are_zero, edge_functions};
use crate::published::{Limits, resolve, rounded};
use crate::query::Cull;
use crate::scalar::Scalar;
use crate::shape::Ray;

impl<S: Scalar, const N: usize> Triangles<S, N> {
    /// [`moller_trumbore::hit`](crate::published::moller_trumbore::hit) on each of N
    /// triangles at once: the same verdicts, the same bits.
    ///
    /// *Panics*: never. *Cost*: for each vector of triangles, as for one triangle.
    #[inline]
    #[must_use]
    pub fn hit_moller_trumbore(&self, ray: &Ray<S>, cull: Cull) -> Hits<S, N> {
        let limits = Limits::new(ray, cull);
        let (o, d) = (rounded(ray.origin().to_array()), rounded(ray.direction().to_array()));
        Hits::each(|k| {
            let [a, b, c] = self.at(k);
            let triangle = [rounded(a), rounded(b), rounded(c)];
            resolve(moller_trumbore(o, d, triangle), &limits)
        })
    }

    /// [`volumes::hit`](crate::published::volumes::hit) on each of N triangles at once: the
    /// same verdicts, the same bits.
    ///
    /// *Panics*: never. *Cost*: for each vector of triangles, as for one triangle.
    #[inline]
    #[must_use]
    pub fn hit_volumes(&self, ray: &Ray<S>, cull: Cull) -> Hits<S, N> {
        let limits = Limits::new(ray, cull);
        let (o, d) = (rounded(ray.origin().to_array()), rounded(ray.direction().to_array()));
        Hits::each(|k| {
            let [a, b, c] = self.at(k);
            let stored = store([rounded(a), rounded(b), rounded(c)]);
            resolve(stored_normal(o, d, stored), &limits)
        })
    }
}

impl<S: Scalar, const N: usize> NormalTriangles<S, N> {
    /// [`stored_normal::hit`](crate::published::stored_normal::hit) on each of N triangles
    /// at once: the same verdicts, the same bits.
    ///
    /// *Panics*: never. *Cost*: for each vector of triangles, as for one triangle.
    #[inline]
    #[must_use]
    pub fn hit(&self, ray: &Ray<S>, cull: Cull) -> Hits<S, N> {
        let limits = Limits::new(ray, cull);
        let (o, d) = (rounded(ray.origin().to_array()), rounded(ray.direction().to_array()));
        Hits::each(|k| resolve(stored_normal(o, d, self.at(k)), &limits))
    }
}

impl<S: Scalar, const N: usize> Triangles<S, N> {
    /// [`ShearedRay::hit`] on each of N triangles at once: the same verdicts, the same
    /// bits.
    ///
    /// *Panics*: never. *Cost*: for each vector of triangles, as for one triangle.
    #[inline]
    #[must_use]
    pub fn hit_watertight(&self, ray: &ShearedRay<S>, cull: Cull) -> Hits<S, N> {
        let limits = ray.limits(cull);
        let origin = ray.turned(&ray.ray().origin().to_array());
        let [a, b, c] = &self.points;
        let turned = [ray.turned_lanes(a), ray.turned_lanes(b), ray.turned_lanes(c)];
        let at = |k: usize| {
            let [a, b, c] = turned;
            [[a[0][k], a[1][k], a[2][k]], [b[0][k], b[1][k], b[2][k]], [c[0][k], c[1][k], c[2][k]]]
        };
        let mut edge_on = false;
        let hits = Hits::each(|k| {
            let corners = ray.corners(origin, at(k));
            let edges = edge_functions(corners);
            edge_on |= are_zero(edges);
            ray.resolve(corners, edges, &limits)
        });
        if edge_on { Hits::each(|k| ray.seen(origin, at(k), &limits)) } else { hits }
    }
}
