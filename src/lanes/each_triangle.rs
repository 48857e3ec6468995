//! One ray against N triangles.

use super::{Hits, NormalTriangles, Triangles};
use crate::query::{
    Cull, Found, Limits, ShearedRay, are_zero, edges, moller_trumbore, rounded, settle, store,
    stored_normal,
};
use crate::scalar::Scalar;
use crate::shape::Ray;

impl<S: Scalar> Ray<S> {
    /// [`hit`](Self::hit) on each of N triangles: exact, one by one.
    ///
    /// *Panics*: never. *Cost*: that of [`hit`](Self::hit) for each.
    #[inline]
    pub fn hit_each<const N: usize>(&self, triangles: &Triangles<S, N>) -> Hits<S, N> {
        let mut hits = Hits::none();
        for k in 0..N {
            if let Some(hit) = triangles.get(k).and_then(|triangle| self.hit(&triangle)) {
                hits.put(k, Found::from_hit(hit));
            }
        }
        hits
    }

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
        let (limits, mut hits) = (Limits::new(self, cull), Hits::none());
        let (o, d) = (rounded(self.origin().to_array()), rounded(self.direction().to_array()));
        for k in 0..N {
            let [a, b, c] = triangles.at(k);
            let triangle = [rounded(a), rounded(b), rounded(c)];
            hits.put(k, settle(moller_trumbore(o, d, triangle), &limits));
        }
        hits
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
        let (limits, mut hits) = (Limits::new(self, cull), Hits::none());
        let (o, d) = (rounded(self.origin().to_array()), rounded(self.direction().to_array()));
        for k in 0..N {
            hits.put(k, settle(stored_normal(o, d, triangles.at(k)), &limits));
        }
        hits
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
        let (limits, mut hits) = (Limits::new(self, cull), Hits::none());
        let (o, d) = (rounded(self.origin().to_array()), rounded(self.direction().to_array()));
        for k in 0..N {
            let [a, b, c] = triangles.at(k);
            let stored = store([rounded(a), rounded(b), rounded(c)]);
            hits.put(k, settle(stored_normal(o, d, stored), &limits));
        }
        hits
    }
}

impl<S: Scalar> ShearedRay<S> {
    /// [`hit`](Self::hit) on each of N triangles at once: the same verdicts, the same
    /// bits.
    ///
    /// *Panics*: never. *Cost*: that of one for each vector of them.
    #[inline]
    pub fn hit_each<const N: usize>(&self, triangles: &Triangles<S, N>, cull: Cull) -> Hits<S, N> {
        let (limits, mut hits) = (self.limits(cull), Hits::none());
        let origin = self.turned(&self.ray().origin().to_array());
        let [a, b, c] = &triangles.points;
        let turned = [self.turned_lanes(a), self.turned_lanes(b), self.turned_lanes(c)];
        let at = |k: usize| {
            let [a, b, c] = turned;
            [[a[0][k], a[1][k], a[2][k]], [b[0][k], b[1][k], b[2][k]], [c[0][k], c[1][k], c[2][k]]]
        };
        let mut edge_on = false;
        for k in 0..N {
            let corners = self.corners(origin, at(k));
            let edges = edges(corners);
            edge_on |= are_zero(edges);
            hits.put(k, self.settle(corners, edges, &limits));
        }
        if edge_on {
            for k in 0..N {
                hits.put(k, self.seen(origin, at(k), &limits));
            }
        }
        hits
    }
}
