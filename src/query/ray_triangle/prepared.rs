//! Ray against triangle, both prepared: four volumes in `f32` decide at once, unless one of them is
//! nearly zero.

mod volumes;

use self::volumes::{OfRay, OfTriangle, Verdict};
use super::{Facing, Hit, HitRules};
use crate::robust::{Stage, note};
use crate::scalar::Scalar;
use crate::shape::{Ray, Triangle};

/// A triangle prepared for many prepared rays: see [`HitRay`].
///
/// *Size*: the triangle and 80 bytes.
#[derive(Clone, Copy, Debug)]
pub struct HitTriangle<S: Scalar> {
    triangle: Triangle<S>,
    volumes: OfTriangle,
}

/// A ray prepared for many prepared triangles: exact, and much faster if hits are rare.
///
/// Use both if triangles meet many rays and most pairs miss, as in the leaves of a tree. If half of
/// the pairs hit, [`Ray::hit`] is faster than `HitRay::hit`, but [`Ray::is_hit`] is not faster than
/// `HitRay::is_hit`. The answers equal [`Ray::hit`] and [`Ray::is_hit`].
///
/// *Numerics*: exact. The first look uses `f32` with an error bound, in every scalar. If it is in
/// doubt, and for t, u and v, the unprepared query answers.
///
/// *Range*: all of the scalar. Coordinates, edges and the direction should be between 2⁻³² and 2⁴⁰;
/// with others the unprepared query answers every time, and preparing gains nothing. The same holds
/// for fixed point on cores with 32-bit registers, where integers are faster than floats.
///
/// ```
/// use septum::prepared::{HitRay, HitTriangle};
/// use septum::{Ray, Triangle};
///
/// let at = |z: f32| Triangle::new([0.0, 0.0, z], [1.0, 0.0, z], [0.0, 1.0, z]);
/// let stack = [at(1.0)?, at(2.0)?, at(3.0)?].map(|t| HitTriangle::new(&t));
/// let ray = HitRay::new(&Ray::new([0.25, 0.25, 1.5], [0.0, 0.0, 1.0])?);
/// assert_eq!(stack.each_ref().map(|t| ray.is_hit(t)), [false, true, true]);
/// assert_eq!(ray.hit(&stack[2]).unwrap().t, 1.5);
/// # Ok::<(), septum::ShapeError>(())
/// ```
#[derive(Clone, Copy, Debug)]
pub struct HitRay<S: Scalar> {
    ray: Ray<S>,
    volumes: OfRay,
    /// A bit for each [`Verdict`] that leaves a doubt.
    doubts: u8,
}

impl<S: Scalar> HitTriangle<S> {
    /// Prepares a triangle for many rays.
    ///
    /// *Panics*: never. *Cost*: 6 multiplications of `f64`.
    #[must_use]
    pub fn new(triangle: &Triangle<S>) -> Self {
        // A choice known at compile time, so that machines without floats link none.
        let volumes =
            if S::IS_FAST { OfTriangle::new(triangle.points()) } else { OfTriangle::UNKNOWN };
        Self { triangle: *triangle, volumes }
    }

    /// The triangle.
    #[inline]
    #[must_use]
    pub const fn triangle(&self) -> &Triangle<S> {
        &self.triangle
    }
}

impl<S: Scalar> HitRay<S> {
    /// Prepares a ray for many triangles.
    ///
    /// *Panics*: never. *Cost*: comparisons; no division.
    #[must_use]
    pub fn new(ray: &Ray<S>) -> Self {
        let volumes = if S::IS_FAST {
            let is_ahead = ray.t_min().is_some_and(|t| t >= S::ZERO);
            OfRay::new(ray.origin().to_array(), ray.direction().to_array(), is_ahead)
        } else {
            OfRay::UNKNOWN
        };
        let bit = |verdict: Verdict| 1 << verdict as u8;
        let is_whole = ray.t_min() == Some(S::ZERO) && ray.t_max().is_none();
        let hits = if is_whole { 0 } else { bit(Verdict::Front) | bit(Verdict::Back) };
        Self { ray: *ray, volumes, doubts: bit(Verdict::Doubt) | hits }
    }

    /// The ray.
    #[inline]
    #[must_use]
    pub const fn ray(&self) -> &Ray<S> {
        &self.ray
    }

    /// Where the ray hits a triangle, if it does: [`Ray::hit`].
    ///
    /// *Contact*, *Numerics*: as [`Ray::hit`], with the same bits. *Panics*: never.
    ///
    /// *Cost*: 6 multiplications of four numbers at once; then, unless the ray certainly misses,
    /// [`Ray::hit`].
    #[inline]
    #[must_use]
    pub fn hit(&self, triangle: &HitTriangle<S>) -> Option<Hit<S>> {
        self.hit_with(triangle, HitRules::new())
    }

    /// [`hit`](Self::hit) under other rules, such as culling.
    #[inline]
    #[must_use]
    pub fn hit_with(&self, triangle: &HitTriangle<S>, rules: HitRules) -> Option<Hit<S>> {
        if S::IS_FAST && self.volumes.verdict(&triangle.volumes) == Verdict::Miss {
            return None;
        }
        self.ray.hit_with(&triangle.triangle, rules)
    }

    /// Does the ray hit a triangle? As [`Ray::is_hit`].
    ///
    /// *Numerics*: exact. *Panics*: never. *Cost*: 6 multiplications of four numbers at once for a
    /// clear hit or a clear miss; otherwise also [`Ray::is_hit`].
    #[inline]
    #[must_use]
    pub fn is_hit(&self, triangle: &HitTriangle<S>) -> bool {
        self.is_hit_with(triangle, HitRules::new())
    }

    /// [`is_hit`](Self::is_hit) under other rules, such as culling.
    #[inline]
    #[must_use]
    pub fn is_hit_with(&self, triangle: &HitTriangle<S>, rules: HitRules) -> bool {
        if !S::IS_FAST {
            return self.ray.is_hit_with(&triangle.triangle, rules);
        }
        let verdict = self.volumes.verdict(&triangle.volumes);
        if self.doubts >> verdict as u8 & 1 == 1 {
            return self.is_hit_in_doubt(triangle, rules);
        }
        verdict != Verdict::Miss && rules.cull.keeps(Facing::of(verdict == Verdict::Front))
    }

    #[cold]
    #[inline(never)]
    fn is_hit_in_doubt(&self, triangle: &HitTriangle<S>, rules: HitRules) -> bool {
        note(Stage::Look);
        self.ray.is_hit_with(&triangle.triangle, rules)
    }
}
