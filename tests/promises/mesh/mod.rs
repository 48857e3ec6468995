//! A tree gives the answers of all triangles, one by one; a closed mesh contains the points that it
//! winds about.

mod closedness;
mod closest;
mod edges;
mod owned;
mod scenes;
mod sweeps;
mod tables;

use core::ops::ControlFlow;

use septum::contact::{InteriorEdges, Shape, contact_in_mesh};
use septum::mesh::{Mesh, MeshError, Probe, Tree};
use septum::{Aabb, Capsule, Cull, Hit, HitRules, Obb, Ray, Segment, Sphere, Triangle};
use septum_kit::{Each, Rng, Sample, for_scalars, rays, sorted_by_number, three};

use self::closest::points_are_closest_as_one_by_one;
use self::edges::{contacts_are_the_first, hits_are_in_true_order};
use self::owned::owned_trees_answer_as_borrowed;
use self::scenes::Scene;
use self::sweeps::{boxes_meet_first_as_one_by_one, spheres_meet_first_as_one_by_one};

fn sorted(found: impl Iterator<Item = usize>) -> Vec<usize> {
    sorted_by_number(found, |&i| i)
}

/// A number for each pair, in order.
fn pair_number(&(i, k): &(usize, usize)) -> usize {
    i << 16 | k
}

/// The triangles that satisfy `is`, tested one by one.
fn those<S: Sample>(mesh: Mesh<'_, S, u16>, is: impl Fn(&Triangle<S>) -> bool) -> Vec<usize> {
    mesh.iter().enumerate().filter(|(_, triangle)| is(triangle)).map(|(i, _)| i).collect()
}

/// Boxes around points of the scene, by corners and by centre, and oriented.
fn boxes<S: Sample>(scene: &Scene<S>, rng: &mut Rng) -> (Vec<Aabb<S>>, Vec<Obb<S>>) {
    let (mut aabbs, mut obbs) = (Vec::new(), Vec::new());
    for _ in 0..30 {
        let (p, q) = (scene.point(rng), scene.point(rng));
        let (min, max) = (three(|i| least(p[i], q[i])), three(|i| greatest(p[i], q[i])));
        let most = scene.size * [0.0, 0.02, 0.3, 2.0][rng.below(4)];
        let half = rng.triple(|rng| S::nearest(most * rng.real(0.0, 1.0)));
        aabbs
            .extend([Aabb::from_min_max(min, max), Aabb::from_min_max(p, p)].into_iter().flatten());
        aabbs.extend(Aabb::from_center_half_extents(p, half));
        let axes = [(); 3].each(|()| rng.triple(|rng| S::nearest(rng.whole(-4, 4) as f64 / 4.0)));
        obbs.extend(Obb::from_skewed_axes(p, axes, half));
    }
    (aabbs, obbs)
}

fn least<S: PartialOrd>(a: S, b: S) -> S {
    if b < a { b } else { a }
}

fn greatest<S: PartialOrd>(a: S, b: S) -> S {
    if b > a { b } else { a }
}

fn boxes_overlap_as_one_by_one<S: Sample>() {
    let (mut rng, mut count, mut contacts) = (Rng::new(81), 0, 0);
    for mut scene in scenes::all::<S>() {
        let (aabbs, obbs) = boxes(&scene, &mut rng);
        let (name, mesh) = (scene.name, scene.mesh().vertices().len());
        let tree = scene.tree();
        assert_eq!(tree.mesh().vertices().len(), mesh);
        for aabb in &aabbs {
            let expected = those(*tree.mesh(), |t| t.overlaps(aabb));
            assert_eq!(sorted(tree.overlapping(aabb)), expected, "{name}: {aabb:?}");
            contacts += contacts_as_one_by_one(&tree, aabb, &expected);
            count += expected.len();
        }
        for obb in &obbs {
            let expected = those(*tree.mesh(), |t| t.overlaps(obb));
            assert_eq!(sorted(tree.overlapping(obb)), expected, "{name}: {obb:?}");
            contacts += contacts_as_one_by_one(&tree, obb, &expected);
            count += expected.len();
        }
    }
    assert!(count > 5_000 && contacts > 2_000, "{count} {contacts}");
}

/// The contacts of a shape that overlaps these triangles, each as of its triangle alone. Returns
/// their number.
fn contacts_as_one_by_one<S: Sample>(
    tree: &Tree<'_, S, u16>,
    shape: &(impl Probe<S> + Shape<S>),
    overlapping: &[usize],
) -> usize {
    let interior = |i: usize| InteriorEdges::new(three(|k| i >> k & 1 == 1));
    let edges: Vec<_> = (0..tree.mesh().triangles().len()).map(interior).collect();
    let found = sorted_by_number(tree.contacts(shape, &edges).expect("as many edges"), |c| c.0);
    let alone = |&i: &usize| {
        let triangle = tree.mesh().triangle(i).expect("it overlaps");
        Some((i, contact_in_mesh(&triangle, interior(i), shape)?))
    };
    let expected: Vec<_> = overlapping.iter().filter_map(alone).collect();
    // By text, because an infinite box has a NaN among its points.
    assert_eq!(format!("{found:?}"), format!("{expected:?}"));
    if let Some(less) = edges.len().checked_sub(1) {
        let refused = tree.contacts(shape, &edges[..less]).err();
        assert_eq!(refused, Some(MeshError::Length { needed: edges.len() }));
    }
    found.len()
}

/// Triangles, segments, spheres and capsules between points of the scene, of all sizes.
fn other_shapes_overlap_as_one_by_one<S: Sample>() {
    let (mut rng, mut count) = (Rng::new(87), [0; 4]);
    for mut scene in scenes::all::<S>() {
        let points: Vec<_> = (0..40).map(|_| [(); 3].each(|()| scene.point(&mut rng))).collect();
        let most = scene.size;
        let name = scene.name;
        let tree = scene.tree();
        for [a, b, c] in points {
            let triangle = Triangle::new(a, b, c).expect("finite");
            let expected = those(*tree.mesh(), |t| t.overlaps(&triangle));
            assert_eq!(sorted(tree.overlapping(&triangle)), expected, "{name}: {triangle:?}");
            count[0] += expected.len();
            let half = rng.triple(|rng| S::nearest(most * rng.real(-1.0, 1.0)));
            let segments = [Segment::new(a, b), Segment::from_center_half_vector(a, half)];
            for segment in segments.each(|segment| segment.expect("finite")) {
                let expected = those(*tree.mesh(), |t| segment.overlaps(t));
                assert_eq!(sorted(tree.overlapping(&segment)), expected, "{name}: {segment:?}");
                count[1] += expected.len();
            }
            let radius = if half[0] < S::ZERO { S::ZERO } else { half[0] };
            let sphere = Sphere::new(a, radius).expect("finite");
            let expected = those(*tree.mesh(), |t| sphere.overlaps(t));
            assert_eq!(sorted(tree.overlapping(&sphere)), expected, "{name}: {sphere:?}");
            count[2] += expected.len();
            let capsule = Capsule::new(a, b, radius).expect("finite");
            let expected = those(*tree.mesh(), |t| capsule.overlaps(t));
            assert_eq!(sorted(tree.overlapping(&capsule)), expected, "{name}: {capsule:?}");
            count[3] += expected.len();
        }
    }
    assert!(count.iter().all(|&n| n > 1_000), "{count:?}");
}

/// Two scenes; each pair of triangles is visited once.
fn meshes_overlap_as_pair_by_pair<S: Sample>() {
    let (mut count, mut crossings) = (0, 0);
    let mut scenes = scenes::all::<S>();
    scenes.retain(|scene| scene.faces.len() < 1_000);
    for k in 0..scenes.len() {
        let (first, second) = scenes.split_at_mut(k);
        let tree = second[0].tree();
        for with in first {
            let name = with.name;
            let other = with.tree();
            let mut found = Vec::new();
            let flow = tree.overlapping_pairs(&other, |i, k| {
                found.push((i, k));
                ControlFlow::<()>::Continue(())
            });
            assert!(flow.is_continue());
            let found = sorted_by_number(found, pair_number);
            let pairs = tree.mesh().iter().enumerate().flat_map(|(i, t)| {
                those(*other.mesh(), |u| t.overlaps(u)).into_iter().map(move |k| (i, k))
            });
            assert_eq!(found, pairs.collect::<Vec<_>>(), "{name}");
            count += found.len();
            let mut segments = Vec::new();
            let flow = tree.crossings(&other, |i, k, segment| {
                segments.push((i, k, segment));
                ControlFlow::<()>::Continue(())
            });
            assert!(flow.is_continue());
            let segments = sorted_by_number(segments, |&(i, k, _)| pair_number(&(i, k)));
            let crossing = |&(i, k): &(usize, usize)| {
                let of = |mesh: &Mesh<'_, S, u16>, i: usize| mesh.triangle(i).expect("it overlaps");
                Some((i, k, of(tree.mesh(), i).crossing(&of(other.mesh(), k))?))
            };
            assert_eq!(segments, found.iter().filter_map(crossing).collect::<Vec<_>>(), "{name}");
            crossings += segments.len();
            // It ends when the visitor breaks.
            let first = tree.overlapping_pairs(&other, |i, k| ControlFlow::Break((i, k)));
            assert_eq!(first.is_break(), !found.is_empty());
        }
    }
    assert!(count > 1_000 && crossings > 500, "{count} {crossings}");
}

/// Rays between points of the scene, along axes, and from far away, some with a limited range.
fn rays_of<S: Sample>(scene: &Scene<S>, rng: &mut Rng) -> Vec<Ray<S>> {
    let mut rays = Vec::new();
    for k in 0..150 {
        let (o, to) = (scene.point(rng), scene.point(rng));
        let mut direction = three(|i| S::nearest((to[i].approximate() - o[i].approximate()) / 2.0));
        for d in &mut direction {
            if rng.one_in(4) {
                *d = S::ZERO;
            }
        }
        let Ok(ray) = Ray::new(o, direction) else { continue };
        let t = S::nearest(rng.real(0.0, 4.0));
        let before = S::nearest(-t.approximate());
        rays.extend(match k % 4 {
            0 => ray.with_range(None, None),
            1 => ray.with_range(before, t),
            2 => ray.with_range(S::ZERO, t),
            _ => Ok(ray),
        });
    }
    rays
}

fn rays_hit_as_one_by_one<S: Sample>() {
    let (mut rng, mut count) = (Rng::new(82), [0; 3]);
    let all_rules = [HitRules::new(), HitRules::new().once(), HitRules::new().culling(Cull::Back)];
    for mut scene in scenes::all::<S>() {
        let rays = rays_of(&scene, &mut rng);
        let name = scene.name;
        let tree = scene.tree();
        let mesh = *tree.mesh();
        for (k, ray) in rays.iter().enumerate() {
            let rules = all_rules[k % 3];
            let expected: Vec<_> = mesh
                .iter()
                .enumerate()
                .filter_map(|(i, t)| ray.hit_with(&t, rules).map(|hit| (i, hit)))
                .collect();
            let found = sorted_by_number(tree.hits_with(ray, rules), |hit| hit.0);
            assert_eq!(found, expected, "{name}: {ray:?}");
            assert_eq!(tree.is_hit_with(ray, rules), !expected.is_empty(), "{name}: {ray:?}");
            // The first in true order; at one point, the lowest index in the mesh.
            let of = |i: usize| mesh.triangle(i).expect("it was hit");
            let sooner = |a: (usize, Hit<S>), b: (usize, Hit<S>)| {
                let order = ray.compare_hits(&of(a.0), &of(b.0)).expect("both are hit");
                if order.is_gt() { b } else { a }
            };
            let first = expected.iter().copied().reduce(sooner);
            assert_eq!(tree.first_hit_with(ray, rules), first, "{name}: {ray:?}");
            // Of those that a predicate accepts: a third of the triangles pass, or one half of each.
            for half in [false, true] {
                let accepts = |i: usize, hit: &Hit<S>| {
                    if half { hit.u < hit.v } else { (i + k) % 3 == 0 }
                };
                let accepted = expected.iter().copied().filter(|(i, hit)| accepts(*i, hit));
                let first = accepted.reduce(sooner);
                let found = tree.first_hit_where(ray, rules, accepts);
                assert_eq!(found, first, "{name}: {ray:?}");
                count[2] += usize::from(first.is_some());
            }
            count[0] += expected.len();
            count[1] += usize::from(expected.len() > 1);
        }
    }
    assert!(count[0] > 1_000 && count[1] > 200 && count[2] > 200, "{count:?}");
}

/// Compares a tree's answer with the oracle.
fn check_winding<S: Sample>(
    tree: &Tree<'_, S, u16>,
    name: &str,
    p: [S; 3],
    rng: &mut Rng,
) -> Option<i32> {
    let triangles: Vec<_> =
        tree.mesh().iter().map(|t| t.vertices().each(|v| v.to_array())).collect();
    let expected = rays::winding(&triangles, p, rng);
    assert_eq!(tree.winding(p), expected, "{name}: {p:?}");
    let is_inside = expected.is_none_or(|winding| winding % 2 != 0);
    assert_eq!(tree.contains(p), is_inside, "{name}: {p:?}");
    expected
}

fn closed_meshes_contain_what_they_wind_about<S: Sample>() {
    let (mut rng, mut count) = (Rng::new(83), [0; 3]);
    for mut scene in scenes::closed::<S>() {
        let points: Vec<_> = (0..120).map(|_| scene.point(&mut rng)).collect();
        let name = scene.name;
        let tree = scene.tree();
        for p in points {
            match check_winding(&tree, name, p, &mut rng) {
                None => count[0] += 1,
                Some(0) => count[1] += 1,
                Some(_) => count[2] += 1,
            }
        }
    }
    assert!(count.iter().all(|&n| n > 10), "on, outside, inside: {count:?}");
}

#[test]
fn nothing_contains_a_point_that_is_none() {
    let mut scene = scenes::closed::<f32>().swap_remove(0);
    let tree = scene.tree();
    assert!(tree.contains([0.0; 3]));
    for bad in [f32::NAN, f32::INFINITY, f32::NEG_INFINITY] {
        assert!(!tree.contains([0.0, bad, 0.0]));
        assert_eq!(tree.winding([bad, 0.0, 0.0]), Some(0));
    }
}

// Not in all scalars, because compiling takes longer than testing: the hashes ask in those too.
for_scalars!(
    [
        f32: f32,
        f64: f64,
        i16f16: fixed::types::I16F16,
        i32f32: fixed::types::I32F32,
    ]
    boxes_overlap_as_one_by_one,
    other_shapes_overlap_as_one_by_one,
    meshes_overlap_as_pair_by_pair,
    rays_hit_as_one_by_one,
    closed_meshes_contain_what_they_wind_about,
    points_are_closest_as_one_by_one,
    boxes_meet_first_as_one_by_one,
    spheres_meet_first_as_one_by_one,
    hits_are_in_true_order,
    contacts_are_the_first,
    owned_trees_answer_as_borrowed,
);
