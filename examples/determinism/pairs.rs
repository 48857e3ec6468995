//! Questions about pairs of shapes: boxes with boxes and points, shapes that move past a box, a
//! triangle with triangles, segments and points, and two hits of one ray.

use septum::polygon::Polygon;
use septum::published;
use septum::relation::Relate;
use septum::sweep::{Motion, Sweep};
use septum::{Aabb, Axis, Obb, Ray, Segment, Triangle, Vec3};

use super::super::draw::Draw;
use super::answers::Answers;
use super::queries::Query;
use super::{greatest, least};

#[inline(never)]
pub(super) fn boxes<S: Draw, A: Answers>(
    triangle: &Triangle<S>,
    aabbs: [&Aabb<S>; 2],
    obb: Option<&Obb<S>>,
    answers: &mut A,
) {
    let [a, b, c] = *triangle.vertices();
    for aabb in aabbs {
        answers.to(Query::TriangleAabbRelation).relation(triangle.relation(aabb));
        for corners in [[a, b], [b, c]].map(|[p, q]| (least(p, q), greatest(p, q))) {
            let Ok(around) = Aabb::from_min_max(corners.0, corners.1) else { continue };
            answers.to(Query::AabbAabb).yes(aabb.overlaps(&around));
            answers.to(Query::AabbAabbRelation).relation(aabb.relation(&around));
            answers.to(Query::TriangleAabbRelation).relation(triangle.relation(&around));
        }
        for point in [a, b, c] {
            answers.to(Query::AabbContains).yes(aabb.contains(point));
        }
    }
    if let Some(obb) = obb {
        answers.to(Query::TriangleObbRelation).relation(triangle.relation(obb));
        // The same box at another place, with its axes in another order.
        let [u, v, w] = *obb.axes();
        for (center, axes) in [(a, [u, v, w]), (b, [w, u, v]), (c, [v, b, u])] {
            let Ok(other) = Obb::from_skewed_axes(center, axes, obb.half_extents()) else {
                continue;
            };
            answers.to(Query::ObbObb).yes(obb.overlaps(&other));
            answers.to(Query::ObbObbMay).yes(other.may_overlap(obb));
            answers.to(Query::ObbObbRelation).relation(obb.relation(&other));
            answers.to(Query::TriangleObbRelation).relation(other.relation(triangle));
            for aabb in aabbs {
                answers.to(Query::AabbObb).yes(aabb.overlaps(&other));
                answers.to(Query::AabbObbMay).yes(aabb.may_overlap(&other));
                answers.to(Query::AabbObbRelation).relation(aabb.relation(&other));
            }
        }
        for point in [a, b, c, obb.center()] {
            answers.to(Query::ObbContains).yes(obb.contains(point));
        }
        // By corners; a point if there are none.
        let corners = obb.aabb().and_then(|aabb| aabb.min_max());
        for corner in corners.map_or([None; 2], |(min, max)| [Some(min), Some(max)]) {
            answers.to(Query::ObbAabb).vector(corner);
        }
    }
    for axis in Axis::ALL {
        answers.to(Query::AxisVector).vector(Some(axis.vector(triangle)));
    }
}

/// Rotated boxes: their axes, and the axes from a quaternion equal to the first axis.
#[inline(never)]
pub(super) fn turned<S: Draw, A: Answers>(turns: [Vec3<S>; 2], half: Vec3<S>, answers: &mut A) {
    for turns in turns {
        let made = Obb::from_turns(turns, turns, half);
        for i in 0..3 {
            answers.to(Query::ObbTurns).vector(made.ok().map(|obb| obb.axes()[i]));
        }
        let Ok(made) = made else { continue };
        let Vec3 { x, y, z } = made.axes()[0];
        for quaternion in [[x, y, z, S::ZERO], [z, S::ZERO, x, y], [turns.x, x, y, z]] {
            let made = Obb::from_quaternion(turns, quaternion, half);
            for i in 0..3 {
                answers.to(Query::ObbQuaternion).vector(made.ok().map(|obb| obb.axes()[i]));
            }
        }
    }
}

/// A ray, a range of it between two numbers, and segments, with an oriented box.
#[inline(never)]
pub(super) fn lines<S: Draw, A: Answers>(
    obb: &Obb<S>,
    ray: Option<&Ray<S>>,
    segments: &[Option<Segment<S>>; 2],
    [from, to]: [S; 2],
    answers: &mut A,
) {
    let limited = ray.and_then(|ray| (*ray).with_range(from, to).ok());
    let line = ray.and_then(|ray| (*ray).with_range(None, None).ok());
    for ray in ray.into_iter().chain(&limited).chain(&line) {
        answers.to(Query::RayObb).yes(ray.overlaps(obb));
        answers.to(Query::RayObbMay).yes(ray.may_overlap(obb));
        answers.to(Query::RayObbRange).range(ray.t_range_obb(obb));
        answers.to(Query::RayObbCrossings).crossings(ray.crossings_obb(obb), obb);
    }
    let through = Segment::new(obb.center(), obb.axes()[0]).ok();
    for segment in segments.iter().chain(&[through]).flatten() {
        answers.to(Query::SegmentObb).yes(segment.overlaps(obb));
        answers.to(Query::SegmentObbMay).yes(segment.may_overlap(obb));
    }
}

/// Polygons of the triangle's vertices, the midpoints between them, and another point: flat except
/// for rounding, and bent.
#[inline(never)]
pub(super) fn polygons<S: Draw, A: Answers>(
    triangle: &Triangle<S>,
    aabbs: [&Aabb<S>; 2],
    other: Vec3<S>,
    answers: &mut A,
) {
    let [a, b, c] = *triangle.vertices();
    let vertices = [a, middle(a, b), b, middle(b, c), c, other];
    for vertices in [&vertices[..4], &vertices[..5], &vertices[2..], &vertices] {
        let Ok(polygon) = Polygon::new(vertices) else { continue };
        for aabb in aabbs {
            answers.to(Query::PolygonAabb).yes(polygon.overlaps(aabb));
            let published = published::green_hatch::overlaps(&polygon, aabb);
            answers.to(Query::PolygonAabbPublished).yes(published);
        }
    }
}

/// Half of the way from one point to another.
pub(super) fn middle<S: Draw>(a: Vec3<S>, b: Vec3<S>) -> Vec3<S> {
    Vec3::new(a.x.middle(b.x), a.y.middle(b.y), a.z.middle(b.z))
}

/// The triangle past the boxes, with motions that lead to them or elsewhere, and a box around an
/// edge of the triangle. Their last free places only if asked for, because each takes up to 64 looks.
#[inline(never)]
pub(super) fn sweeps<S: Draw, A: Answers>(
    triangle: &Triangle<S>,
    aabbs: [&Aabb<S>; 2],
    [p, q]: [Vec3<S>; 2],
    with_last_free: bool,
    answers: &mut A,
) {
    let [a, b, c] = *triangle.vertices();
    for (from, to) in [(a, p), (q, b), (c, Vec3::new(c.x, c.y, p.z))] {
        let Ok(motion) = Motion::new(from, to) else { continue };
        for aabb in aabbs {
            let first = triangle.first_contact(&motion, aabb);
            answers.to(Query::TriangleAabbSweep).contact(first);
            answers.to(Query::TriangleAabbSweep).yes(aabb.meets_along(&motion, triangle));
            let along = triangle.relation_along(&motion, aabb);
            answers.to(Query::TriangleAabbAlong).relation(along);
            if with_last_free {
                let place = triangle.last_free(&motion, aabb);
                answers.to(Query::TriangleAabbLastFree).vector(place);
            }
        }
        let Ok(around) = Aabb::from_min_max(least(a, b), greatest(a, b)) else { continue };
        for aabb in aabbs {
            answers.to(Query::AabbAabbSweep).contact(around.first_contact(&motion, aabb));
            answers.to(Query::AabbAabbSweep).yes(aabb.meets_along(&motion, &around));
            answers.to(Query::AabbAabbAlong).relation(around.relation_along(&motion, aabb));
            if with_last_free {
                answers.to(Query::AabbAabbLastFree).vector(around.last_free(&motion, aabb));
            }
        }
    }
}

/// The triangle with other triangles, some with a common vertex or edge; with segments, one in its
/// plane; and with points.
#[inline(never)]
pub(super) fn flats<S: Draw, A: Answers>(
    triangle: &Triangle<S>,
    segments: &[Option<Segment<S>>; 2],
    [p, q, d]: [Vec3<S>; 3],
    answers: &mut A,
) {
    let [a, b, c] = *triangle.vertices();
    for [x, y, z] in [[p, q, d], [p, q, middle(a, b)], [p, b, a], [c, q, q], [middle(b, c), p, a]] {
        let Ok(other) = Triangle::new(x, y, z) else { continue };
        answers.to(Query::TriangleTriangle).yes(triangle.overlaps(&other));
        answers.to(Query::TriangleTriangleMay).yes(triangle.may_overlap(&other));
        answers.to(Query::TriangleTriangleRelation).relation(triangle.relation(&other));
        answers.to(Query::TriangleTriangleCrossing).segment(triangle.crossing(&other));
    }
    let ends = [(p, middle(a, b)), (middle(a, b), c), (p, q)].map(|(x, y)| Segment::new(x, y).ok());
    for segment in ends.iter().chain(segments).flatten() {
        answers.to(Query::SegmentTriangle).yes(segment.overlaps(triangle));
        answers.to(Query::SegmentTriangleMay).yes(segment.may_overlap(triangle));
        answers.to(Query::SegmentTriangleRelation).relation(segment.relation(triangle));
    }
    for point in [a, middle(a, b), middle(middle(a, b), c), p] {
        answers.to(Query::TriangleContains).yes(triangle.contains(point));
    }
}

/// The triangle, and a copy with one vertex moved: equal and different distances.
#[inline(never)]
pub(super) fn hits<S: Draw, A: Answers>(
    ray: &Ray<S>,
    triangle: &Triangle<S>,
    other: Vec3<S>,
    answers: &mut A,
) {
    let [a, b, c] = *triangle.vertices();
    for vertices in [[b, a, c], [a, b, other], [other, b, c]] {
        let Ok(moved) = Triangle::new(vertices[0], vertices[1], vertices[2]) else { continue };
        let order = ray.compare_hits(triangle, &moved);
        answers.to(Query::RayCompareHits).byte(order.map_or(0xff, |order| order as i8 as u8));
    }
}
