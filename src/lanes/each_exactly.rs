//! One ray against N triangles, exactly.

use super::{Hits, Triangles};
use crate::query::{Found, clear_hit};
use crate::scalar::{Holds, Predicate, Scalar};
use crate::shape::Ray;

/// The question where a ray crosses each of N triangles.
struct CrossesEach<'a, S, const N: usize> {
    ray: &'a Ray<S>,
    triangles: &'a Triangles<S, N>,
}

impl<S: Scalar, const N: usize> Predicate<S> for CrossesEach<'_, S, N> {
    type Answer = Option<Hits<S, N>>;

    fn attempt<M: Holds<S>>(&self) -> Option<Option<Hits<S, N>>> {
        Some(self.exact())
    }

    /// All at once; those of which `M` cannot be certain are asked about one by one.
    #[inline(always)]
    fn quick<M: Holds<S>>(&self) -> Option<Option<Hits<S, N>>> {
        if M::FINAL {
            return None;
        }
        let is_plain = self.ray.t_min() == Some(S::ZERO) && self.ray.t_max().is_none();
        let (mut hits, certain) =
            if is_plain { self.clear::<M, true>() } else { self.clear::<M, false>() };
        let mut all = true;
        for k in 0..N {
            all &= certain[k];
        }
        if !all {
            for k in 0..N {
                if !certain[k] {
                    hits.set(k, self.one(k));
                }
            }
        }
        Some(Some(hits))
    }

    fn exact(&self) -> Option<Hits<S, N>> {
        Some(Hits::each(|k| self.one(k)))
    }
}

impl<S: Scalar, const N: usize> CrossesEach<'_, S, N> {
    /// The hits that are clear in `M`, and of which lanes it can be certain.
    #[inline(always)]
    fn clear<M: Holds<S>, const IS_PLAIN: bool>(&self) -> (Hits<S, N>, [bool; N]) {
        let mut certain = [false; N];
        let hits = Hits::each(|k| {
            let found;
            (certain[k], found) = clear_hit::<S, M>(self.ray, IS_PLAIN, self.triangles.at(k));
            found
        });
        (hits, certain)
    }

    fn one(&self, k: usize) -> Found<S> {
        let hit = self.triangles.get(k).and_then(|triangle| self.ray.hit(&triangle));
        hit.map_or(Found::none(), Found::from_hit)
    }
}

impl<S: Scalar> Ray<S> {
    /// [`hit`](Self::hit) on each of N triangles at once: exact, the same verdicts,
    /// the same bits.
    ///
    /// *Panics*: never. *Cost*: a third of the time of one by one, where `f64` has
    /// vectors, for scalars of up to 32 bits and `f64`, and rays with the range t ≥ 0.
    /// Of others only misses of the whole line are found at once. Triangles whose edges
    /// the ray comes too near, and 64 bits, go one by one.
    #[inline]
    pub fn hit_each<const N: usize>(&self, triangles: &Triangles<S, N>) -> Hits<S, N> {
        S::measure(&CrossesEach { ray: self, triangles })
            .unwrap_or_else(|| Hits::each(|_| Found::none()))
    }
}
