//! The oracle of rays itself: on cases with obvious answers, at the point that it returns, and in
//! both integer widths.

use core::cmp::Ordering;

use fixed::types::I8F8;
use septum::{Facing, Feature};
use septum_kit::rays::{RayCase, RaySet, Truth, crossing, crossing_wide};
use septum_kit::{Each, Sample, for_every_scalar};

const CORNER: [[f64; 3]; 3] = [[0.0; 3], [4.0, 0.0, 0.0], [0.0, 4.0, 0.0]];

fn down_at(x: f64, y: f64) -> Option<Truth> {
    crossing(&RayCase::new([x, y, 3.0], [0.0, 0.0, -2.0], CORNER))
}

#[test]
fn what_anyone_can_see() {
    let truth = down_at(1.0, 2.0).expect("a hit inside");
    assert_eq!((truth.facing, truth.feature), (Facing::Front, Feature::Interior));
    assert_eq!(truth.t.compare(1.5), Ordering::Equal);
    assert_eq!(truth.u.compare(0.25), Ordering::Equal);
    assert_eq!(truth.v.compare(0.5), Ordering::Equal);

    let feature = |x, y| down_at(x, y).map(|truth| truth.feature);
    assert_eq!(feature(1.0, 0.0), Some(Feature::Edge(0)));
    assert_eq!(feature(1.0, 3.0), Some(Feature::Edge(1)));
    assert_eq!(feature(0.0, 3.0), Some(Feature::Edge(2)));
    assert_eq!(feature(0.0, 0.0), Some(Feature::Vertex(0)));
    assert_eq!(feature(4.0, 0.0), Some(Feature::Vertex(1)));
    assert_eq!(feature(0.0, 4.0), Some(Feature::Vertex(2)));
    for (x, y) in [(-1e-300, 1.0), (1.0, -1e-300), (1.0, 3.0_f64.next_up()), (9.0, 9.0)] {
        assert_eq!(feature(x, y), None, "{x}, {y}");
    }

    let up = RayCase::new([1.0, 1.0, -3.0], [0.0, 0.0, 2.0], CORNER);
    assert_eq!(crossing(&up).map(|truth| truth.facing), Some(Facing::Back));
}

#[test]
fn ranges_have_ends() {
    let ray = RayCase::new([1.0, 1.0, 3.0], [0.0, 0.0, -2.0], CORNER);
    let hits = |t_min, t_max| crossing(&RayCase { t_min, t_max, ..ray }).is_some();
    assert!(hits(None, None) && hits(Some(1.5), Some(1.5)));
    assert!(!hits(Some(1.5_f64.next_up()), None) && !hits(None, Some(1.5_f64.next_down())));
    let behind = RayCase { direction: [0.0, 0.0, 2.0], ..ray };
    assert!(crossing(&behind).is_none() && crossing(&behind.line()).is_some());
    assert!(crossing(&RayCase { t_min: Some(-1.5), ..behind }).is_some());
    // An origin on the triangle itself.
    assert!(crossing(&RayCase { origin: [1.0, 1.0, 0.0], ..ray }).is_some());
}

#[test]
fn what_is_parallel_crosses_nowhere() {
    let within = RayCase::new([1.0, 1.0, 0.0], [1.0, 1.0, 0.0], CORNER);
    assert!(crossing(&within.line()).is_none());
    let segment = [[0.0; 3], [1.0; 3], [3.0; 3]];
    assert!(crossing(&RayCase::new([2.0, 2.0, 0.0], [0.0, 0.0, 1.0], segment)).is_none());
}

#[test]
fn fractions_know_their_neighbours() {
    // t is 1/3, which no type can represent.
    let third = RayCase::new([0.5, 0.5, 1.0], [0.0, 0.0, -3.0], CORNER);
    let t = crossing(&third).expect("a hit").t;
    assert!(t.is_nearest(1.0_f64 / 3.0) && t.is_nearest(1.0_f32 / 3.0));
    assert!(!t.is_nearest((1.0_f64 / 3.0).next_up()) && !t.is_nearest((1.0_f32 / 3.0).next_down()));
    assert!(t.is_nearest(I8F8::from_bits(85)) && !t.is_nearest(I8F8::from_bits(86)));
    assert!((t.error_in_ulp(I8F8::from_bits(85)) - 1.0 / 3.0).abs() < 1e-12);
    assert!((t.error_in_ulp(I8F8::from_bits(88)) - 8.0 / 3.0).abs() < 1e-12);
    // Half a unit: a tie, which goes to the even number.
    let tie = RayCase::new([0.5, 0.5, 1.0], [0.0, 0.0, -512.0], CORNER);
    let t = crossing(&tie).expect("a hit").t;
    assert!(t.is_nearest(I8F8::ZERO) && !t.is_nearest(I8F8::DELTA));
    assert!(!t.is_beyond::<I8F8>());
    let far = RayCase::new([0.5, 0.5, 1.0], [0.0, 0.0, -1.0 / 512.0], CORNER);
    assert!(crossing(&far).expect("a hit").t.is_beyond::<I8F8>());
}

/// Ray and triangle meet at the point of the fractions.
fn points_agree<S: Sample>() {
    for set in RaySet::ALL {
        if matches!(set, RaySet::Huge) {
            continue;
        }
        for case in set.cases::<S>(31, 2_000) {
            let Some(truth) = crossing(&case) else { continue };
            let [t, u, v] = [&truth.t, &truth.u, &truth.v].each(|x| x.approximate());
            for i in 0..3 {
                let x = |p: [S; 3]| p[i].approximate();
                let [a, b, c] = case.vertices.each(x);
                let on_ray = x(case.origin) + t * x(case.direction);
                let on_triangle = (1.0 - u - v) * a + u * b + v * c;
                let most = a.abs().max(b.abs()).max(c.abs()).max(on_ray.abs()).max(1e-3);
                let along = (t * x(case.direction)).abs();
                let error = (on_ray - on_triangle).abs();
                assert!(error <= 1e-13 * (most + along), "{set:?}: {error:e}, {case:?}");
            }
        }
    }
}

fn widths_agree<S: Sample>() {
    for set in RaySet::ALL {
        for case in set.cases::<S>(32, 2_000) {
            let summary = |truth: Option<Truth>| {
                truth.map(|x| (x.t.approximate(), x.u.approximate(), x.facing, x.feature))
            };
            assert_eq!(summary(crossing(&case)), summary(crossing_wide(&case)), "{case:?}");
        }
    }
}

/// Every set contains both verdicts, or it would show little.
fn every_set_has_both_verdicts<S: Sample>() {
    for set in RaySet::ALL {
        let cases = set.cases::<S>(33, 2_000);
        let hits = cases.iter().filter(|case| crossing(case).is_some()).count();
        let fits = set.misfit::<S>().is_none();
        assert!(!fits || (100..1_900).contains(&hits), "{set:?}: {hits} of 2000 hit");
    }
}

for_every_scalar!(points_agree, widths_agree, every_set_has_both_verdicts);
