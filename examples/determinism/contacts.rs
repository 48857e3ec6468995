//! Questions about overlapping shapes: the minimum translation, and the contact points.

use septum::contact::{Contact, Features, InteriorEdges, Part, contact, contact_in_mesh};
use septum::{Aabb, Capsule, Obb, Sphere, Triangle, Vec3};

use super::super::draw::Draw;
use super::answers::{Answers, Hash};
use super::queries::Query;

fn part(told: &mut Hash, part: Part) {
    let (kind, number) = match part {
        Part::Face(k) => (0, k),
        Part::Edge(k) => (1, k),
        Part::Vertex(k) => (2, k),
    };
    told.byte(kind);
    told.byte(number);
}

pub(super) fn tell<S: Draw, A: Answers>(
    answers: &mut A,
    [translation, points]: [Query; 2],
    found: Option<Contact<S>>,
) {
    let told = answers.to(translation);
    told.yes(found.is_some());
    let Some(found) = found else { return };
    let out = found.translation;
    told.vector(Some(out.vector));
    told.vector(Some(out.normal));
    told.number(out.depth);
    told.yes(found.is_held);
    let (kind, first, second) = match out.features {
        Features::First(k) => (0, k, 0),
        Features::Second(k) => (1, k, 0),
        Features::Edges(i, j) => (2, i, j),
        Features::Nearest(..) => (3, 0, 0),
    };
    [kind, first, second].into_iter().for_each(|byte| told.byte(byte));
    if let Features::Nearest(first, second) = out.features {
        part(told, first);
        part(told, second);
    }
    let told = answers.to(points);
    told.byte(found.points().len() as u8);
    for point in found.points() {
        told.vector(Some(point.on_first));
        told.vector(Some(point.on_second));
        told.number(point.depth);
        point.parts.into_iter().for_each(|p| part(told, p));
    }
}

/// Spheres and capsules with a triangle and boxes, some in a mesh.
#[inline(never)]
pub(super) fn round<S: Draw, A: Answers>(
    triangle: &Triangle<S>,
    aabbs: [&Aabb<S>; 2],
    [p, q, d]: [Vec3<S>; 3],
    answers: &mut A,
) {
    let [a, b, c] = *triangle.vertices();
    let all = [Query::RoundTranslation, Query::RoundPoints];
    let edges = InteriorEdges::new([true, false, true]);
    for (center, radius) in [(p, d.x), (a, q.y), (d, S::ZERO)] {
        let Ok(sphere) = Sphere::new(center, radius.size()) else { continue };
        tell(answers, all, contact(&sphere, triangle));
        tell(answers, all, contact_in_mesh(triangle, edges, &sphere));
        aabbs.iter().for_each(|&aabb| tell(answers, all, contact(aabb, &sphere)));
    }
    for (ends, radius) in [([p, d], q.x), ([a, q], d.x), ([b, c], p.y), ([q, d], S::ZERO)] {
        let Ok(capsule) = Capsule::new(ends[0], ends[1], radius.size()) else { continue };
        tell(answers, all, contact(triangle, &capsule));
        tell(answers, all, contact_in_mesh(triangle, edges, &capsule));
        aabbs.iter().for_each(|&aabb| tell(answers, all, contact(&capsule, aabb)));
    }
}

#[inline(never)]
pub(super) fn all<S: Draw, A: Answers>(
    triangle: &Triangle<S>,
    aabbs: [&Aabb<S>; 2],
    obb: Option<&Obb<S>>,
    answers: &mut A,
) {
    let of_triangle = [Query::TriangleBoxTranslation, Query::TriangleBoxPoints];
    let of_boxes = [Query::BoxBoxTranslation, Query::BoxBoxPoints];
    for aabb in aabbs {
        tell(answers, of_triangle, contact(triangle, aabb));
        // Around a vertex, so that nearly all pairs overlap.
        let (a, half) = (triangle.vertices()[0], aabb.center_half_extents());
        let Some((_, half)) = half else { continue };
        let Ok(around) = Aabb::from_center_half_extents(a, half) else { continue };
        for edges in [InteriorEdges::NONE, InteriorEdges::new([true, false, true])] {
            tell(answers, of_triangle, contact_in_mesh(triangle, edges, &around));
        }
        tell(answers, of_boxes, contact(&around, aabb));
    }
    let Some(obb) = obb else { return };
    let [u, v, w] = *obb.axes();
    tell(answers, of_triangle, contact(triangle, obb));
    tell(answers, of_boxes, contact(aabbs[0], obb));
    for (center, axes) in [(triangle.vertices()[0], [w, u, v]), (triangle.vertices()[1], [u, v, w])]
    {
        let Ok(other) = Obb::from_skewed_axes(center, axes, obb.half_extents()) else { continue };
        tell(answers, of_triangle, contact(&other, triangle));
        tell(answers, of_boxes, contact(obb, &other));
    }
}
