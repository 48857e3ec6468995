//! One ray against N triangles, exactly.

use super::{Hits, Triangles};
use crate::arithmetic::{Embeds, Filtered};
use crate::query::{Candidate, clear_hit, clear_refined_hit, clearly_misses};
use crate::robust::{Clue, Predicate};
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

    /// All at once; those of which floats cannot be certain are asked about one by one.
    #[inline(always)]
    fn fast_path(&self) -> Result<Option<Hits<S, N>>, Clue>
    where
        Filtered<f64>: Embeds<S>,
    {
        let is_plain = self.ray.t_min() == Some(S::ZERO) && self.ray.t_max().is_none();
        let (hits, certain) = if is_plain {
            self.each(|triangle| clear_hit::<S, Filtered<f64>>(self.ray, true, triangle))
        } else {
            self.each(|triangle| clear_hit::<S, Filtered<f64>>(self.ray, false, triangle))
        };
        if is_plain && !<Filtered<f64> as Embeds<S>>::HAS_QUOTIENTS && certain != [true; N] {
            return Err(Clue::NoNumbers);
        }
        Ok(Some(self.completed(hits, certain)))
    }

    /// All at once, where the first stage has no numbers.
    fn refined(&self, clue: Clue) -> Option<Option<Hits<S, N>>>
    where
        Filtered<f64>: Embeds<S>,
    {
        if clue != Clue::NoNumbers {
            return None;
        }
        let (hits, certain) = self.each(|triangle| clear_refined_hit(self.ray, triangle));
        Some(Some(self.completed(hits, certain)))
    }

    fn exact(&self) -> Option<Hits<S, N>> {
        Some(Hits::each(|k| self.one(k)))
    }
}

impl<S: Scalar, const N: usize> CrossesEach<'_, S, N> {
    /// Where all but a few are clear misses by the scalar's first float: those few one by one.
    /// Of 64 bits, whose numbers are dear: those of shorter ones cost less than to look twice.
    #[inline(always)]
    fn few(&self) -> Option<Hits<S, N>> {
        if !S::IN_QUADS || size_of::<S>() < size_of::<f64>() {
            return None;
        }
        let mut misses = [false; N];
        for k in 0..N {
            misses[k] = clearly_misses(self.ray, self.triangles.at(k));
        }
        let mut left = 0;
        for k in 0..N {
            left += usize::from(!misses[k]);
        }
        if 4 * left > N {
            return None;
        }
        let mut hits = Hits::each(|_| Candidate::none());
        for k in 0..N {
            if !misses[k] {
                hits.set(k, self.one(k));
            }
        }
        Some(hits)
    }

    /// What is found on each, and whether that is certain.
    #[inline(always)]
    fn each(&self, find: impl Fn([[S; 3]; 3]) -> (bool, Candidate<S>)) -> (Hits<S, N>, [bool; N]) {
        let mut certain = [false; N];
        let hits = Hits::each(|k| {
            let found;
            (certain[k], found) = find(self.triangles.at(k));
            found
        });
        (hits, certain)
    }

    /// Those that are not certain one by one.
    #[inline(always)]
    fn completed(&self, mut hits: Hits<S, N>, certain: [bool; N]) -> Hits<S, N> {
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
        hits
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
    /// *Panics*: never. *Cost*: less than one by one where `f64` has vectors, for scalars of up to
    /// 32 bits and `f64`, and rays with the range t ≥ 0.
    /// Of others only misses of the whole line are found at once. Triangles whose edges
    /// the ray comes too near, and hits of 64 bits where they are few, go one by one.
    #[inline]
    #[must_use]
    pub fn hit(&self, ray: &Ray<S>) -> Hits<S, N> {
        let question = CrossesEach { ray, triangles: self };
        question
            .few()
            .or_else(|| S::evaluate_numeric(&question))
            .unwrap_or_else(|| Hits::each(|_| Candidate::none()))
    }
}
