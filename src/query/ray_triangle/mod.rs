//! Ray against triangle, exactly.
//!
//! T. Möller, B. Trumbore, "Fast, Minimum Storage Ray/Triangle Intersection", *Journal of Graphics
//! Tools* 2(1), 1997; T. Akenine-Möller, E. Haines, N. Hoffman, *Real-Time Rendering*, 16.8. The
//! volumes are theirs. Here signs are decided exactly, and without a division.
//!
//! The stages in order; a scalar's cascade leaves out the stages that it does not need:
//!
//! | stage | runs in | serves |
//! | --- | --- | --- |
//! | `prepared` | four `f32` | prepared rays and triangles: clear hits and misses |
//! | `four` | four `f32` | trees, `lanes`: clear misses, of four triangles at once |
//! | `rows` | four floats | hosts: hits and misses away from contact; `lanes` |
//! | `words` | words, split sums | fixed point on 32-bit cores: all |
//! | `kernel` | a float with an error bound | other ranges of t; floats on 32-bit cores |
//! | `multiples` | 64- and 128-bit integers | `f32` on 32-bit cores: hits |
//! | `refined` | `f64` in two parts | contacts |
//! | `residual` | `f64` in two parts | t, u and v of hits beyond the precision of `f64` |
//! | `kernel` | 60-bit integers, window, full width | all else |
//! | `crosses::in_sums` | a long accumulator | on 32-bit cores, in place of window and full width |
//!
//! `crosses` has the rules for counting a crossing, which all stages after `rows` share, and
//! `question` the two predicates.

mod crosses;
mod error_bound;
mod four;
mod hit;
mod kernel;
mod multiples;
mod order;
mod prepared;
mod question;
mod refined;
mod residual;
mod rows;
mod sums;
mod words;

pub(crate) use four::clear_misses;
pub(crate) use hit::Candidate;
pub use hit::{Cull, Facing, Feature, Hit, HitRules};
pub(crate) use order::compare_quotients;
pub use prepared::{HitRay, HitTriangle};
pub(crate) use rows::{clear_hit, clear_refined_hit, line_clearly_misses};

use self::crosses::Crosses;
use self::question::Hits;
#[cfg(feature = "fixed")]
use self::words::rounded;
#[cfg(feature = "fixed")]
use crate::arithmetic::InRaw;
use crate::scalar::Scalar;
#[cfg(feature = "fixed")]
use crate::shape::Near;
use crate::shape::{Ray, Triangle};

impl<S: Scalar> Ray<S> {
    /// Where the ray hits a triangle, if it does.
    ///
    /// *Geometry*: both are in one frame and unit. A ray that is parallel to the plane of the
    /// triangle, or lies in it, misses. A triangle that is a segment or a point is never hit. Both
    /// sides of the triangle count.
    ///
    /// *Contact*: edges, vertices, and the ends of the ray's range count. [`Hit::feature`] says
    /// which part was hit.
    ///
    /// *Numerics*: the verdict, the side and the feature are exact for every valid input, in every
    /// scalar, so a closed mesh has no leak. t, u and v are rounded. In fixed point they are the
    /// nearest numbers of the type, ties to even, clamped to its range. In floats they are within 2
    /// ulp, and a t beyond the greatest float is infinite, and still a hit. Every machine gives the
    /// same bits. [`compare_hits`](Self::compare_hits) orders hits exactly.
    ///
    /// *Range*: all finite floats, all fixed-point values. As with [`Triangle::overlaps`], inputs
    /// that the fast stage leaves in doubt take wider numbers, and last exact integers, up to a
    /// thousand times slower. On 32-bit cores fixed point of up to 32 bits needs none: its
    /// time is bounded (`docs/worst-case.md`), and for `near` shapes the bound is lower.
    ///
    /// *Panics*: never.
    ///
    /// *Cost*: 24 multiplications and 3 divisions. On a 64-bit machine a hit costs the same as a
    /// miss in scalars of up to 32 bits. In `f64` a hit takes 42 more multiplications, because
    /// products of `f64` are not accurate enough for its numbers; farther away than some 2¹³ lengths of
    /// the edges it takes exact integers. On 32-bit cores a hit costs more than a miss: on a
    /// Cortex-M4F 8 times as much in `f32`, whose t, u and v need integers (`docs/target.csv`), and 50
    /// times as much if a coordinate is no multiple of 2⁻²⁸ of the greatest. A ray exactly through an
    /// edge takes integers, unless the coordinates are short. [`is_hit`](Self::is_hit) saves the
    /// divisions, and [`lanes::Triangles`](crate::lanes::Triangles) tests several triangles at once.
    ///
    /// *Source*: Möller and Trumbore 1997; the sign test, the error bound and the exact stages are
    /// ours.
    ///
    /// ```
    /// use septum::{Facing, Feature, Ray, Triangle};
    ///
    /// let ray = Ray::new([0.5, 0.5, 3.0], [0.0, 0.0, -2.0])?;
    /// let t = Triangle::new([0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0])?;
    /// let hit = ray.hit(&t).unwrap(); // in the middle of the long edge
    /// assert_eq!((hit.t, hit.u, hit.v), (1.5, 0.5, 0.5));
    /// assert_eq!((hit.feature, hit.facing), (Feature::Edge(1), Facing::Front));
    /// # Ok::<(), septum::ShapeError>(())
    /// ```
    #[inline]
    #[doc(alias = "raycast")]
    pub fn hit(&self, triangle: &Triangle<S>) -> Option<Hit<S>> {
        self.hit_with(triangle, HitRules::new())
    }

    /// [`hit`](Self::hit), counting each crossing of a closed mesh once.
    ///
    /// A ray through an edge or a vertex hits every triangle there. Here it hits one of them: the
    /// triangle that it would hit after moving its origin by an infinitesimal amount, the same for
    /// every triangle. So hits on a consistently oriented closed mesh alternate between outside and
    /// inside, and a point is inside exactly if a ray from it hits an odd number of triangles
    /// (even-odd rule).
    ///
    /// *Contact*: a ray that touches the mesh without entering it hits two triangles or none. A ray
    /// that starts on a triangle hits it or not, depending on the moved origin.
    ///
    /// *Numerics*, *Range*, *Panics*: as [`hit`](Self::hit). *Cost*: as `hit`, and a few
    /// comparisons if the ray goes exactly through an edge.
    ///
    /// *Source*: symbolic perturbation: H. Edelsbrunner, E. P. Mücke, "Simulation of Simplicity",
    /// *ACM Transactions on Graphics* 9(1), 1990. The origin moves by (ε, ε², ε³).
    ///
    /// ```
    /// use septum::{Ray, Triangle};
    ///
    /// // Two triangles that share an edge, and a ray through it.
    /// let ray = Ray::new([0.5, 0.5, 1.0], [0.0, 0.0, -1.0])?;
    /// let (a, b, c) = ([1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [1.0, 1.0, 0.0]);
    /// let square = [Triangle::new([0.0; 3], a, b)?, Triangle::new(c, b, a)?];
    /// assert_eq!(square.iter().filter(|t| ray.hit(t).is_some()).count(), 2);
    /// assert_eq!(square.iter().filter(|t| ray.hit_once(t).is_some()).count(), 1);
    /// # Ok::<(), septum::ShapeError>(())
    /// ```
    #[inline]
    #[must_use]
    pub fn hit_once(&self, triangle: &Triangle<S>) -> Option<Hit<S>> {
        self.hit_with(triangle, HitRules::new().once())
    }

    /// [`hit`](Self::hit) under other rules, such as culling.
    #[inline]
    #[must_use]
    pub fn hit_with(&self, triangle: &Triangle<S>, rules: HitRules) -> Option<Hit<S>> {
        let question = Crosses { ray: self, triangle, rules };
        // Hits are expensive here, so a fast test for a miss comes first.
        if S::FLOAT.is_none()
            && size_of::<S>() == size_of::<i64>()
            && question.counts_in_first() == Some(false)
        {
            return None;
        }
        S::evaluate_numeric(&question)
    }

    /// Does the ray hit a triangle? As [`hit`](Self::hit), without t, u and v.
    ///
    /// *Numerics*: exact. *Panics*: never.
    ///
    /// *Cost*: 24 multiplications, no division. On a 64-bit machine it takes half the time of
    /// [`hit`](Self::hit) in `f32`. On a core with an FPU for `f32` only, a hit costs at most a
    /// sixth of its cost by `hit`. Use it for projections and visibility, and before `hit` if hits
    /// are rare.
    #[inline]
    #[doc(alias = "raycast")]
    #[must_use]
    pub fn is_hit(&self, triangle: &Triangle<S>) -> bool {
        self.is_hit_with(triangle, HitRules::new())
    }

    /// [`is_hit`](Self::is_hit) under other rules, such as culling.
    #[inline]
    #[must_use]
    pub fn is_hit_with(&self, triangle: &Triangle<S>, rules: HitRules) -> bool {
        let question = Crosses { ray: self, triangle, rules };
        match question.counts_in_first() {
            Some(counts) => counts,
            None => S::evaluate_numeric(&Hits(question)),
        }
    }
}

/// Rays near the origin, in 32-bit words.
#[cfg(feature = "fixed")]
impl<S: Scalar + InRaw<Raw = i32>> Near<Ray<S>> {
    /// [`Ray::hit`], in 32-bit words alone.
    #[inline]
    #[must_use]
    pub fn hit(&self, triangle: &Near<Triangle<S>>) -> Option<Hit<S>> {
        self.hit_with(triangle, HitRules::new())
    }

    /// [`Ray::hit_once`], in 32-bit words alone.
    #[inline]
    #[must_use]
    pub fn hit_once(&self, triangle: &Near<Triangle<S>>) -> Option<Hit<S>> {
        self.hit_with(triangle, HitRules::new().once())
    }

    /// [`Ray::hit_with`], in 32-bit words alone.
    #[inline]
    #[must_use]
    pub fn hit_with(&self, triangle: &Near<Triangle<S>>, rules: HitRules) -> Option<Hit<S>> {
        let question = Crosses { ray: self.get(), triangle: triangle.get(), rules };
        question.in_any_words::<i32>().map(|counted| rounded(&counted))
    }

    /// [`Ray::is_hit`], in 32-bit words alone.
    #[inline]
    #[must_use]
    pub fn is_hit(&self, triangle: &Near<Triangle<S>>) -> bool {
        self.is_hit_with(triangle, HitRules::new())
    }

    /// [`Ray::is_hit_with`], in 32-bit words alone.
    #[inline]
    #[must_use]
    pub fn is_hit_with(&self, triangle: &Near<Triangle<S>>, rules: HitRules) -> bool {
        let question = Crosses { ray: self.get(), triangle: triangle.get(), rules };
        question.in_any_words::<i32>().is_some()
    }
}
