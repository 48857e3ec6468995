//! One ray against N triangles.

use super::{Hits, NormalTriangles, Triangles};
use crate::query::{
    Cull, Limits, ShearedRay, are_zero, edges, moller_trumbore, rounded, settle, store,
    stored_normal,
};
use crate::scalar::Scalar;
use crate::shape::Ray;

impl<S: Scalar> Ray<S> {
    /// [`hit_moller_trumbore`](Self::hit_moller_trumbore) on each of N triangles at once: the
    /// same verdicts, the same bits.
    ///
    /// *Panics*: never. *Cost*: that of one for each vector of them.
    #[inline]
    pub fn hit_each_moller_trumbore<const N: usize>(
        &self,
        triangles: &Triangles<S, N>,
        cull: Cull,
    ) -> Hits<S, N> {
        let limits = Limits::new(self, cull);
        let (o, d) = (rounded(self.origin().to_array()), rounded(self.direction().to_array()));
        Hits::each(|k| {
            let [a, b, c] = triangles.at(k);
            let triangle = [rounded(a), rounded(b), rounded(c)];
            settle(moller_trumbore(o, d, triangle), &limits)
        })
    }

    /// [`hit_stored_normal`](Self::hit_stored_normal) on each of N triangles at once: the
    /// same verdicts, the same bits.
    ///
    /// *Panics*: never. *Cost*: that of one for each vector of them.
    #[inline]
    pub fn hit_each_stored_normal<const N: usize>(
        &self,
        triangles: &NormalTriangles<S, N>,
        cull: Cull,
    ) -> Hits<S, N> {
        let limits = Limits::new(self, cull);
        let (o, d) = (rounded(self.origin().to_array()), rounded(self.direction().to_array()));
        Hits::each(|k| settle(stored_normal(o, d, triangles.at(k)), &limits))
    }

    /// [`hit_volumes`](Self::hit_volumes) on each of N triangles at once: the
    /// same verdicts, the same bits.
    ///
    /// *Panics*: never. *Cost*: that of one for each vector of them.
    #[inline]
    pub fn hit_each_volumes<const N: usize>(
        &self,
        triangles: &Triangles<S, N>,
        cull: Cull,
    ) -> Hits<S, N> {
        let limits = Limits::new(self, cull);
        let (o, d) = (rounded(self.origin().to_array()), rounded(self.direction().to_array()));
        Hits::each(|k| {
            let [a, b, c] = triangles.at(k);
            let stored = store([rounded(a), rounded(b), rounded(c)]);
            settle(stored_normal(o, d, stored), &limits)
        })
    }
}

impl<S: Scalar> ShearedRay<S> {
    /// [`hit`](Self::hit) on each of N triangles at once: the same verdicts, the same
    /// bits.
    ///
    /// *Panics*: never. *Cost*: that of one for each vector of them.
    #[inline]
    pub fn hit_each<const N: usize>(&self, triangles: &Triangles<S, N>, cull: Cull) -> Hits<S, N> {
        let limits = self.limits(cull);
        let origin = self.turned(&self.ray().origin().to_array());
        let [a, b, c] = &triangles.points;
        let turned = [self.turned_lanes(a), self.turned_lanes(b), self.turned_lanes(c)];
        let at = |k: usize| {
            let [a, b, c] = turned;
            [[a[0][k], a[1][k], a[2][k]], [b[0][k], b[1][k], b[2][k]], [c[0][k], c[1][k], c[2][k]]]
        };
        let mut edge_on = false;
        let hits = Hits::each(|k| {
            let corners = self.corners(origin, at(k));
            let edges = edges(corners);
            edge_on |= are_zero(edges);
            self.settle(corners, edges, &limits)
        });
        if edge_on { Hits::each(|k| self.seen(origin, at(k), &limits)) } else { hits }
    }
}
