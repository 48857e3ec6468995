//! Whether a sphere and a shape are disjoint, touch or overlap.
//!
//! An open set that meets a convex set meets its relative interior too (R. T. Rockafellar, *Convex
//! Analysis*, 1970, theorem 6.3). So a sphere with a radius above zero overlaps a shape at less than
//! its radius, and touches a shape at just that distance. A sphere of radius zero is a point.

use super::plane::meets_plane;
use super::{Ball, Beyond, meet};
use crate::query::relation::{Relate, Relation};
use crate::robust::Predicate;
use crate::scalar::Scalar;
use crate::shape::{Aabb, Obb, Plane, Ray, Segment, Sphere, Triangle};

/// The relation of the points within a radius of one shape with another shape. `meets` says whether
/// the ball meets that. Without a radius the relation is the one of the shape itself.
#[inline(always)]
pub(in crate::query) fn of_ball(
    has_radius: bool,
    meets: impl Fn(Ball) -> bool,
    without_radius: impl FnOnce() -> Relation,
) -> Relation {
    if !meets(Ball::Closed) {
        Relation::Disjoint
    } else if !has_radius {
        without_radius()
    } else if meets(Ball::Open) {
        Relation::Overlapping
    } else {
        Relation::Touching
    }
}

/// The relation with a shape, given that with the centre.
#[inline(always)]
fn relation<'a, S: Scalar, T>(
    sphere: &'a Sphere<S>,
    shape: &'a T,
    of_center: impl FnOnce(&Triangle<S>) -> Relation,
) -> Relation
where
    Beyond<'a, Sphere<S>, T>: Predicate<S, Answer = bool>,
{
    let at_center = || {
        let c = sphere.center();
        Triangle::new(c, c, c).map_or(Relation::Disjoint, |c| of_center(&c))
    };
    of_ball(sphere.radius() > S::ZERO, |ball| meet(sphere, shape, ball), at_center)
}

impl<S: Scalar> Relate<Triangle<S>> for Sphere<S> {
    fn relation(&self, triangle: &Triangle<S>) -> Relation {
        relation(self, triangle, |c| c.relation(triangle))
    }
}

impl<S: Scalar> Relate<Segment<S>> for Sphere<S> {
    fn relation(&self, segment: &Segment<S>) -> Relation {
        relation(self, segment, |c| c.relation(segment))
    }
}

impl<S: Scalar> Relate<Aabb<S>> for Sphere<S> {
    fn relation(&self, aabb: &Aabb<S>) -> Relation {
        relation(self, aabb, |c| c.relation(aabb))
    }
}

impl<S: Scalar> Relate<Obb<S>> for Sphere<S> {
    fn relation(&self, obb: &Obb<S>) -> Relation {
        relation(self, obb, |c| c.relation(obb))
    }
}

impl<S: Scalar> Relate<Self> for Sphere<S> {
    fn relation(&self, other: &Self) -> Relation {
        let has_radius = self.radius() > S::ZERO || other.radius() > S::ZERO;
        of_ball(has_radius, |ball| meet(self, other, ball), || Relation::Overlapping)
    }
}

impl<S: Scalar> Relate<Plane<S>> for Sphere<S> {
    fn relation(&self, plane: &Plane<S>) -> Relation {
        let meets = |ball| meets_plane([self.center(); 2], self.radius(), plane, ball);
        of_ball(self.radius() > S::ZERO, meets, || Relation::Overlapping)
    }
}

impl<S: Scalar> Relate<Ray<S>> for Sphere<S> {
    fn relation(&self, ray: &Ray<S>) -> Relation {
        let ends = [ray.t_min(), ray.t_max()];
        let is_at = |t: S| ray.with_range(t, t).is_ok_and(|end| self.overlaps(&end));
        let of_center = |_: &_| {
            let touches = ends[0] != ends[1] && ends.into_iter().flatten().any(is_at);
            if touches { Relation::Touching } else { Relation::Overlapping }
        };
        relation(self, ray, of_center)
    }
}
