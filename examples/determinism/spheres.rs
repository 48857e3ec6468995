//! Questions about spheres, capsules, closest points and distances.

use septum::relation::Relate;
use septum::{Aabb, Capsule, Closest, Obb, Plane, Ray, Scalar, Segment, Sphere, Triangle, Vec3};

use super::super::draw::Draw;
use super::answers::Answers;
use super::moving::of_feature;
use super::pairs::middle;
use super::queries::Query;

/// The other shapes of a case.
pub(super) struct Others<'a, S> {
    pub(super) triangle: &'a Triangle<S>,
    pub(super) aabbs: [&'a Aabb<S>; 2],
    pub(super) segments: &'a [Option<Segment<S>>; 2],
    pub(super) planes: &'a [Option<Plane<S>>; 2],
    pub(super) ray: Option<&'a Ray<S>>,
}

impl<S: Scalar> Clone for Others<'_, S> {
    fn clone(&self) -> Self {
        *self
    }
}

impl<S: Scalar> Copy for Others<'_, S> {}

/// Spheres with a triangle, segments, boxes, points and spheres.
#[inline(never)]
pub(super) fn spheres<S: Draw, A: Answers>(
    Others { triangle, aabbs, segments, .. }: Others<'_, S>,
    [p, q, d]: [Vec3<S>; 3],
    answers: &mut A,
) {
    let [a, b, c] = *triangle.vertices();
    let middle = middle(middle(a, b), c);
    for (center, radius) in [(p, d.x), (d, q.y), (middle, d.z), (q, p.z), (p, S::ZERO)] {
        let Ok(sphere) = Sphere::new(center, radius.size()) else { continue };
        answers.to(Query::SphereTriangle).yes(sphere.overlaps(triangle));
        for segment in segments.iter().flatten() {
            answers.to(Query::SphereSegment).yes(sphere.overlaps(segment));
        }
        for aabb in aabbs {
            answers.to(Query::SphereAabb).yes(sphere.overlaps(aabb));
        }
        for point in [a, b, c] {
            answers.to(Query::SphereContains).yes(sphere.contains(point));
            let Ok(other) = Sphere::new(point, q.x.size()) else { continue };
            answers.to(Query::SphereSphere).yes(sphere.overlaps(&other));
        }
        closest(answers, Query::TriangleClosest, triangle.closest_point(center).ok());
        for segment in segments.iter().flatten() {
            closest(answers, Query::SegmentClosest, segment.closest_point(center).ok());
        }
        for aabb in aabbs {
            answers.to(Query::AabbClosest).vector(aabb.closest_point(center).ok());
        }
        let squared = answers.to(Query::DistanceSquared);
        squared.maybe(triangle.distance_squared(center).ok());
        squared.maybe(segments[1].and_then(|segment| segment.distance_squared(center).ok()));
        squared.maybe(aabbs[0].distance_squared(center).ok());
        let range = answers.to(Query::DistanceRange);
        range.range(triangle.distance_squared_range(center).ok());
        range.range(segments[0].and_then(|x| x.distance_squared_range(center).ok()));
        range.range(aabbs[1].distance_squared_range(center).ok());
    }
}

pub(super) fn closest<S: Draw, A: Answers>(
    answers: &mut A,
    query: Query,
    found: Option<Closest<S>>,
) {
    let answer = answers.to(query);
    answer.vector(found.map(|closest| closest.point));
    answer.byte(of_feature(found.map(|closest| closest.feature)));
}

/// The relations of spheres and capsules, some without radius, with all others.
#[inline(never)]
pub(super) fn relations<S: Draw, A: Answers>(
    others: Others<'_, S>,
    [p, q, d]: [Vec3<S>; 3],
    answers: &mut A,
) {
    let Others { triangle, aabbs, segments, planes, ray } = others;
    let [a, b, c] = *triangle.vertices();
    let other = Sphere::new(middle(a, c), q.y.size());
    let answer = answers.to(Query::SphereRelation);
    for (center, radius) in [(p, d.y), (middle(a, b), q.z), (d, p.x), (a, S::ZERO), (d, S::ZERO)] {
        let Ok(sphere) = Sphere::new(center, radius.size()) else { continue };
        answer.relation(sphere.relation(triangle));
        segments.iter().flatten().for_each(|x| answer.relation(sphere.relation(x)));
        aabbs.iter().for_each(|&x| answer.relation(sphere.relation(x)));
        planes.iter().flatten().for_each(|x| answer.relation(sphere.relation(x)));
        other.iter().for_each(|x| answer.relation(sphere.relation(x)));
        let Some(ray) = ray else { continue };
        answer.relation(sphere.relation(ray));
        for range in [[Some(S::ZERO), Some(d.x.size())], [None, Some(q.x)]] {
            let ray = ray.with_range(range[0], range[1]);
            ray.iter().for_each(|x| answer.relation(sphere.relation(x)));
        }
    }
    let other_capsule = Capsule::new(b, p, d.z.size());
    let answer = answers.to(Query::CapsuleRelation);
    for (ends, radius) in [([p, d], q.x), ([a, q], d.x), ([a, b], S::ZERO), ([q, d], S::ZERO)] {
        let Ok(capsule) = Capsule::new(ends[0], ends[1], radius.size()) else { continue };
        answer.relation(capsule.relation(triangle));
        segments.iter().flatten().for_each(|x| answer.relation(capsule.relation(x)));
        aabbs.iter().for_each(|&x| answer.relation(capsule.relation(x)));
        planes.iter().flatten().for_each(|x| answer.relation(capsule.relation(x)));
        other.iter().for_each(|x| answer.relation(capsule.relation(x)));
        other_capsule.iter().for_each(|x| answer.relation(capsule.relation(x)));
    }
}

/// The relations of capsules with a ray and parts of it.
#[inline(never)]
pub(super) fn rays<S: Draw, A: Answers>(
    ray: &Ray<S>,
    triangle: &Triangle<S>,
    [p, q, d]: [Vec3<S>; 3],
    answers: &mut A,
) {
    let [a, b, c] = *triangle.vertices();
    let o = ray.origin();
    let (x, y) = if q.x < d.y { (q.x, d.y) } else { (d.y, q.x) };
    let ranges = [[Some(S::ZERO), None], [Some(S::ZERO), Some(d.x.size())], [Some(x), Some(y)]];
    for ends in [[p, d], [a, q], [middle(a, b), c], [o, b]] {
        for radius in [q.x, d.y, S::ZERO] {
            let Ok(capsule) = Capsule::new(ends[0], ends[1], radius.size()) else { continue };
            for [from, to] in ranges {
                let Ok(part) = ray.with_range(from, to) else { continue };
                answers.to(Query::CapsuleRay).relation(capsule.relation(&part));
            }
        }
    }
}

/// The relations of spheres and capsules with an oriented box.
#[inline(never)]
pub(super) fn oriented<S: Draw, A: Answers>(
    obb: &Obb<S>,
    triangle: &Triangle<S>,
    [p, q, d]: [Vec3<S>; 3],
    answers: &mut A,
) {
    let [a, b, c] = *triangle.vertices();
    for ends in [[p, d], [a, b], [middle(q, c), obb.center()]] {
        for radius in [q.x, d.y, S::ZERO] {
            let sphere = Sphere::new(ends[0], radius.size());
            let capsule = Capsule::new(ends[0], ends[1], radius.size());
            let (Ok(sphere), Ok(capsule)) = (sphere, capsule) else { continue };
            answers.to(Query::SphereObb).relation(sphere.relation(obb));
            answers.to(Query::CapsuleObb).relation(capsule.relation(obb));
        }
    }
}
