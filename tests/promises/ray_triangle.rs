//! `ray.hit` gives the exact answer: on every set, in every scalar, and on numbers of any
//! magnitude, compared with the intersection in fractions.

use core::cmp::Ordering;

use fixed::types::{I1F15, I4F4, I16F0, I33F31};
use proptest::prelude::*;
use septum::prepared::{HitRay, HitTriangle};
use septum::{Cull, Facing, Feature, HitRules};
use septum_kit::rays::{RayCase, RaySet, crossing};
use septum_kit::{Rng, Sample, for_every_scalar, three};

/// All exact queries about one case, compared with the oracle.
fn check<S: Sample>(case: &RayCase<S>) {
    let (ray, triangle, truth) = (case.ray(), case.triangle(), crossing(case));
    let met = |hit: &septum::Hit<S>| (hit.facing, hit.feature);
    let expected = truth.as_ref().map(|truth| (truth.facing, truth.feature));
    let hit = ray.hit(&triangle);
    assert_eq!(hit.as_ref().map(met), expected, "{case:?}");
    assert_eq!(ray.is_hit(&triangle), expected.is_some(), "hits: {case:?}");
    let prepared = (HitRay::new(&ray), HitTriangle::new(&triangle));
    assert_eq!(prepared.0.hit(&prepared.1), hit, "prepared: {case:?}");
    assert_eq!(prepared.0.is_hit(&prepared.1), hit.is_some(), "prepared: {case:?}");

    for (cull, kept) in [(Cull::Back, Facing::Front), (Cull::Front, Facing::Back)] {
        let rules = HitRules::new().culling(cull);
        let expected = hit.filter(|hit| hit.facing == kept);
        assert_eq!(ray.hit_with(&triangle, rules), expected, "{cull:?}: {case:?}");
        assert_eq!(ray.is_hit_with(&triangle, rules), expected.is_some(), "{cull:?}: {case:?}");
        let is_hit = prepared.0.is_hit_with(&prepared.1, rules);
        assert_eq!(is_hit, expected.is_some(), "prepared, {cull:?}: {case:?}");
        let hit = prepared.0.hit_with(&prepared.1, rules);
        assert_eq!(hit, expected, "prepared, {cull:?}: {case:?}");
    }

    // A hit that counts once is a hit, and a hit in the interior always counts.
    let once = ray.hit_once(&triangle);
    let rules = HitRules::new().once();
    assert_eq!(once.is_some(), ray.is_hit_with(&triangle, rules), "{case:?}");
    assert_eq!(once, prepared.0.hit_with(&prepared.1, rules), "prepared, once: {case:?}");
    assert_eq!(once.is_some(), prepared.0.is_hit_with(&prepared.1, rules), "{case:?}");
    assert!(once.is_none() || once == hit, "once: {case:?}");
    if let Some(truth) = truth {
        let is_end = |end: Option<S>| end.is_some_and(|x| truth.t.compare(x) == Ordering::Equal);
        let is_tie = truth.feature != Feature::Interior || is_end(case.t_min) || is_end(case.t_max);
        assert!(is_tie || once.is_some(), "once, no tie: {case:?}");
    }
}

fn every_set<S: Sample>() {
    for set in RaySet::ALL {
        for case in set.cases::<S>(41, 10_000) {
            check(&case);
        }
    }
}

for_every_scalar!(every_set);

/// Directions of a few least numbers, toward triangles of another size: rounding changes their
/// products by as much as the products themselves.
fn tiny_directions<S: Sample>() {
    let mut rng = Rng::new(44);
    for _ in 0..10_000 {
        let mut point = || rng.triple(|rng| S::nearest(rng.whole(-8, 8) as f64 / 8.0));
        let (origin, vertices) = (point(), [point(), point(), point()]);
        let direction = rng.triple(|rng| S::from_ordinal(rng.whole(-4, 4)));
        let case = RayCase::new(origin, direction, vertices);
        if case.is_valid() {
            check(&case);
        }
    }
}

/// Rays that begin at triangles so small that products of two lengths are a few least numbers:
/// rounding alone determines the side of an edge on which they pass.
fn tiny_edges<S: Sample>(least: i32) {
    let mut rng = Rng::new(45);
    for _ in 0..10_000 {
        let size = 2_f64.powi((least - rng.whole(2, 12) as i32) / 2);
        let mut point = |unit: f64| rng.triple(|rng| S::nearest(rng.whole(-4, 4) as f64 * unit));
        let [a, b, c] = [point(size), point(size), point(size)];
        let (origin, direction) = (point(size), point(0.125));
        let case = RayCase::new(origin, direction, [a, b, c]);
        if case.is_valid() {
            check(&case);
        }
    }
}

#[test]
fn tiny_edges_in_f32() {
    tiny_edges::<f32>(-149);
}

#[test]
fn tiny_edges_in_f64() {
    tiny_edges::<f64>(-1074);
}

#[test]
fn tiny_directions_in_f32() {
    tiny_directions::<f32>();
}

#[test]
fn tiny_directions_in_f64() {
    tiny_directions::<f64>();
}

/// Fifteen numbers and two ends chosen from four and their negatives, so that many coincide.
fn case_of<S: Sample>(number: impl Strategy<Value = S>) -> impl Strategy<Value = RayCase<S>> {
    let pool = proptest::collection::vec(number, 4);
    let picks = proptest::array::uniform15(0..9_usize);
    let ends = proptest::array::uniform2(0..10_usize);
    (pool, picks, ends)
        .prop_map(|(pool, picks, ends)| {
            let pick = |n: usize| match n {
                8 => S::ZERO,
                n if n < 4 => pool[n],
                n => S::from_ordinal(pool[n % 4].ordinal().saturating_neg()),
            };
            let row = |r: usize| three(|i| pick(picks[3 * r + i]));
            let end = |n: usize| (n < 9).then(|| pick(n));
            RayCase {
                origin: row(0),
                direction: row(1),
                vertices: [row(2), row(3), row(4)],
                t_min: end(ends[0]),
                t_max: end(ends[1]),
            }
        })
        .prop_filter("a ray", RayCase::is_valid)
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::with_cases(6_000) })]

    #[test]
    fn any_f32(case in case_of(proptest::num::f32::ANY.prop_filter("finite", |x| x.is_finite()))) {
        check(&case);
    }

    #[test]
    fn any_f64(case in case_of(proptest::num::f64::ANY.prop_filter("finite", |x| x.is_finite()))) {
        check(&case);
    }

    #[test]
    fn any_i4f4(case in case_of(any::<i8>().prop_map(I4F4::from_bits))) {
        check(&case);
    }

    #[test]
    fn any_i1f15(case in case_of(any::<i16>().prop_map(I1F15::from_bits))) {
        check(&case);
    }

    #[test]
    fn any_i16f0(case in case_of(any::<i16>().prop_map(I16F0::from_bits))) {
        check(&case);
    }

    #[test]
    fn any_i33f31(case in case_of(any::<i64>().prop_map(I33F31::from_bits))) {
        check(&case);
    }
}
