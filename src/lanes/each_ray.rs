//! N rays against one triangle.

use super::{Hits, Rays};
use crate::query::{
    Cull, Facing, NormalTriangle, Stored, moller_trumbore, rounded, settle, store, stored_normal,
};
use crate::scalar::Scalar;
use crate::shape::Triangle;

impl<S: Scalar, const N: usize> Rays<S, N> {
    /// [`Ray::hit_moller_trumbore`] for N rays at once: the same verdicts, the same
    /// bits.
    ///
    /// *Panics*: never. *Cost*: that of one for each vector of them.
    ///
    /// [`Ray::hit_moller_trumbore`]: crate::Ray::hit_moller_trumbore
    #[inline]
    pub fn hit_moller_trumbore(&self, triangle: &Triangle<S>, cull: Cull) -> Hits<S, N> {
        let keeps = (cull.keeps(Facing::Front), cull.keeps(Facing::Back));
        let [a, b, c] = triangle.points();
        let triangle = [rounded(a), rounded(b), rounded(c)];
        Hits::each(|k| {
            let (o, d) = self.at(k);
            settle(moller_trumbore(o, d, triangle), &self.limits(k, keeps))
        })
    }

    /// [`Ray::hit_stored_normal`] for N rays at once: the same verdicts, the same
    /// bits.
    ///
    /// *Panics*: never. *Cost*: that of one for each vector of them.
    ///
    /// [`Ray::hit_stored_normal`]: crate::Ray::hit_stored_normal
    #[inline]
    pub fn hit_stored_normal(&self, triangle: &NormalTriangle<S>, cull: Cull) -> Hits<S, N> {
        self.hit_stored(triangle.rounded(), cull)
    }

    /// [`Ray::hit_volumes`] for N rays at once: the same verdicts, the same
    /// bits.
    ///
    /// *Panics*: never. *Cost*: that of one for each vector of them.
    ///
    /// [`Ray::hit_volumes`]: crate::Ray::hit_volumes
    #[inline]
    pub fn hit_volumes(&self, triangle: &Triangle<S>, cull: Cull) -> Hits<S, N> {
        let [a, b, c] = triangle.points();
        self.hit_stored(store([rounded(a), rounded(b), rounded(c)]), cull)
    }

    #[inline(always)]
    fn hit_stored(&self, triangle: Stored<S>, cull: Cull) -> Hits<S, N> {
        let keeps = (cull.keeps(Facing::Front), cull.keeps(Facing::Back));
        Hits::each(|k| {
            let (o, d) = self.at(k);
            settle(stored_normal(o, d, triangle), &self.limits(k, keeps))
        })
    }
}
