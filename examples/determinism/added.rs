//! Questions about every fourth case.

use septum::lanes::{Aabbs, CellTriangle, Cells, Rays, Triangles};
use septum::prepared::{HitRay, HitTriangle, PreparedRay};
use septum::published;
use septum::published::akenine_moller::Order;
use septum::published::slabs::SlabRay;
use septum::published::slopes::SlopeRay;
use septum::published::stored_normal::NormalTriangle;
use septum::{Aabb, Cull, HitRules, Ray, Segment, Triangle, Vec3};

use super::super::draw::Draw;
use super::answers::Answers;
use super::queries::Query;
use super::{Four, greatest, least};

/// The orders of the groups of axes, without the default order.
const ORDERS: [Order; 5] = [
    Order::EdgesNormalFaces,
    Order::FacesEdgesNormal,
    Order::FacesNormalEdges,
    Order::NormalEdgesFaces,
    Order::NormalFacesEdges,
];

#[inline(never)]
pub(super) fn shapes<S: Draw, A: Answers>(
    triangle: &Triangle<S>,
    aabbs: [&Aabb<S>; 2],
    segments: &[Option<Segment<S>>; 2],
    answers: &mut A,
) {
    answers.to(Query::TriangleDegenerate).yes(triangle.is_degenerate());
    if let Some(normal) = S::unit_normal(triangle) {
        answers.to(Query::TriangleNormal).vector(normal);
    }
    for aabb in aabbs {
        for order in ORDERS {
            let answer = published::akenine_moller::overlaps_in(triangle, aabb, order);
            answers.to(Query::TriangleAabbOrders).yes(answer);
        }
        for segment in segments.iter().flatten() {
            answers
                .to(Query::SegmentAabbPublished)
                .yes(published::separating_axes::segment_overlaps(segment, aabb));
        }
    }
}

#[inline(never)]
pub(super) fn crossings<S: Draw, A: Answers>(
    ray: &Ray<S>,
    triangle: &Triangle<S>,
    aabbs: [&Aabb<S>; 2],
    answers: &mut A,
) {
    let of_hits = (HitRay::new(ray), HitTriangle::new(triangle));
    answers.to(Query::RayTrianglePrepared).hit(of_hits.0.hit(&of_hits.1));
    for rules in [
        HitRules::new().culling(Cull::Back),
        HitRules::new().culling(Cull::Front),
        HitRules::new().culling(Cull::Back).once(),
    ] {
        answers.to(Query::RayTriangleRules).hit(ray.hit_with(triangle, rules));
        answers.to(Query::RayTriangleIsRules).yes(ray.is_hit_with(triangle, rules));
        answers.to(Query::RayTrianglePrepared).yes(of_hits.0.is_hit_with(&of_hits.1, rules));
    }
    for cull in [Cull::Nothing, Cull::Front] {
        let t = published::stored_normal::t(
            ray,
            &NormalTriangle::new(triangle),
            cull,
            triangle.vertices()[0].x,
        );
        answers.to(Query::RayTriangleStoredT).number(t);
    }
    let (slabs, slopes) = (&SlabRay::new(ray), SlopeRay::new(ray));
    let prepared = PreparedRay::new(ray);
    for aabb in aabbs {
        answers.to(Query::RayAabbPrepared).range(prepared.t_range(aabb));
        answers
            .to(Query::RayAabbPublished)
            .yes(published::separating_axes::ray_overlaps(ray, aabb));
        answers.to(Query::RayAabbSlabs).yes(slabs.overlaps_rounded(aabb));
        answers.to(Query::RayAabbSlopesEnter).maybe(slopes.t_enter_rounded(aabb));
    }
    // Ranges between numbers that the case already has, and a range that ends at the hit.
    let Some((min, max)) = aabbs[1].min_max() else { return };
    let hit = ray.hit(triangle).map(|hit| hit.t);
    for (from, to) in [(None, hit), (Some(min.x), Some(max.x)), (Some(min.y), None)] {
        let Ok(limited) = (*ray).with_range(from, to) else { continue };
        answers.to(Query::RayTriangleLimited).hit(limited.hit(triangle));
        answers.to(Query::RayTrianglePrepared).yes(HitRay::new(&limited).is_hit(&of_hits.1));
        let prepared = PreparedRay::new(&limited);
        for aabb in aabbs {
            answers.to(Query::RayAabbPrepared).yes(prepared.overlaps(aabb));
            answers.to(Query::RayAabbLimited).range(limited.t_range(aabb));
            answers.to(Query::RayAabbCrossings).crossings(prepared.crossings(aabb), aabb);
        }
    }
}

#[inline(never)]
pub(super) fn lanes<S: Draw, A: Answers>(
    ray: &Ray<S>,
    triangle: &Triangle<S>,
    aabbs: [&Aabb<S>; 2],
    answers: &mut A,
) {
    let Some(Four { rays, .. }) = Four::new(ray, triangle) else { return };
    let rays = Rays::new(&rays);
    answers
        .to(Query::RaysTriangleMollerTrumbore)
        .hits(&rays.hit_moller_trumbore(triangle, Cull::Nothing));
    answers
        .to(Query::RaysTriangleStored)
        .hits(&rays.hit_stored_normal(&NormalTriangle::new(triangle), Cull::Back));
    let [centered, corners] = aabbs;
    let [a, b, c] = *triangle.vertices();
    let over = |p, q| Aabb::from_min_max(least(p, q), greatest(p, q)).unwrap_or(*corners);
    if let Some(aabbs) = Aabbs::new(&[*corners, over(a, b), over(b, c), over(c, a)]) {
        answers.to(Query::RayAabbsSlabs).ranges(&aabbs.t_range_rounded(&SlabRay::new(ray)));
        answers.to(Query::TriangleAabbs).verdicts(aabbs.overlaps(triangle));
    }
    let half = centered.center_half_extents().map(|(_, half)| half);
    let around = |p: Vec3<S>| {
        half.and_then(|half| Aabb::from_center_half_extents(p, half).ok()).unwrap_or(*centered)
    };
    if let Some(cells) = Cells::new(&[*centered, around(a), around(b), around(c)]) {
        let prepared = CellTriangle::new(triangle, &cells).overlaps(&cells);
        answers.to(Query::TriangleCells).verdicts(cells.overlaps(triangle));
        answers.to(Query::TriangleCells).verdicts(prepared);
    }
    let Some((p, q)) = corners.min_max() else { return };
    let of = |a, b, c| Triangle::new(a, b, c).unwrap_or(*triangle);
    let triangles = Triangles::new(&[*triangle, of(a, b, p), of(b, c, q), of(p, q, c)]);
    for aabb in aabbs {
        answers.to(Query::TrianglesAabb).verdicts(triangles.overlaps(aabb));
    }
}
