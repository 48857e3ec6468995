//! Whether a capsule and a shape are disjoint, touch or overlap.
//!
//! As for a [sphere](crate::query::sphere): the points nearer to the segment than the radius are an
//! open set. A capsule of radius zero is its segment, which is also a triangle without area.

use super::aabb::meets_aabb;
use super::{meets_plane, meets_segment, meets_sphere, meets_triangle};
use crate::query::relation::{Relate, Relation};
use crate::query::sphere::of_ball;
use crate::scalar::Scalar;
use crate::shape::{Aabb, Capsule, Plane, Segment, Sphere, Triangle, Vec3};

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
        let meets = |ball| meets_aabb(self, aabb, ball);
        of_ball(self.radius() > S::ZERO, meets, || of_segment(self.ends(), aabb))
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
        let meets = |ball| meets_sphere(self, sphere, ball);
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
            let (a, b) = self.ends();
            if is_on(a) == is_on(b) { Relation::Overlapping } else { Relation::Touching }
        };
        of_ball(self.radius() > S::ZERO, |ball| meets_plane(self, plane, ball), without_radius)
    }
}
