//! One triangle against many rays: what does not depend on the ray is computed once, in the
//! scalar's first float, and a ray that misses for certain is told so at once. Most of the gain is
//! that `f32` need not become `f64`, which only numbers need.

use super::crossing::{Crossing, Sizes, error_bound};
use super::{Cull, Hit, HitRules};
use crate::arithmetic::{Filtered, FirstFloat, Float, cross, dot, greatest, largest};
use crate::robust::{Stage, note};
use crate::scalar::Scalar;
use crate::shape::{Ray, Triangle};

type First<S> = <S as FirstFloat>::First;

/// A triangle prepared for many rays: exact, and faster than [`Ray::hit`] where most rays miss.
///
/// Choose it where a triangle meets many rays and few of them hit it, one in five or less: the
/// leaves of a tree, visibility. In `f32` a miss takes about half the time, a hit half as much
/// again. The answers are those of [`Ray::hit`], bit by bit.
///
/// *Numerics*: exact. Edges, normal and all else that does not depend on the ray are computed
/// once, in floats of the scalar's own width, with a bound on their error. A ray that may hit is
/// asked itself.
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
    view: Option<View<First<S>>>,
}

/// What of a triangle is the same for every ray.
#[derive(Clone, Copy, Debug)]
struct View<F> {
    /// The first vertex.
    a: [F; 3],
    /// The edges to the second and the third vertex.
    e: [[F; 3]; 2],
    /// Their cross product.
    n: [F; 3],
    /// The greatest component of both edges.
    edges: F,
}

impl<S: Scalar> Target<S> {
    /// The triangle, prepared for many rays.
    ///
    /// *Panics*: never. *Cost*: 6 multiplications.
    #[inline]
    #[must_use]
    pub fn new(triangle: &Triangle<S>) -> Self {
        Self { triangle: *triangle, view: View::new(triangle) }
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
        let (o, d) =
            (ray.origin().to_array().map(S::first), ray.direction().to_array().map(S::first));
        if let Some(limit) = S::FIRST_LIMIT {
            if !(largest(&o) < limit && largest(&d) < limit) {
                return None;
            }
        }
        let crossing = self.view.as_ref()?.crossing(o, d);
        let verdict = crossing.and_then(|crossing| crossing.strictly_ahead());
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

impl<F: Float> View<F> {
    /// `None` where [`Ray::hit`] begins with the same floats or with none, or floats do not hold
    /// the triangle.
    #[inline(always)]
    fn new<S: Scalar + FirstFloat<First = F>>(triangle: &Triangle<S>) -> Option<Self> {
        let [a, b, c] = triangle.points().map(|p| p.map(S::first));
        let is_held = |limit| largest(&a) < limit && largest(&b) < limit && largest(&c) < limit;
        let is_double = S::FLOAT.is_some() && size_of::<F>() == size_of::<f64>();
        if !S::IN_QUADS || is_double || S::FIRST_LIMIT.is_some_and(|limit| !is_held(limit)) {
            return None;
        }
        let e @ [e1, e2] = [way(a, b), way(a, c)];
        let n = cross::<Filtered<F>>(&e1, &e2);
        Some(Self { a, e, n, edges: greatest(largest(&e1), largest(&e2)) })
    }

    /// The volumes of [`Setting`](super::crossing::Setting), by other products, if it is known
    /// how far they are from the truth: no farther than those, for each term is touched by as
    /// many roundings. `prepared.g` proves it.
    #[inline(always)]
    fn crossing(&self, o: [F; 3], d: [F; 3]) -> Option<Crossing<F>> {
        let Self { a, e: [e1, e2], n, edges } = self;
        let s = way(*a, o);
        let m = cross::<Filtered<F>>(&s, &d);
        let (u, v) = (dot::<Filtered<F>>(&m, e2), -dot::<Filtered<F>>(&m, e1));
        let (det, t) = (-dot::<Filtered<F>>(n, &d), dot::<Filtered<F>>(n, &s));
        let size = greatest(*edges, largest(&s));
        let sizes = Sizes { direction: largest(&d), edges: *edges, size };
        let error_bound = error_bound::<Filtered<F>>(sizes)?;
        Some(Crossing { det, t, sides: [det - u - v, u, v], error_bound })
    }
}

#[inline(always)]
fn way<F: Float>(a: [F; 3], b: [F; 3]) -> [F; 3] {
    [b[0] - a[0], b[1] - a[1], b[2] - a[2]]
}
