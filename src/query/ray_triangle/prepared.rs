//! One triangle against many rays: its edges are computed once, in the scalar's first float, and a
//! ray that misses for certain is told so at once. Most of the gain is that `f32` need not become
//! `f64`, which only numbers need.

use super::rows::{First, Found, Rows, begins_elsewhere, first};
use super::{Cull, Hit, HitRules};
use crate::arithmetic::{OfFour, largest};
use crate::robust::{Stage, note};
use crate::scalar::Scalar;
use crate::shape::{Ray, Triangle};

type FirstRows<S> = Rows<<First<S> as OfFour>::Quad>;

/// A triangle prepared for many rays: exact, and faster than [`Ray::hit`] where most rays miss.
///
/// Choose it where a triangle meets many rays and few of them hit it, one in five or less: the
/// leaves of a tree. Where one ray in ten hits, [`hit`](Self::hit) takes three quarters of the time
/// of [`Ray::hit`], in `f32`; where every second does, half as much again. The answers are those of
/// [`Ray::hit`], bit by bit.
///
/// *Numerics*: exact. The edges are computed once, in floats of the scalar's own width, with a bound
/// on their error. A ray that may hit is asked itself.
///
/// *Range*: all of the scalar. It is faster for rays whose range begins at zero, in `f32` and in
/// fixed point, 32 bits below 2²⁴ units in the last place and 64 bits below 2⁵³, on machines with
/// 64-bit registers and, in fixed point, vectors and the feature `simd`. Elsewhere, and in `f64`,
/// the ray itself is asked, and preparing gains nothing.
///
/// ```
/// use septum::prepared::Target;
/// use septum::{Ray, Triangle};
///
/// let triangle = Triangle::new([0.0_f32; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0])?;
/// let target = Target::new(&triangle);
/// let down = |x, y| Ray::new([x, y, 2.0], [0.0, 0.0, -1.0]).unwrap();
/// assert_eq!(target.hit(&down(0.5, 0.5)).unwrap().t, 2.0); // an edge
/// assert!(target.is_hit(&down(0.75, 0.125)));
/// assert!(!target.is_hit(&down(0.5, 0.5_f32.next_up())));
/// # Ok::<(), septum::ShapeError>(())
/// ```
#[derive(Clone, Copy, Debug)]
pub struct Target<S: Scalar> {
    triangle: Triangle<S>,
    /// `None` where [`Ray::hit`] begins with the same floats or with none, or floats do not hold
    /// the triangle.
    rows: Option<FirstRows<S>>,
}

impl<S: Scalar> Target<S> {
    /// The triangle, prepared for many rays.
    ///
    /// *Panics*: never. *Cost*: 9 subtractions.
    #[inline]
    #[must_use]
    pub fn new(triangle: &Triangle<S>) -> Self {
        let points = triangle.points().map(first);
        let is_held = |limit| points.iter().all(|p| largest(p) < limit);
        let is_first = begins_elsewhere::<S>() && S::FIRST_LIMIT.is_none_or(is_held);
        Self { triangle: *triangle, rows: is_first.then(|| Rows::of_triangle(&points)) }
    }

    /// The triangle.
    #[inline]
    #[must_use]
    pub const fn triangle(&self) -> &Triangle<S> {
        &self.triangle
    }

    /// Where a ray crosses the triangle, if it does: what [`Ray::hit`] answers.
    ///
    /// *Numerics*: exact, and the same bits. *Panics*: never. *Cost*: 18 multiplications for a
    /// miss, and for a hit those of [`Ray::hit`].
    #[inline]
    #[must_use]
    pub fn hit(&self, ray: &Ray<S>) -> Option<Hit<S>> {
        self.hit_with(ray, HitRules::new())
    }

    /// [`hit`](Self::hit) by the rules given: what [`Ray::hit_with`] answers.
    #[inline]
    #[must_use]
    pub fn hit_with(&self, ray: &Ray<S>, rules: HitRules) -> Option<Hit<S>> {
        if self.verdict(ray) == Some(false) {
            return None;
        }
        ask_the_triangle(ray, &self.triangle, rules)
    }

    /// Whether a ray crosses the triangle: what [`Ray::is_hit`] answers.
    #[inline]
    #[must_use]
    pub fn is_hit(&self, ray: &Ray<S>) -> bool {
        self.is_hit_with(ray, HitRules::new())
    }

    /// [`is_hit`](Self::is_hit) by the rules given: what [`Ray::is_hit_with`] answers.
    #[inline]
    #[must_use]
    pub fn is_hit_with(&self, ray: &Ray<S>, rules: HitRules) -> bool {
        match self.verdict(ray) {
            Some(false) => false,
            Some(true) if rules.cull == Cull::Nothing && ray.t_max().is_none() => true,
            _ => ray.is_hit_with(&self.triangle, rules),
        }
    }

    /// Whether the ray hits, but for the end of its range, if floats are certain of it.
    #[inline(always)]
    fn verdict(&self, ray: &Ray<S>) -> Option<bool> {
        if !ray.t_min().is_some_and(|t| t == S::ZERO) {
            return None;
        }
        let (o, d) = (first(ray.origin().to_array()), first(ray.direction().to_array()));
        if let Some(limit) = S::FIRST_LIMIT {
            if !(largest(&o) < limit && largest(&d) < limit) {
                return None;
            }
        }
        let verdict = self.rows?.with_ray(o, d).found().map(|Found { is_ahead, .. }| is_ahead);
        if verdict.is_none() {
            note(Stage::Filter);
        }
        verdict
    }
}

/// Out of line: misses are to be fast.
#[inline(never)]
fn ask_the_triangle<S: Scalar>(
    ray: &Ray<S>,
    triangle: &Triangle<S>,
    rules: HitRules,
) -> Option<Hit<S>> {
    ray.hit_with(triangle, rules)
}
