//! Whether a capsule and a shape are disjoint, touch or overlap.
//!
//! As for a [sphere](crate::query::sphere): the points nearer to the segment than the radius are an
//! open set. A capsule of radius zero is its segment, which is also a triangle without area.

use super::{meets_box, meets_segment, meets_triangle};
use crate::arithmetic::Each;
use crate::query::relation::{Relate, Relation};
use crate::query::sphere::{meet, meets_plane, of_ball};
use crate::scalar::Scalar;
use crate::shape::{Aabb, Capsule, Obb, Plane, Ray, Segment, Sphere, Triangle, Vec3};

/// The relation of a segment, as a triangle, with a shape.
fn of_segment<S: Scalar, T>((a, b): (Vec3<S>, Vec3<S>), shape: &T) -> Relation
where
    Triangle<S>: Relate<T>,
{
    // The ends are finite.
    Triangle::new(a, b, b).map_or(Relation::Disjoint, |segment| segment.relation(shape))
}

impl<S: Scalar> Relate<Triangle<S>> for Capsule<S> {
    fn relation(&self, triangle: &Triangle<S>) -> Relation {
        let meets = |ball| meets_triangle(self, triangle, ball);
        of_ball(self.radius() > S::ZERO, meets, || of_segment(self.ends(), triangle))
    }
}

impl<S: Scalar> Relate<Segment<S>> for Capsule<S> {
    fn relation(&self, segment: &Segment<S>) -> Relation {
        let meets = |ball| meets_segment(self, segment, S::ZERO, ball);
        of_ball(self.radius() > S::ZERO, meets, || of_segment(self.ends(), segment))
    }
}

impl<S: Scalar> Relate<Aabb<S>> for Capsule<S> {
    fn relation(&self, aabb: &Aabb<S>) -> Relation {
        let meets = |ball| meets_box(self, aabb, ball);
        of_ball(self.radius() > S::ZERO, meets, || of_segment(self.ends(), aabb))
    }
}

impl<S: Scalar> Relate<Obb<S>> for Capsule<S> {
    fn relation(&self, obb: &Obb<S>) -> Relation {
        let meets = |ball| meets_box(self, obb, ball);
        of_ball(self.radius() > S::ZERO, meets, || of_segment(self.ends(), obb))
    }
}

impl<S: Scalar> Relate<Self> for Capsule<S> {
    fn relation(&self, other: &Self) -> Relation {
        let segment = other.segment();
        let meets = |ball| meets_segment(self, &segment, other.radius(), ball);
        let has_radius = self.radius() > S::ZERO || other.radius() > S::ZERO;
        of_ball(has_radius, meets, || of_segment(self.ends(), &segment))
    }
}

impl<S: Scalar> Relate<Sphere<S>> for Capsule<S> {
    fn relation(&self, sphere: &Sphere<S>) -> Relation {
        let meets = |ball| meet(self, sphere, ball);
        let has_radius = self.radius() > S::ZERO || sphere.radius() > S::ZERO;
        // Both are thin: the centre is a triangle without extent.
        let center = (sphere.center(), sphere.center());
        of_ball(has_radius, meets, || of_segment(center, &self.segment()))
    }
}

impl<S: Scalar> Relate<Plane<S>> for Capsule<S> {
    fn relation(&self, plane: &Plane<S>) -> Relation {
        let without_radius = || {
            let is_on = |p| Sphere::new(p, S::ZERO).is_ok_and(|p| p.overlaps(plane));
            let [a, b] = self.ends().into();
            if is_on(a) == is_on(b) { Relation::Overlapping } else { Relation::Touching }
        };
        let meets = |ball| meets_plane(self.ends().into(), self.radius(), plane, ball);
        of_ball(self.radius() > S::ZERO, meets, without_radius)
    }
}

impl<S: Scalar> Relate<Ray<S>> for Capsule<S> {
    fn relation(&self, ray: &Ray<S>) -> Relation {
        let meets = |ball| meet(self, ray, ball);
        of_ball(self.radius() > S::ZERO, meets, || of_segment_and_ray(self, ray))
    }
}

/// The relation of a ray with the segment of a capsule without a radius, which it meets.
fn of_segment_and_ray<S: Scalar>(capsule: &Capsule<S>, ray: &Ray<S>) -> Relation {
    let ends = [capsule.ends().0, capsule.ends().1].each(|p| Sphere::new(p, S::ZERO));
    let [Ok(a), Ok(b)] = ends else { return Relation::Disjoint };
    if a == b {
        return a.relation(ray);
    }
    let with_range = |from, to| ray.with_range(from, to).ok();
    let [from, to] = [ray.t_min(), ray.t_max()];
    let at_ends = || [from, to].into_iter().flatten().filter_map(|t| with_range(Some(t), Some(t)));
    let is_point = from.is_some() && from == to;
    let is_on_line = |p: &Sphere<S>| with_range(None, None).is_some_and(|line| p.overlaps(&line));
    let (is_first, is_second) = (a.overlaps(ray), b.overlaps(ray));
    let touches = if is_point || !(is_on_line(&a) && is_on_line(&b)) {
        is_first || is_second || !is_point && at_ends().any(|end| capsule.overlaps(&end))
    } else {
        // On one line, a common end and no more.
        let shared = if is_first { a } else { b };
        is_first != is_second && at_ends().any(|end| shared.overlaps(&end))
    };
    if touches { Relation::Touching } else { Relation::Overlapping }
}
