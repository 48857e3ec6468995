use super::settle::{Limits, settle};
use super::stored_normal::{store, stored_normal};
use super::vector::rounded;
use crate::query::{Cull, Hit};
use crate::scalar::Scalar;
use crate::shape::{Ray, Triangle};

impl<S: Scalar> Ray<S> {
    /// Where the ray crosses the triangle, by signed volumes in the scalar's own
    /// arithmetic: now and then wrong.
    ///
    /// Choose it for many rays on one triangle, by [`Rays`](crate::Rays), which then
    /// share the normal; one by one it takes the time of
    /// [`hit_moller_trumbore`](Self::hit_moller_trumbore), where the table is. It is
    /// [`hit_stored_normal`](Self::hit_stored_normal) with the normal made on the
    /// way, to the last bit.
    ///
    /// *Geometry*, *Contact*, *Numerics*: as there.
    ///
    /// *Panics*: never. *Cost*: 24 multiplications, 3 divisions, no early exit.
    ///
    /// *Source*: A. Kensler, P. Shirley, "Optimizing Ray-Triangle Intersection via
    /// Automated Search", *IEEE Symposium on Interactive Ray Tracing*, 2006. Ours
    /// divides last.
    #[inline]
    pub fn hit_volumes(&self, triangle: &Triangle<S>, cull: Cull) -> Option<Hit<S>> {
        let [a, b, c] = triangle.points();
        let fractions = stored_normal(
            rounded(self.origin().to_array()),
            rounded(self.direction().to_array()),
            store([rounded(a), rounded(b), rounded(c)]),
        );
        settle(fractions, &Limits::new(self, cull)).into_hit()
    }
}
