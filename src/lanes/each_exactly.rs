//! One ray or box against N triangles, and one triangle against N boxes, exactly.

use super::triangle_axes::{TriangleAxes, is_for_first};
use super::triangles::lane;
use super::{Aabbs, Hits, Triangles};
use crate::arithmetic::{Embeds, Filtered, Float, InFloat};
use crate::query::{Candidate, clear_hit, clear_misses, clear_refined_hit, line_clearly_misses};
use crate::robust::{Clue, Numeric, Predicate};
use crate::scalar::Scalar;
use crate::shape::{Aabb, Ray, Triangle};

/// The query for the hit of one ray on each of N triangles.
struct CrossesEach<'a, S, const N: usize> {
    ray: &'a Ray<S>,
    triangles: &'a Triangles<S, N>,
}

impl<S: Scalar, const N: usize> Predicate<S> for CrossesEach<'_, S, N> {
    type Answer = Option<Hits<S, N>>;

    fn filter<M: Embeds<S>>(&self) -> Option<Option<Hits<S, N>>> {
        Some(self.exact())
    }

    fn exact(&self) -> Option<Hits<S, N>> {
        Some(Hits::each(|k| self.one(k)))
    }
}

impl<S: Scalar, const N: usize> Numeric<S> for CrossesEach<'_, S, N> {
    /// All triangles at once; triangles that floats leave in doubt follow one by one.
    #[inline(always)]
    fn fast_path(&self) -> Result<Option<Hits<S, N>>, Clue>
    where
        Filtered<f64>: Embeds<S>,
    {
        let is_plain = self.ray.t_min() == Some(S::ZERO) && self.ray.t_max().is_none();
        let (mut hits, certain) = if is_plain {
            self.each(|triangle| clear_hit(self.ray, triangle))
        } else {
            let misses = |triangle| line_clearly_misses(self.ray, triangle);
            self.each(|triangle| (misses(triangle), Candidate::none()))
        };
        if is_plain && !<Filtered<f64> as Embeds<S>>::HAS_QUOTIENTS && certain != [true; N] {
            return Err(Clue::NoNumbers);
        }
        settle(&certain, |k| hits.set(k, self.one(k)));
        Ok(Some(hits))
    }

    /// All triangles at once, for scalars whose first stage gives no numbers.
    fn refined(&self, clue: Clue) -> Option<Option<Hits<S, N>>>
    where
        Filtered<f64>: Embeds<S>,
    {
        if clue != Clue::NoNumbers {
            return None;
        }
        let (mut hits, certain) = self.each(|triangle| clear_refined_hit(self.ray, triangle));
        settle(&certain, |k| hits.set(k, self.one(k)));
        Some(Some(hits))
    }
}

impl<S: Scalar, const N: usize> CrossesEach<'_, S, N> {
    /// Rejects clear misses in `f32`, four triangles at a time, and takes the remaining triangles one
    /// by one, if these are few. Only for scalars of 64 bits, whose hits are expensive; with narrower
    /// scalars a second pass costs more than it saves.
    #[inline(always)]
    fn few(&self) -> Option<Hits<S, N>> {
        if !S::IN_QUADS || size_of::<S>() < size_of::<f64>() {
            return None;
        }
        let mut misses = [false; N];
        for from in (0..N).step_by(4) {
            let triangle = |k: usize| self.triangles.triangle((from + k).min(N - 1));
            let triangles = [triangle(0), triangle(1), triangle(2), triangle(3)];
            let missed = clear_misses(self.ray, triangles);
            for k in from..N.min(from + 4) {
                misses[k] = missed >> (k - from) & 1 == 1;
            }
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

    /// The result on each triangle, and whether it is certain.
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

    fn one(&self, k: usize) -> Candidate<S> {
        let hit = self.triangles.get(k).and_then(|triangle| self.ray.hit(&triangle));
        hit.map_or(Candidate::none(), Candidate::from_hit)
    }
}

impl<S: Scalar, const N: usize> Triangles<S, N> {
    /// [`Ray::hit`] on each of N triangles at once: exact, with the same verdicts and the same
    /// bits.
    ///
    /// *Panics*: never. *Cost*: less than one by one if the machine has vectors of `f64`, for
    /// scalars of up to 32 bits and for `f64`, and for rays with the range t ≥ 0. For other rays
    /// only misses of the whole line are found at once. Triangles that the ray hits too near an
    /// edge go one by one, and so do a few hits in 64 bits.
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

/// Tests all lanes at once in floats; `apart` returns the verdict and whether it is certain.
/// `overlaps` decides uncertain lanes one by one.
#[inline(always)]
pub(super) fn each<S: Scalar, const N: usize>(
    apart: impl Fn(usize) -> (bool, bool),
    overlaps: impl Fn(usize) -> bool,
) -> [bool; N] {
    if !S::IN_QUADS {
        return core::array::from_fn(overlaps);
    }
    let (mut found, mut certain) = ([false; N], [false; N]);
    for k in 0..N {
        let (is_apart, is_certain) = apart(k);
        found[k] = !is_apart;
        certain[k] = is_certain;
    }
    settle(&certain, |k| found[k] = overlaps(k));
    found
}

/// Decides the uncertain lanes one by one.
#[inline(always)]
fn settle<const N: usize>(certain: &[bool; N], mut decide: impl FnMut(usize)) {
    let mut all = true;
    for is_certain in certain {
        all &= is_certain;
    }
    if !all {
        for k in 0..N {
            if !certain[k] {
                decide(k);
            }
        }
    }
}

impl<S: Scalar, const N: usize> Aabbs<S, N> {
    /// [`Triangle::overlaps`](crate::Overlaps::overlaps) with each of N boxes at once.
    ///
    /// *Contact*: touching is overlap.
    ///
    /// *Numerics*: exact for every valid input, in every scalar, with the same verdicts as for
    /// single boxes.
    ///
    /// *Range*: all of the scalar. Floats are tested all at once. With vectors and the feature
    /// `simd`, so is fixed point: of 32 bits in `f64` if the triangle reaches 2²⁴ units in the last
    /// place, and of 64 bits below 2⁵³. Other numbers, and boxes that the triangle touches, go one
    /// by one.
    ///
    /// *Panics*: never. *Cost*: 52 multiplications for a vector of boxes, also if a face separates.
    ///
    /// ```
    /// use septum::lanes::Aabbs;
    /// use septum::{Aabb, Triangle};
    ///
    /// let cell = |x: f32| Aabb::from_min_max([x, 0.0, 0.0], [x + 1.0, 1.0, 1.0]);
    /// let cells = Aabbs::new(&[cell(0.0)?, cell(1.0)?, cell(2.0)?, cell(3.0)?]).unwrap();
    /// let triangle = Triangle::new([0.5, 0.5, 0.2], [2.0, 0.5, 0.2], [0.5, 3.5, 0.2])?;
    /// assert_eq!(cells.overlaps(&triangle), [true, true, true, false]);
    /// # Ok::<(), septum::ShapeError>(())
    /// ```
    #[inline]
    #[must_use]
    pub fn overlaps(&self, triangle: &Triangle<S>) -> [bool; N] {
        if is_for_first(&triangle.points()) {
            self.overlaps_in::<S::SeptumFirst>(triangle)
        } else {
            self.overlaps_in::<S::SeptumSecond>(triangle)
        }
    }

    #[inline(always)]
    fn overlaps_in<F: Float>(&self, triangle: &Triangle<S>) -> [bool; N]
    where
        S: InFloat<F>,
    {
        let axes = TriangleAxes::<F>::new(triangle.points());
        each::<S, N>(
            |k| axes.apart_by_corners(lane(&self.min, k), lane(&self.max, k)),
            |k| triangle.overlaps(&self.at(k)),
        )
    }
}

impl<S: Scalar, const N: usize> Triangles<S, N> {
    /// [`Triangle::overlaps`](crate::Overlaps::overlaps) of each of N triangles with a box, at
    /// once.
    ///
    /// *Contact*, *Numerics*, *Range*, *Panics*: as [`Aabbs::overlaps`].
    ///
    /// *Cost*: for each vector of triangles, as one
    /// [`Triangle::overlaps`](crate::Overlaps::overlaps) without early exits.
    #[inline]
    #[must_use]
    pub fn overlaps(&self, aabb: &Aabb<S>) -> [bool; N] {
        let (p, q, _) = aabb.numbers();
        if is_for_first(&[p, q]) && (N == 0 || is_for_first(&self.at(0))) {
            self.overlaps_in::<S::SeptumFirst>(aabb)
        } else {
            self.overlaps_in::<S::SeptumSecond>(aabb)
        }
    }

    #[inline(always)]
    fn overlaps_in<F: Float>(&self, aabb: &Aabb<S>) -> [bool; N]
    where
        S: InFloat<F>,
    {
        let alone = |k: usize| self.triangle(k).overlaps(aabb);
        let axes = |k: usize| TriangleAxes::<F>::new(self.at(k));
        let (p, q, is_by_center) = aabb.numbers();
        if is_by_center {
            each::<S, N>(|k| axes(k).apart_by_center(p, q), alone)
        } else {
            each::<S, N>(|k| axes(k).apart_by_corners(p, q), alone)
        }
    }
}
