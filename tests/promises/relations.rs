//! Disjoint, touching or overlapping: exact. Triangles, segments and points against triangles are
//! in `flat_shapes`, two axis-aligned boxes in `small_pairs`.

use septum::relation::{Relate, Relation};
use septum::{Aabb, Triangle};
use septum_kit::boxes::BoxSet;
use septum_kit::contact::truth;
use septum_kit::fixed::types::{I4F4, I8F8, I16F16, I32F32};
use septum_kit::{Each, Oriented, Rng, Sample, Set, Touch, for_every_scalar};

/// The number of cases of each set.
const TURNED: usize = 400;

fn boxes_with_oriented_boxes<S: Sample>() {
    let mut rng = Rng::new(0x7e1);
    let mut seen = [0; 3];
    for _ in 0..200 {
        let case = BoxSet::Grid.case::<S>(&mut rng);
        let Some(relations) = case.relations() else { continue };
        let truth = case.truth();
        assert_eq!(relations, [truth.relation(); 2], "{case:?}");
        seen[truth as usize] += 1;
    }
    assert!(seen.iter().all(|&n| n > 5), "{seen:?}");
}
for_every_scalar!(boxes_with_oriented_boxes);

fn triangles_with_oriented_boxes<S: Sample>() {
    for set in BoxSet::ALL {
        let mut rng = Rng::new(0x7e5);
        let mut seen = [0; 3];
        for _ in 0..TURNED {
            if let Some(truth) = Oriented::<S>::case(set, &mut rng).check() {
                seen[truth as usize] += 1;
            }
        }
        let is_mixed = |n: &usize| *n > TURNED / 20;
        match set {
            BoxSet::Grid => assert!(seen.iter().all(is_mixed), "{seen:?}"),
            BoxSet::Turned | BoxSet::NearlyParallel => {
                assert!(is_mixed(&seen[0]) && is_mixed(&seen[2]), "{set:?}: {seen:?}");
            }
            BoxSet::Bits | BoxSet::Huge | BoxSet::Residue => {}
        }
    }
}
for_every_scalar!(triangles_with_oriented_boxes);

/// 500 times as many cases: `cargo test --release --test promises oriented_boxes_on_many --
/// --ignored --nocapture`.
#[test]
#[ignore = "takes minutes"]
fn triangles_with_oriented_boxes_on_many() {
    fn many<S: Sample>() {
        for set in BoxSet::ALL {
            let mut rng = Rng::new(0x7e6);
            let mut seen = [0; 4];
            for _ in 0..500 * TURNED {
                let truth = Oriented::<S>::case(set, &mut rng).check();
                seen[truth.map_or(3, |truth| truth as usize)] += 1;
            }
            let [apart, touching, overlapping, none] = seen;
            println!("{:6} {set:?}: {apart} {touching} {overlapping}, no box {none}", S::name());
        }
    }
    many::<f32>();
    many::<f64>();
    many::<I4F4>();
    many::<I8F8>();
    many::<I16F16>();
    many::<I32F32>();
}

fn triangles_with_boxes<S: Sample>() {
    let mut rng = Rng::new(0x7e2);
    let mut seen = [0; 3];
    let mut cases = Set::Grid.cases::<S>(0x7e2, 300);
    let bits = Touch::bits::<S>().min(12);
    cases.extend((0..200).map(|n| {
        let touch = match n % 3 {
            0 => Touch::vertex(&mut rng, bits),
            1 => Touch::edge(&mut rng, bits),
            _ => Touch::corner(&mut rng, bits),
        };
        touch.case(n % 2 == 0)
    }));
    for case in cases {
        let (triangle, aabb) = case.shapes();
        let truth = truth(&case);
        let relations = [triangle.relation(&aabb), aabb.relation(&triangle)];
        assert_eq!(relations, [truth.relation(); 2], "{case:?}");
        seen[truth as usize] += 1;
    }
    assert!(seen.iter().all(|&n| n > 30), "{seen:?}");
}
for_every_scalar!(triangles_with_boxes);

/// Arbitrary numbers: disjoint exactly if they do not overlap, and otherwise exact sums and
/// integers agree.
fn disjoint_is_not_overlapping<S: Sample>() {
    for set in [Set::Random, Set::Slivers, Set::Far, Set::Degenerate, Set::Huge] {
        for case in set.cases::<S>(0x7e3, 500) {
            let (triangle, aabb) = case.shapes();
            let relation = triangle.relation(&aabb);
            assert_eq!(relation == Relation::Disjoint, !triangle.overlaps(&aabb), "{case:?}");
        }
    }
}
for_every_scalar!(disjoint_is_not_overlapping);

#[test]
fn what_lies_on_a_face_touches() {
    let at = |p: [f64; 3]| p.each(I16F16::from_num);
    let cell = Aabb::from_min_max(at([0.0; 3]), at([1.0; 3])).unwrap();
    let floor = Aabb::from_min_max(at([0.0; 3]), at([1.0, 1.0, 0.0])).unwrap();
    let on_floor = Triangle::new(at([0.25, 0.25, 0.0]), at([0.5, 0.25, 0.0]), at([0.25, 0.5, 0.0]));
    let on_floor = on_floor.unwrap();
    assert_eq!(on_floor.relation(&cell), Relation::Touching);
    // The interior of a flat box is within its own plane.
    assert_eq!(on_floor.relation(&floor), Relation::Overlapping);
    assert_eq!(floor.relation(&cell), Relation::Touching);
    assert_eq!(floor.relation(&floor), Relation::Overlapping);
    assert!(Relation::Disjoint < Relation::Touching && Relation::Touching < Relation::Overlapping);
}
