//! Boxes and spheres that move past a mesh.

use septum::relation::Relation;
use septum::sweep::{FirstContact, Motion, Sweep};
use septum::{Aabb, Sphere};
use septum_kit::{Rng, Sample};

use super::{boxes, scenes};

/// Boxes of all sizes that move between points of the scene; some move along an axis, and some not
/// at all.
pub(super) fn boxes_meet_first_as_one_by_one<S: Sample>() {
    let (mut rng, mut count) = (Rng::new(95), [0; 4]);
    for mut scene in scenes::all::<S>() {
        let (mut aabbs, _) = boxes(&scene, &mut rng);
        aabbs.truncate(60);
        // Beyond the numbers of the scalar.
        let far = Aabb::from_center_half_extents([S::GREATEST; 3], [S::nearest(20.0); 3]);
        aabbs.extend(far);
        let moves: Vec<_> = aabbs
            .into_iter()
            .map(|aabb| {
                let (from, mut to) = (scene.point(&mut rng), scene.point(&mut rng));
                for i in 0..3 {
                    if rng.one_in(4) {
                        to[i] = from[i];
                    }
                }
                (aabb, Motion::new(from, to).expect("finite"))
            })
            .collect();
        let name = scene.name;
        let tree = scene.tree();
        for (aabb, motion) in &moves {
            let all = tree.mesh().iter().enumerate();
            let all = all.filter_map(|(i, t)| Some((i, aabb.first_contact(motion, &t)?)));
            type Found<S> = (usize, FirstContact<S>);
            let sooner = |a: Found<S>, b: Found<S>| if b.1.t < a.1.t { b } else { a };
            let all: Vec<_> = all.inspect(|_| count[0] += 1).collect();
            let first = all.iter().copied().reduce(sooner);
            assert_eq!(tree.first_contact(aabb, motion), first, "{name}: {aabb:?} {motion:?}");
            // Of those that a predicate accepts.
            let accepts = |i: usize, first: &FirstContact<S>| first.axis.is_some() && i % 3 != 0;
            let accepted = all.iter().copied().filter(|(i, first)| accepts(*i, first));
            let found = tree.first_contact_where(aabb, motion, accepts);
            let expected = accepted.reduce(sooner);
            assert_eq!(found, expected, "{name}: {aabb:?} {motion:?}");
            count[3] += usize::from(expected.is_some());
            count[1] += usize::from(first.is_some());
            count[2] += usize::from(first.is_some_and(|(_, first)| first.t > S::ZERO));
        }
    }
    assert!(count[0] > 2_000 && count[1] > 200 && count[2] > 40 && count[3] > 40, "{count:?}");
}

/// Spheres of all sizes, likewise; and the place where each stops.
pub(super) fn spheres_meet_first_as_one_by_one<S: Sample>() {
    let (mut rng, mut count) = (Rng::new(96), [0; 3]);
    for mut scene in scenes::all::<S>() {
        let spheres: Vec<_> = (0..25)
            .map(|k| {
                let (from, mut to) = (scene.point(&mut rng), scene.point(&mut rng));
                if k % 4 == 0 {
                    to[k / 4 % 3] = from[k / 4 % 3];
                }
                let most = scene.size * [0.0, 0.02, 0.1, 0.3][rng.below(4)];
                let sphere = Sphere::new(from, S::nearest(most * rng.real(0.0, 1.0)));
                (sphere.expect("a sphere"), Motion::new(from, to).expect("finite"))
            })
            .collect();
        let name = scene.name;
        let tree = scene.tree();
        for (sphere, motion) in &spheres {
            let all = tree.mesh().iter().enumerate();
            let all = all.filter_map(|(i, t)| Some((i, sphere.first_contact(motion, &t)?)));
            let first = all.reduce(|a, b| if b.1.t < a.1.t { b } else { a });
            assert_eq!(tree.first_contact(sphere, motion), first, "{name}: {sphere:?} {motion:?}");
            count[0] += usize::from(first.is_some());
            count[1] += usize::from(first.is_some_and(|(_, first)| first.part.is_some()));

            let is_free = |way: &Motion<S>| {
                let relation = |t| sphere.relation_along(way, &t);
                tree.mesh().iter().all(|t| relation(t) < Relation::Overlapping)
            };
            let is_right = match tree.last_free(sphere, motion) {
                None => !is_free(&Motion::new(motion.from(), motion.from()).expect("finite")),
                Some((place, None)) => place == motion.to() && is_free(motion),
                Some((place, Some(_))) => {
                    count[2] += 1;
                    !is_free(motion) && is_free(&Motion::new(motion.from(), place).expect("finite"))
                }
            };
            assert!(is_right, "{name}: {sphere:?} {motion:?}");
        }
    }
    assert!(count[0] > 80 && count[1] > 40 && count[2] > 20, "{count:?}");
}
