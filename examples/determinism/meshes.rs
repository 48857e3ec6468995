//! Questions about a mesh and its tree: three closed surfaces that intersect each other.

use core::ops::ControlFlow;

use septum::broad_phase::BoxTree;
use septum::contact::{InteriorEdges, Shape};
use septum::mesh::{Mesh, Node, Probe, Tree};
use septum::sweep::Motion;
use septum::{Aabb, HitRules, Obb, Ray, Segment, Triangle, Vec3};

use super::super::draw::Draw;
use super::answers::Answers;
use super::contacts::tell;
use super::moving::past_mesh;
use super::queries::Query;
use super::spheres::closest;
use super::{greatest, least};

/// A cuboid, an octahedron and a tetrahedron, by their corners among eight points.
const FACES: [[u16; 3]; 24] = [
    [0, 2, 1],
    [1, 2, 3],
    [4, 5, 6],
    [5, 7, 6],
    [0, 1, 4],
    [1, 5, 4],
    [2, 6, 3],
    [3, 6, 7],
    [0, 4, 2],
    [2, 4, 6],
    [1, 3, 5],
    [3, 7, 5],
    [2, 4, 6],
    [4, 3, 6],
    [3, 5, 6],
    [5, 2, 6],
    [4, 2, 7],
    [3, 4, 7],
    [5, 3, 7],
    [2, 5, 7],
    [0, 6, 1],
    [0, 1, 7],
    [0, 7, 6],
    [1, 6, 7],
];

/// The shapes in the questions about a mesh.
pub(super) struct Shapes<'a, S> {
    pub(super) aabbs: [&'a Aabb<S>; 2],
    pub(super) obb: Option<&'a Obb<S>>,
    pub(super) triangle: &'a Triangle<S>,
    pub(super) segments: &'a [Option<Segment<S>>; 2],
    pub(super) ray: Option<&'a Ray<S>>,
}

#[inline(never)]
pub(super) fn all<S: Draw, A: Answers>(
    points: &[Vec3<S>; 8],
    shapes: &Shapes<'_, S>,
    answers: &mut A,
) {
    let (mut nodes, mut order) = ([Node::EMPTY; Node::count_for(24)], [0; 24]);
    let tree = Mesh::new(points, &FACES).and_then(|m| Tree::build(m, &mut nodes, &mut order));
    let Ok(tree) = tree else { return answers.to(Query::ShapesAccepted).byte(0xff) };
    let told = answers.to(Query::MeshOverlapping);
    shapes.aabbs.iter().for_each(|aabb| told.set(tree.overlapping(*aabb)));
    shapes.obb.into_iter().for_each(|obb| told.set(tree.overlapping(obb)));
    told.set(tree.overlapping(shapes.triangle));
    shapes.segments.iter().flatten().for_each(|segment| told.set(tree.overlapping(segment)));

    let (mut nodes, mut order) = ([Node::EMPTY], [0]);
    let other = Mesh::new(shapes.triangle.vertices(), &[[0_u16, 1, 2]]);
    if let Ok(other) = other.and_then(|m| Tree::build(m, &mut nodes, &mut order)) {
        let mut pairs = 0_u32;
        let _ = tree.overlapping_pairs(&other, |i, _| {
            pairs ^= 1 << (i % 32);
            ControlFlow::<()>::Continue(())
        });
        let told = answers.to(Query::MeshPairs);
        pairs.to_le_bytes().into_iter().for_each(|byte| told.byte(byte));
        let told = answers.to(Query::MeshCrossings);
        let _ = tree.crossings(&other, |i, _, segment| {
            told.byte(i as u8);
            told.segment(Some(segment));
            ControlFlow::<()>::Continue(())
        });
    }

    let interior = core::array::from_fn(|i| InteriorEdges::new([0, 1, 2].map(|k| i >> k & 1 == 1)));
    for aabb in shapes.aabbs {
        contacts(&tree, aabb, &interior, answers);
    }
    if let Some(obb) = shapes.obb {
        contacts(&tree, obb, &interior, answers);
    }

    if let Some(ray) = shapes.ray {
        let first = tree.first_hit(ray);
        let told = answers.to(Query::MeshFirstHit);
        told.byte(first.map_or(0xff, |(i, _)| i as u8));
        told.hit(first.map(|(_, hit)| hit));
        let first =
            tree.first_hit_where(ray, HitRules::new(), |i, hit| i % 3 != 0 && hit.u < hit.v);
        let told = answers.to(Query::MeshFirstWhere);
        told.byte(first.map_or(0xff, |(i, _)| i as u8));
        told.hit(first.map(|(_, hit)| hit));
        for rules in [HitRules::new(), HitRules::new().once()] {
            answers.to(Query::MeshHits).set(tree.hits_with(ray, rules).map(|(i, _)| i));
        }
    }

    moving_boxes(points, shapes, answers);
    past_mesh(&tree, points, answers);
    for (aabb, from, to) in
        [(shapes.aabbs[0], points[2], points[5]), (shapes.aabbs[1], points[6], points[0])]
    {
        let Ok(motion) = Motion::new(from, to) else { continue };
        let first = tree.first_contact(aabb, &motion);
        let told = answers.to(Query::MeshSweep);
        told.byte(first.map_or(0xff, |(i, _)| i as u8));
        told.contact(first.map(|(_, first)| first));
        let last = tree.last_free(aabb, &motion);
        let told = answers.to(Query::MeshLastFree);
        told.vector(last.map(|(place, _)| place));
        told.byte(last.and_then(|(_, blocker)| blocker).map_or(0xff, |i| i as u8));
        let first =
            tree.first_contact_where(aabb, &motion, |i, first| i % 3 != 0 && first.axis.is_some());
        let told = answers.to(Query::MeshSweepWhere);
        told.byte(first.map_or(0xff, |(i, _)| i as u8));
        told.contact(first.map(|(_, first)| first));
    }

    let middle =
        |p: Vec3<S>, q: Vec3<S>| Vec3::new(p.x.middle(q.x), p.y.middle(q.y), p.z.middle(q.z));
    let center = middle(middle(points[0], points[7]), middle(points[3], points[4]));
    let near = tree.closest_point(center);
    answers.to(Query::MeshClosest).byte(near.map_or(0xff, |(i, _)| i as u8));
    closest(answers, Query::MeshClosest, near.map(|(_, closest)| closest));
    for point in [points[0], middle(points[0], points[7]), center, middle(center, points[6])] {
        let winding = tree.winding(point).map_or(0x7f, |winding| winding as i8 as u8);
        answers.to(Query::MeshWinding).byte(winding);
        answers.to(Query::MeshSignedDistance).maybe(tree.signed_distance_squared(point));
    }
}

#[inline(never)]
fn contacts<S: Draw, A: Answers>(
    tree: &Tree<'_, S, u16>,
    shape: &(impl Probe<S> + Shape<S>),
    interior: &[InteriorEdges; FACES.len()],
    answers: &mut A,
) {
    for (i, contact) in tree.contacts(shape, interior).into_iter().flatten() {
        answers.to(Query::MeshTranslations).byte(i as u8);
        tell(answers, [Query::MeshTranslations, Query::MeshPoints], Some(contact));
    }
}

/// Ten boxes in a tree: built anew, and in the order of a tree over other boxes.
#[inline(never)]
fn moving_boxes<S: Draw, A: Answers>(
    points: &[Vec3<S>; 8],
    shapes: &Shapes<'_, S>,
    answers: &mut A,
) {
    const COUNT: usize = 10;
    let given = shapes.aabbs;
    let of = |step: usize| {
        core::array::from_fn::<_, COUNT, _>(|k| {
            let (p, q) = (points[k % 8], points[(k + step) % 8]);
            let between = Aabb::from_min_max(least(p, q), greatest(p, q));
            if k < 8 { between.unwrap_or(*given[1]) } else { *given[k - 8] }
        })
    };
    let (before, boxes) = (of(1), of(3));
    let (mut nodes, mut order) = ([Node::EMPTY; Node::count_for(COUNT)], [0_u16; COUNT]);
    for is_built in [false, true] {
        let tree = if is_built {
            BoxTree::build(&boxes, &mut nodes, &mut order)
        } else {
            let _ = BoxTree::build(&before, &mut nodes, &mut order);
            BoxTree::refit(&boxes, &mut nodes, &order)
        };
        let Ok(tree) = tree else { return answers.to(Query::ShapesAccepted).byte(0xfe) };
        let told = answers.to(Query::BoxesOverlapping);
        let mut pairs = [[0; 2]; COUNT * (COUNT - 1) / 2];
        let pairs = tree.pairs(&mut pairs).unwrap_or_default();
        pairs.as_flattened().iter().for_each(|&i| told.byte(i as u8));
        let mut found = [0; COUNT];
        for aabb in given {
            told.set(
                tree.overlapping(aabb, &mut found).unwrap_or_default().iter().map(|&i| i.into()),
            );
        }
        let by_triangle = tree.overlapping(shapes.triangle, &mut found).unwrap_or_default();
        told.set(by_triangle.iter().map(|&i| i.into()));

        let told = answers.to(Query::BoxesFirst);
        if let Some(ray) = shapes.ray {
            let first = tree.first_hit(ray, |_| true);
            told.byte(first.map_or(0xff, |(i, _)| i as u8));
            told.maybe(first.map(|(_, t)| t));
        }
        if let Ok(motion) = Motion::new(points[2], points[5]) {
            let first = tree.first_contact(given[0], &motion, |i| i != 8);
            told.byte(first.map_or(0xff, |(i, _)| i as u8));
            told.contact(first.map(|(_, first)| first));
        }
    }
}
