//! Moving shapes: the verdict is exact, and the time is the greatest number not above the true one.
//! A mesh's tree is in `mesh`.

mod stops;

use septum::relation::{Relate, Relation};
use septum::sweep::{FirstContact, Motion, Sweep};
use septum::{Aabb, Axis, Triangle};
use septum_kit::fixed::types::extra::{U7, U8, U64};
use septum_kit::fixed::{FixedI8, FixedI64};
use septum_kit::sweeps::{SweepCase, SweepSet};
use septum_kit::{
    BoxNumbers, Case, Each, Rng, Sample, Set, for_every_scalar, not_finite, with_every_scalar,
};

/// All sets, triangles with boxes and boxes with boxes; counts the misses, contacts at the start,
/// and contacts during the motion.
fn check<S: Sample>(cases: usize) -> [[usize; 3]; 2] {
    let mut seen = [[0; 3]; 2];
    let kind = |found: Option<FirstContact<S>>| {
        found.map_or(0, |first| 1 + usize::from(first.axis.is_some()))
    };
    for set in SweepSet::ALL {
        if matches!(set, SweepSet::Of(set) if set.misfit::<S>().is_some()) {
            continue;
        }
        for sweep in set.cases::<S>(0x5eeb, cases) {
            seen[0][kind(sweep.check())] += 1;
        }
        for sweep in set.boxes::<S>(0x5eec, cases) {
            seen[1][kind(sweep.check())] += 1;
        }
    }
    seen
}

fn agrees_with_the_oracle<S: Sample>() {
    const CASES: usize = 400;
    let seen = check::<S>(CASES);
    assert!(seen.as_flattened().iter().all(|&n| n > CASES), "{seen:?}");
}
for_every_scalar!(agrees_with_the_oracle);

/// The nearest relation, in all sets; counts the relations.
fn nearest_relations_agree<S: Sample>() {
    const CASES: usize = 200;
    let mut seen = [[0; 3]; 2];
    for set in SweepSet::ALL {
        if matches!(set, SweepSet::Of(set) if set.misfit::<S>().is_some()) {
            continue;
        }
        for sweep in set.cases::<S>(0x4e1a, CASES) {
            seen[0][sweep.check_relation() as usize] += 1;
        }
        for sweep in set.boxes::<S>(0x4e1b, CASES) {
            seen[1][sweep.check_relation() as usize] += 1;
        }
    }
    assert!(seen.as_flattened().iter().all(|&n| n > CASES / 2), "{seen:?}");
}
for_every_scalar!(nearest_relations_agree);

/// The normal of a first contact leads against the motion, and along the axis.
fn normals_lead_outward<S: Sample>() {
    let mut seen = [0; 3];
    let is_axis = |a: [f64; 3], b: [f64; 3]| (0..3).all(|i| a[i] == b[i] || a[i] == -b[i]);
    for set in [SweepSet::Of(Set::Grid), SweepSet::Of(Set::Random), SweepSet::Floor] {
        for sweep in set.cases::<S>(0x0a11, 300) {
            let ((triangle, aabb), motion) = (sweep.case.shapes(), sweep.motion());
            let Some(first) = triangle.first_contact(&motion, &aabb) else { continue };
            let back = first.normal(&motion.reversed(), &triangle);
            let approximate = |v: [S; 3]| v.each(S::approximate);
            let Some(normal) = first.normal(&motion, &triangle) else {
                assert_eq!((first.axis, back), (None, None));
                continue;
            };
            let axis = first.axis.unwrap();
            let n = approximate(normal.to_array());
            assert!(is_axis(n, approximate(axis.vector(&triangle).to_array())), "{sweep:?}");
            let [from, to] = sweep.way.each(approximate);
            let along: f64 = (0..3).map(|i| n[i] * (to[i] - from[i])).sum();
            let (n, b) = (approximate(back.unwrap().to_array()), normal.to_array());
            // Where products are short, they are exact.
            if matches!(set, SweepSet::Of(Set::Grid)) && S::WHOLE_BITS > 20 {
                assert!(along < 0.0, "{sweep:?} {along}");
                assert!((0..3).all(|i| n[i] == -b[i].approximate()), "{sweep:?}");
            }
            seen[match axis {
                Axis::Face(_) => 0,
                Axis::Normal => 1,
                Axis::Edge { .. } => 2,
            }] += 1;
        }
        for sweep in set.boxes::<S>(0x0a12, 200) {
            let ([a, b], motion) = (sweep.shapes(), sweep.motion());
            let Some(first) = a.first_contact(&motion, &b) else { continue };
            let Some(Axis::Face(i)) = first.axis else { continue };
            let (i, [from, to]) = (usize::from(i), sweep.way);
            let n = first.normal(&motion, &b).unwrap().to_array().each(S::approximate);
            assert_eq!(n[i] < 0.0, from[i] < to[i], "{sweep:?}");
            assert_eq!((n[(i + 1) % 3], n[(i + 2) % 3]), (0.0, 0.0));
        }
    }
    assert!(seen.iter().all(|&n| n > 10), "{seen:?}");
}
for_every_scalar!(normals_lead_outward);

/// Types without a number 1: the time is clamped to the range.
#[test]
fn agrees_where_there_is_no_one() {
    for seen in [check::<FixedI8<U7>>(200), check::<FixedI8<U8>>(200), check::<FixedI64<U64>>(200)]
    {
        assert!(seen.as_flattened().iter().all(|&n| n > 200), "{seen:?}");
    }
    let near = FixedI8::<U7>::from_num;
    let at = |x: f64| [near(x), near(0.0), near(0.0)];
    let point = |x: f64| Aabb::from_min_max(at(x), at(x)).unwrap();
    let motion = Motion::new(at(-0.5), at(0.25)).unwrap();
    let first = point(-0.5).first_contact(&motion, &point(0.25)).unwrap();
    assert_eq!(first, FirstContact { t: FixedI8::MAX, axis: Some(Axis::Face(0)) });
}

/// A hundred times as many cases: `cargo test --release --test promises sweep -- --ignored`.
#[test]
#[ignore = "takes minutes"]
fn agrees_with_the_oracle_on_many() {
    fn many<S: Sample>() {
        println!("{:8} {:?}", S::name(), check::<S>(91_000));
    }
    with_every_scalar!(many);
}

/// Without motion the answer is that at rest, and contacts are at the start.
fn no_way_is_rest<S: Sample>() {
    for set in [Set::Grid, Set::Touch, Set::Degenerate] {
        for case in set.cases::<S>(0x5eed, 300) {
            let (triangle, aabb) = case.shapes();
            let p = case.vertices[0];
            let rest = Motion::new(p, p).unwrap();
            let meets = triangle.relation(&aabb) != Relation::Disjoint;
            let expected = meets.then_some(FirstContact { t: S::ZERO, axis: None });
            assert_eq!(triangle.first_contact(&rest, &aabb), expected, "{case:?}");
            assert_eq!(aabb.meets_along(&rest, &triangle), meets, "{case:?}");
        }
    }
}
for_every_scalar!(no_way_is_rest);

/// Boxes of any size, from one side of a thin wall to the other, by any motion.
fn nothing_passes_a_wall<S: Sample>() {
    let mut rng = Rng::new(0x3a11);
    let near = |p: [f64; 3]| p.each(S::nearest);
    let wall =
        Triangle::new(near([-7.5, -7.5, -0.5]), near([7.5, -7.5, 0.5]), near([0.0, 7.5, 0.25]));
    let wall = wall.unwrap();
    for _ in 0..2_000 {
        let half = [2_f64.powf(rng.real(-8.0, 0.0)); 3];
        let mut side = |z: f64| near([rng.real(-2.0, 2.0), rng.real(-2.0, 2.0), z]);
        let (from, to) = (side(4.0), side(-4.0));
        let bullet = Aabb::from_center_half_extents(from, near(half)).unwrap();
        let shot = Motion::new(from, to).unwrap();
        let first = bullet.first_contact(&shot, &wall);
        assert!(first.is_some_and(|first| first.t > S::ZERO), "{bullet:?} {shot:?}");
        // On this side of the wall they meet nothing.
        let along = Motion::new(from, [to[0], to[1], from[2]]).unwrap();
        assert!(!bullet.meets_along(&along, &wall), "{bullet:?} {along:?}");
    }
}
for_every_scalar!(nothing_passes_a_wall);

/// Along one axis all differences overflow in floats; along the others all is near.
fn nothing_is_lost_at_the_ends_of_the_range<S: Sample>() {
    let mut rng = Rng::new(0xe4d5);
    let far = |share: f64| S::nearest(S::GREATEST.approximate() * share);
    let near = [0.0, 0.25, 7.5].each(S::nearest);
    let mut seen = [0; 3];
    for _ in 0..3_000 {
        let axis = rng.below(3);
        let side = if rng.below(2) == 0 { 1.0 } else { -1.0 };
        let mut point = |shares: [f64; 3]| {
            let mut point = rng.triple(|rng| near[rng.below(3)]);
            point[axis] = far(shares[rng.below(3)]);
            point
        };
        let vertices = [(); 3].each(|()| point([side, 0.9 * side, 0.95 * side]));
        let center = point([-side, -0.9 * side, -0.8 * side]);
        let half = point([0.99, 0.7, 0.2]);
        let way = [point([0.8 * side; 3]), point([0.0, -0.2 * side, 0.9 * side])];
        let case = Case { vertices, aabb: BoxNumbers::Center(center, half) };
        let sweep = SweepCase { case, way };
        seen[sweep.check_relation() as usize] += 1;
        sweep.check();
    }
    assert!(seen[0] > 100 && seen[1] + seen[2] > 100, "{seen:?}");
}
for_every_scalar!(nothing_is_lost_at_the_ends_of_the_range);

#[test]
fn a_motion_is_of_numbers() {
    let bad = Motion::new([0.0_f32; 3], [0.0, f32::NAN, 0.0]);
    assert_eq!(bad, Err(not_finite("to", None)));
    let bad = Motion::new([f64::INFINITY, 0.0, 0.0], [0.0; 3]);
    assert_eq!(bad, Err(not_finite("from", None)));
}
