//! N rays against one triangle.

use super::{Hits, Rays};
use crate::published::moller_trumbore::moller_trumbore;
use crate::published::stored_normal::{NormalTriangle, Stored, store, stored_normal};
use crate::published::{resolve, rounded};
use crate::query::{Cull, Facing};
use crate::scalar::Scalar;
use crate::shape::Triangle;

impl<S: Scalar, const N: usize> Rays<S, N> {
    /// [`moller_trumbore::hit`](crate::published::moller_trumbore::hit) for N rays at once: the
    /// same verdicts, the same bits.
    ///
    /// *Panics*: never. *Cost*: for each vector of rays, as for one ray.
    #[inline]
    #[must_use]
    pub fn hit_moller_trumbore(&self, triangle: &Triangle<S>, cull: Cull) -> Hits<S, N> {
        let keeps = (cull.keeps(Facing::Front), cull.keeps(Facing::Back));
        let [a, b, c] = triangle.points();
        let triangle = [rounded(a), rounded(b), rounded(c)];
        Hits::each(|k| {
            let (o, d) = self.at(k);
            resolve(moller_trumbore(o, d, triangle), &self.limits(k, keeps))
        })
    }

    /// [`stored_normal::hit`](crate::published::stored_normal::hit) for N rays at once: the
    /// same verdicts, the same bits.
    ///
    /// *Panics*: never. *Cost*: for each vector of rays, as for one ray.
    #[inline]
    #[must_use]
    pub fn hit_stored_normal(&self, triangle: &NormalTriangle<S>, cull: Cull) -> Hits<S, N> {
        self.hit_stored(triangle.rounded(), cull)
    }

    /// [`volumes::hit`](crate::published::volumes::hit) for N rays at once: the same
    /// verdicts, the same bits.
    ///
    /// *Panics*: never. *Cost*: for each vector of rays, as for one ray.
    #[inline]
    #[must_use]
    pub fn hit_volumes(&self, triangle: &Triangle<S>, cull: Cull) -> Hits<S, N> {
        let [a, b, c] = triangle.points();
        self.hit_stored(store([rounded(a), rounded(b), rounded(c)]), cull)
    }

    #[inline(always)]
    fn hit_stored(&self, triangle: Stored<S>, cull: Cull) -> Hits<S, N> {
        let keeps = (cull.keeps(Facing::Front), cull.keeps(Facing::Back));
        Hits::each(|k| {
            let (o, d) = self.at(k);
            resolve(stored_normal(o, d, triangle), &self.limits(k, keeps))
        })
    }
}
