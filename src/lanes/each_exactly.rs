//! One ray against N triangles, exactly.

use super::{Hits, Triangles};
use crate::arithmetic::Embeds;
use crate::query::{Candidate, clear_hit};
use crate::robust::Predicate;
use crate::scalar::Scalar;
use crate::shape::Ray;

/// The question where a ray crosses each of N triangles.
struct CrossesEach<'a, S, const N: usize> {
    ray: &'a Ray<S>,
    triangles: &'a Triangles<S, N>,
}

impl<S: Scalar, const N: usize> Predicate<S> for CrossesEach<'_, S, N> {
    type Answer = Option<Hits<S, N>>;

    fn filter<M: Embeds<S>>(&self) -> Option<Option<Hits<S, N>>> {
        Some(self.exact())
    }

    /// All at once; those of which `M` cannot be certain are asked about one by one.
    #[inline(always)]
    fn fast_path<M: Embeds<S>>(&self) -> Option<Option<Hits<S, N>>> {
        if M::CERTAIN {
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
    fn clear<M: Embeds<S>, const IS_PLAIN: bool>(&self) -> (Hits<S, N>, [bool; N]) {
        let mut certain = [false; N];
        let hits = Hits::each(|k| {
            let found;
            (certain[k], found) = clear_hit::<S, M>(self.ray, IS_PLAIN, self.triangles.at(k));
            found
        });
        (hits, certain)
    }

    fn one(&self, k: usize) -> Candidate<S> {
        let hit = self.triangles.get(k).and_then(|triangle| self.ray.hit(&triangle));
        hit.map_or(Candidate::none(), Candidate::from_hit)
    }
}

impl<S: Scalar, const N: usize> Triangles<S, N> {
    /// [`Ray::hit`] on each of N triangles at once: exact, the same verdicts,
    /// the same bits.
    ///
    /// *Panics*: never. *Cost*: about a third of the time of one by one, where `f64` has
    /// vectors, for scalars of up to 32 bits and `f64`, and rays with the range t ≥ 0.
    /// Of others only misses of the whole line are found at once. Triangles whose edges
    /// the ray comes too near, and 64 bits, go one by one.
    #[inline]
    #[must_use]
    pub fn hit(&self, ray: &Ray<S>) -> Hits<S, N> {
        S::evaluate_numeric(&CrossesEach { ray, triangles: self })
            .unwrap_or_else(|| Hits::each(|_| Candidate::none()))
    }
}
