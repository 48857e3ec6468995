//! Questions about rays and spheres, and about spheres that move.

use core::iter;

use septum::mesh::{Index, Tree};
use septum::relation::Relation;
use septum::sweep::{Motion, SphereContact, Sweep};
use septum::{Capsule, Feature, Sphere, Vec3};

use super::super::draw::Draw;
use super::answers::{Answers, Hash};
use super::pairs::middle;
use super::queries::Query;
use super::spheres::Others;

/// A feature as a byte.
pub(super) fn of_feature(feature: Option<Feature>) -> u8 {
    match feature {
        Some(Feature::Vertex(k)) => k,
        Some(Feature::Edge(k)) => 3 + k,
        Some(Feature::Interior) => 6,
        None => 0xff,
    }
}

/// The first contact, with a part as a byte.
pub(super) fn contact<S: Draw, P>(
    answer: &mut Hash,
    found: Option<SphereContact<S, P>>,
    byte: impl Fn(Option<P>) -> u8,
) {
    answer.maybe(found.as_ref().map(|first| first.t));
    found.into_iter().for_each(|first| answer.byte(byte(first.part)));
}

/// Spheres around points and rays; spheres that move past the triangle and the boxes.
#[inline(never)]
pub(super) fn spheres<S: Draw, A: Answers>(
    Others { triangle, aabbs, ray, .. }: Others<'_, S>,
    [p, q, d]: [Vec3<S>; 3],
    answers: &mut A,
) {
    let [a, b, c] = *triangle.vertices();
    let middle = middle(middle(a, b), c);
    for (center, radius) in [(p, d.x), (d, q.y), (middle, d.z), (a, q.x), (q, S::ZERO)] {
        let Ok(sphere) = Sphere::new(center, radius.size()) else { continue };
        if let Some(ray) = ray {
            let capsule = Capsule::new(center, p, sphere.radius());
            let ranges = [[Some(S::ZERO), Some(d.y.size())], [None, Some(q.x)], [None; 2]];
            let cut = ranges.iter().filter_map(|[from, to]| ray.with_range(*from, *to).ok());
            for ray in iter::once(*ray).chain(cut) {
                answers.to(Query::RaySphereRange).range(ray.t_range_sphere(&sphere));
                let answer = answers.to(Query::RayCapsuleRange);
                capsule.iter().for_each(|capsule| answer.range(ray.t_range_capsule(capsule)));
            }
        }
        for (from, to) in [(center, middle), (p, q), (b, d)] {
            let Ok(motion) = Motion::new(from, to) else { continue };
            let first = sphere.first_contact(&motion, triangle);
            contact(answers.to(Query::SphereTriangleSweep), first, of_feature);
            along(answers, sphere.relation_along(&motion, triangle));
            for aabb in aabbs {
                let first = sphere.first_contact(&motion, aabb);
                contact(answers.to(Query::SphereAabbSweep), first, |sides| {
                    sides.map_or(0xff, |[x, y, z]| (13 + x + 3 * y + 9 * z) as u8)
                });
                along(answers, sphere.relation_along(&motion, aabb));
            }
        }
    }
}

fn along<A: Answers>(answers: &mut A, relation: Relation) {
    answers.to(Query::SphereAlong).relation(relation);
}

/// Spheres that move past a mesh.
#[inline(never)]
pub(super) fn past_mesh<S: Draw, I: Index, A: Answers>(
    tree: &Tree<'_, S, I>,
    points: &[Vec3<S>; 8],
    answers: &mut A,
) {
    for (from, to, radius) in
        [(points[2], points[5], points[6].x), (points[6], points[0], points[3].y)]
    {
        let (Ok(sphere), Ok(motion)) = (Sphere::new(from, radius.size()), Motion::new(from, to))
        else {
            continue;
        };
        let first = tree.first_contact(&sphere, &motion);
        let told = answers.to(Query::MeshSphereSweep);
        told.byte(first.map_or(0xff, |(i, _)| i as u8));
        contact(told, first.map(|(_, first)| first), of_feature);
        let last = tree.last_free(&sphere, &motion);
        told.vector(last.map(|(place, _)| place));
        told.byte(last.and_then(|(_, blocker)| blocker).map_or(0xff, |i| i as u8));
    }
}
