//! A fixed stream of questions, and a hash of all their answers.
//!
//! Nothing here may depend on the machine: numbers are made from bits, floats use no more than
//! exact scaling, and no library functions are called.

use septum::Vec3;
use septum::lanes::{NormalTriangles, Rays, SlabRays, Triangles};
use septum::prepared::PreparedTriangle;
use septum::published;
use septum::published::projected::ProjectedTriangle;
use septum::published::slabs::SlabRay;
use septum::published::slopes::SlopeRay;
use septum::published::stored_normal::NormalTriangle;
use septum::published::watertight::ShearedRay;
use septum::{Aabb, Axis, Cull, Obb, Plane, Ray, Scalar, Segment, Side, Triangle};

use super::draw::{Draw, Rng};

// By path, because a test in another folder includes this file too.
#[path = "added.rs"]
mod added;
#[path = "answers.rs"]
pub(crate) mod answers;
#[path = "contacts.rs"]
mod contacts;
#[path = "grids.rs"]
mod grids;
#[path = "meshes.rs"]
mod meshes;
#[path = "moving.rs"]
mod moving;
#[path = "pairs.rs"]
mod pairs;
#[path = "queries.rs"]
pub(crate) mod queries;
#[path = "spheres.rs"]
mod spheres;

use answers::Answers;
use queries::Query;

/// The number of cases for a scalar.
pub(crate) const CASES: u32 = 1000;

/// Asks all questions about `cases` cases in this scalar. The questions of `added` run on every
/// fourth case, and those about spheres, meshes and grids on every sixteenth, because a small core
/// already takes a minute for the rest.
pub(crate) fn ask<S: Draw, A: Answers>(cases: u32, answers: &mut A) {
    let mut rng = Rng::new(0x5e97_0a11);
    for k in 0..cases {
        case::<S, A>(&mut rng, answers, k);
    }
}

/// One triangle against a box of each kind, the boxes against a plane, a segment and a ray; and the
/// remaining questions, in the cases that have them.
#[inline(never)]
fn case<S: Draw, A: Answers>(rng: &mut Rng, answers: &mut A, k: u32) {
    let kind = rng.below(6) as u8;
    let point = |rng: &mut Rng| Vec3::from([(); 3].map(|()| S::draw(rng, kind)));
    let [a, b, c, p, q, d, n, o] = [(); 8].map(|()| point(rng));
    let triangle = Triangle::new(a, b, if rng.below(8) == 0 { a } else { c });
    let half = Vec3::new(q.x.size(), q.y.size(), q.z.size());
    let corners = Aabb::from_min_max(least(p, q), greatest(p, q));
    // Drawn numbers are finite, and half-extents are not negative.
    let (Ok(triangle), Ok(centered), Ok(corners)) =
        (triangle, Aabb::from_center_half_extents(p, half), corners)
    else {
        return answers.to(Query::ShapesAccepted).byte(0xff);
    };
    let aabbs = [&centered, &corners];
    let planes = [Plane::from_point_normal(o, n), Plane::from_equation(n, o.x)].map(Result::ok);
    let segments = [Segment::new(o, d), Segment::from_center_half_vector(o, d)].map(Result::ok);
    for aabb in aabbs {
        boxes(&triangle, aabb, answers);
        planes.iter().flatten().for_each(|plane| sides(plane, aabb, answers));
        for segment in segments.iter().flatten() {
            answers.to(Query::SegmentAabb).yes(segment.overlaps(aabb));
            answers.to(Query::SegmentAabbMay).yes(segment.may_overlap(aabb));
        }
    }
    let axes = if rng.below(2) == 0 { [d, n, o] } else { [d, p, n] };
    let obb = Obb::from_skewed_axes(p, axes, half).ok();
    if let Some(obb) = &obb {
        answers.to(Query::TriangleObb).yes(triangle.overlaps(obb));
        answers.to(Query::TriangleObbMay).yes(triangle.may_overlap(obb));
        answers
            .to(Query::TriangleObbTransform)
            .yes(published::akenine_moller::overlaps_obb(&triangle, obb));
    }
    // Toward the triangle, or anywhere.
    let direction = if rng.below(3) == 0 { d } else { towards(o, &triangle) };
    let ray = Ray::new(o, direction).ok();
    if let Some(ray) = &ray {
        crossings(ray, &triangle, aabbs, answers);
        lanes(ray, &triangle, aabbs, answers);
    }
    if k % 4 != 0 {
        return;
    }
    let accepted = answers.to(Query::ShapesAccepted);
    planes.iter().for_each(|plane| accepted.yes(plane.is_some()));
    segments.iter().for_each(|segment| accepted.yes(segment.is_some()));
    accepted.yes(obb.is_some());
    accepted.yes(ray.is_some());
    added::shapes(&triangle, aabbs, &segments, answers);
    pairs::boxes(&triangle, aabbs, obb.as_ref(), answers);
    pairs::flats(&triangle, &segments, [p, q, d], answers);
    pairs::turned([a, d], half, answers);
    if let Some(obb) = &obb {
        pairs::lines(obb, ray.as_ref(), &segments, [least(p, q).x, greatest(p, q).x], answers);
    }
    if k % 8 == 0 {
        contacts::all(&triangle, aabbs, obb.as_ref(), answers);
    }
    pairs::sweeps(&triangle, aabbs, [p, d], k % 16 == 0, answers);
    pairs::polygons(&triangle, aabbs, d, answers);
    if k % 16 == 0 {
        let (triangle, ray) = (&triangle, ray.as_ref());
        let others = spheres::Others { triangle, aabbs, segments: &segments, planes: &planes, ray };
        spheres::spheres(others, [p, q, d], answers);
        spheres::relations(others, [p, q, d], answers);
        contacts::round(triangle, aabbs, [p, q, d], answers);
        if let Some(ray) = ray {
            spheres::rays(ray, triangle, [p, q, d], answers);
        }
        if let Some(obb) = &obb {
            spheres::oriented(obb, triangle, [p, q, d], answers);
        }
        moving::spheres(others, [p, q, d], answers);
        let shapes =
            meshes::Shapes { aabbs, obb: obb.as_ref(), triangle, segments: &segments, ray };
        meshes::all(&[a, b, c, p, q, d, n, o], &shapes, answers);
        grids::grids(least(p, q), half, triangle, &segments, ray, answers);
    }
    if let Some(ray) = &ray {
        added::crossings(ray, &triangle, aabbs, answers);
        added::lanes(ray, &triangle, aabbs, answers);
        pairs::hits(ray, &triangle, d, answers);
    }
}

#[inline(never)]
fn boxes<S: Draw, A: Answers>(triangle: &Triangle<S>, aabb: &Aabb<S>, answers: &mut A) {
    answers.to(Query::TriangleAabb).yes(triangle.overlaps(aabb));
    let prepared = PreparedTriangle::new(triangle);
    answers.to(Query::TriangleAabbPrepared).yes(prepared.overlaps(aabb));
    answers.to(Query::TriangleAabbMay).yes(triangle.may_overlap(aabb));
    answers.to(Query::TriangleAabbRounded).yes(published::shared_normal::overlaps(triangle, aabb));
    answers
        .to(Query::TriangleAabbPublished)
        .yes(published::akenine_moller::overlaps(triangle, aabb));
    answers.to(Query::TriangleAabbAxis).axis(triangle.separating_axis(aabb));
    for axis in Axis::ALL {
        answers.to(Query::TriangleAabbBy).yes(triangle.is_separated_by(aabb, axis));
    }
}

#[inline(never)]
fn sides<S: Draw, A: Answers>(plane: &Plane<S>, aabb: &Aabb<S>, answers: &mut A) {
    answers.to(Query::PlaneAabb).yes(plane.overlaps(aabb));
    answers.to(Query::PlaneAabbSide).byte(match plane.side_of(aabb) {
        Side::Front => 0,
        Side::Back => 1,
        Side::Both => 2,
    });
}

#[inline(never)]
fn crossings<S: Draw, A: Answers>(
    ray: &Ray<S>,
    triangle: &Triangle<S>,
    aabbs: [&Aabb<S>; 2],
    answers: &mut A,
) {
    answers.to(Query::RayTriangle).hit(ray.hit(triangle));
    answers.to(Query::RayTriangleOnce).hit(ray.hit_once(triangle));
    answers.to(Query::RayTriangleIs).yes(ray.is_hit(triangle));
    let (by_normal, projected, nothing) =
        (&NormalTriangle::new(triangle), ProjectedTriangle::new(triangle), Cull::Nothing);
    answers
        .to(Query::RayTriangleMollerTrumbore)
        .hit(published::moller_trumbore::hit(ray, triangle, nothing));
    answers.to(Query::RayTriangleVolumes).hit(published::volumes::hit(ray, triangle, nothing));
    answers.to(Query::RayTriangleStored).hit(published::stored_normal::hit(
        ray,
        by_normal,
        Cull::Back,
    ));
    answers.to(Query::RayTriangleProjected).hit(published::projected::hit(
        ray,
        &projected,
        Cull::Front,
    ));
    answers.to(Query::RayTriangleWatertight).hit(ShearedRay::new(ray).hit(triangle, nothing));
    let (slabs, slopes) = (&SlabRay::new(ray), SlopeRay::new(ray));
    for aabb in aabbs {
        answers.to(Query::RayAabb).yes(ray.overlaps(aabb));
        answers.to(Query::RayAabbMay).yes(ray.may_overlap(aabb));
        answers.to(Query::RayAabbRange).range(ray.t_range(aabb));
        answers.to(Query::RayAabbCrossings).crossings(ray.crossings(aabb), aabb);
        answers.to(Query::RayAabbSlabsRange).range(slabs.t_range_rounded(aabb));
        answers.to(Query::RayAabbSlabsMay).yes(slabs.may_overlap(aabb));
        answers.to(Query::RayAabbSlopes).yes(slopes.overlaps_rounded(aabb));
    }
}

/// Four lanes: the triangle and its copies with rotated vertices, the ray and its copies with
/// exchanged ends. These loops become vector instructions.
#[inline(never)]
fn lanes<S: Draw, A: Answers>(
    ray: &Ray<S>,
    triangle: &Triangle<S>,
    aabbs: [&Aabb<S>; 2],
    answers: &mut A,
) {
    let Some(Four { rays, triangles }) = Four::new(ray, triangle) else {
        return answers.to(Query::ShapesAccepted).byte(0xfe);
    };
    let (by_normal, by_slabs) =
        (triangles.map(|t| NormalTriangle::new(&t)), rays.map(|r| SlabRay::new(&r)));
    let (triangles, rays) = (Triangles::new(&triangles), Rays::new(&rays));
    let (by_normal, nothing) = (NormalTriangles::new(&by_normal), Cull::Nothing);
    answers.to(Query::RayTriangles).hits(&triangles.hit(ray));
    answers
        .to(Query::RayTrianglesMollerTrumbore)
        .hits(&triangles.hit_moller_trumbore(ray, nothing));
    answers.to(Query::RayTrianglesVolumes).hits(&triangles.hit_volumes(ray, Cull::Back));
    answers.to(Query::RayTrianglesStored).hits(&by_normal.hit(ray, nothing));
    answers
        .to(Query::RayTrianglesWatertight)
        .hits(&triangles.hit_watertight(&ShearedRay::new(ray), nothing));
    answers.to(Query::RaysTriangleVolumes).hits(&rays.hit_volumes(triangle, Cull::Front));
    let slabs = SlabRays::new(&by_slabs);
    for aabb in aabbs {
        answers.to(Query::RaysAabbSlabs).ranges(&slabs.t_range_rounded(aabb));
    }
}

/// The shapes of the questions about lanes.
struct Four<S> {
    rays: [Ray<S>; 4],
    triangles: [Triangle<S>; 4],
}

impl<S: Draw> Four<S> {
    fn new(ray: &Ray<S>, triangle: &Triangle<S>) -> Option<Self> {
        let [a, b, c] = *triangle.vertices();
        let turned = [[a, b, c], [b, c, a], [c, a, b], [b, a, c]];
        let back = Ray::new(ray.direction(), ray.origin()).ok()?;
        let rays = [ray, &back, &back, ray].map(Clone::clone);
        let triangles = turned.map(|[a, b, c]| Triangle::new(a, b, c).unwrap_or(*triangle));
        Some(Self { rays, triangles })
    }
}

/// From a point to the middle of the triangle, or near it.
fn towards<S: Draw>(p: Vec3<S>, triangle: &Triangle<S>) -> Vec3<S> {
    let [a, b, c] = *triangle.vertices();
    let to = |p: S, a: S, b: S, c: S| a.middle(b).middle(c).minus(p);
    Vec3::new(to(p.x, a.x, b.x, c.x), to(p.y, a.y, b.y, c.y), to(p.z, a.z, b.z, c.z))
}

fn least<S: Scalar>(p: Vec3<S>, q: Vec3<S>) -> Vec3<S> {
    let low = |p: S, q: S| if q < p { q } else { p };
    Vec3::new(low(p.x, q.x), low(p.y, q.y), low(p.z, q.z))
}

fn greatest<S: Scalar>(p: Vec3<S>, q: Vec3<S>) -> Vec3<S> {
    let high = |p: S, q: S| if q < p { p } else { q };
    Vec3::new(high(p.x, q.x), high(p.y, q.y), high(p.z, q.z))
}
