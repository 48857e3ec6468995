//! `ray.hit` gives the exact answer: on every set, in every scalar, and on numbers of any
//! magnitude, compared with the intersection in fractions.

use core::cmp::Ordering;

use proptest::prelude::*;
use septum::prepared::{HitRay, HitTriangle};
use septum::{Cull, Facing, Feature, HitRules};
use septum_kit::rays::{RayCase, RaySet, crossing};
use septum_kit::{Each, Rng, Sample, for_every_scalar, for_scalars, three};

use super::any_bits::AnyBits;

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
fn case_of<S: Sample>(pool: [S; 4], picks: &[usize; 15], ends: [usize; 2]) -> RayCase<S> {
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
}

/// Of bits, and which of them are picked. What is no ray is drawn again.
type Check<'a> = &'a dyn Fn([i64; 4], &[usize; 15], [usize; 2]) -> bool;

fn all(bits: BoxedStrategy<i64>, check: Check<'_>) {
    let config = ProptestConfig { failure_persistence: None, ..ProptestConfig::with_cases(6_000) };
    let config = ProptestConfig { max_global_rejects: config.max_local_rejects, ..config };
    let picks = proptest::array::uniform15(0..9_usize);
    let ends = proptest::array::uniform2(0..10_usize);
    proptest!(config, |(bits in proptest::array::uniform4(bits), picks in picks, ends in ends)| {
        prop_assume!(check(bits, &picks, ends), "a ray");
    });
}

fn any<S: AnyBits>() {
    all(S::any_bits(), &|bits, picks, ends| {
        let case = case_of(bits.each(S::of_bits), picks, ends);
        let is_ray = case.is_valid();
        if is_ray {
            check(&case);
        }
        is_ray
    });
}

for_scalars!([
    f32: f32,
    f64: f64,
    i4f4: fixed::types::I4F4,
    i1f15: fixed::types::I1F15,
    i16f0: fixed::types::I16F0,
    i33f31: fixed::types::I33F31,
] any);

/// The rest of one, in types that do not hold one.
#[test]
fn the_third_weight_needs_no_one() {
    use septum::{Hit, Ray, Triangle};
    use septum_kit::fixed::types::{I0F8, I1F7, I4F4, I8F8};

    let [z, quarter, half] = [0.0, 0.25, 0.5].map(I1F7::from_num);
    let triangle = Triangle::new([z; 3], [half, z, z], [z, half, z]).unwrap();
    let ray = Ray::new([quarter, quarter, half], [z, z, -half]).unwrap();
    assert_eq!(ray.hit(&triangle).map(|hit| hit.w()), Some(z));

    macro_rules! every {
        ($($scalar:ident)*) => {$(
            let one = 1_i32 << $scalar::FRAC_NBITS;
            for (u, v) in (0..=127_i8).flat_map(|u| (0..=127_i8).map(move |v| (u, v))) {
                let [t, u, v] = [0, u, v].map(|x| $scalar::from_bits(x.into()));
                let facing = Facing::Front;
                let w = Hit { t, u, v, facing, feature: Feature::Interior }.w();
                let rest = one - i32::from(u.to_bits()) - i32::from(v.to_bits());
                let [least, most] = [$scalar::MIN, $scalar::MAX].map(|x| i32::from(x.to_bits()));
                assert_eq!(i32::from(w.to_bits()), rest.clamp(least, most), "{u} {v}");
            }
        )*};
    }
    every! { I0F8 I1F7 I4F4 I8F8 }
}

/// On every machine a zero has the sign of the determinant.
#[test]
fn zeros_have_the_sign_of_the_determinant() {
    use septum::{Ray, Triangle};

    let ray = Ray::new([-0.0_f32; 3], [-2.0, -2.0, 1.0]).unwrap();
    let t = Triangle::new([0.0_f32; 3], [-2.0, -2.0, 2.0], [-2.0, 1.0, 0.0]).unwrap();
    let hit = ray.hit(&t).unwrap();
    assert_eq!([hit.u, hit.v].map(f32::to_bits), [(-0.0_f32).to_bits(); 2]);
}
