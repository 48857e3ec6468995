//! The vector of an axis separates the shapes that the axis separates, checked by projection.

use septum::{Aabb, Axis, Triangle};
use septum_kit::Rng;

#[test]
fn vectors_separate() {
    let mut rng = Rng::new(0xa715);
    let mut seen = std::collections::HashSet::new();
    for _ in 0..60_000 {
        // Small integers, so that nothing is rounded.
        let mut point = || rng.triple(|rng| rng.whole(-6, 6) as f64);
        let ([a, b, c], p) = ([point(), point(), point()], point());
        let t = Triangle::new(a, b, c).unwrap();
        let max = p.map(|x| x + 1.0 + rng.below(3) as f64);
        let aabb = Aabb::from_min_max(p, max).unwrap();
        for axis in Axis::ALL {
            let n = axis.vector(&t).to_array();
            let on = |x: [f64; 3]| x[0] * n[0] + x[1] * n[1] + x[2] * n[2];
            let range = |all: &[f64]| {
                let least = all.iter().copied().fold(f64::INFINITY, f64::min);
                (least, all.iter().copied().fold(f64::NEG_INFINITY, f64::max))
            };
            let corner =
                |k: usize| [0, 1, 2].map(|i: usize| if k >> i & 1 == 0 { p[i] } else { max[i] });
            let corners: Vec<f64> = (0..8).map(|k| on(corner(k))).collect();
            let (low, high) = range(&[on(a), on(b), on(c)]);
            let (least, greatest) = range(&corners);
            let separates = high < least || greatest < low;
            assert_eq!(separates, t.is_separated_by(&aabb, axis), "{axis:?} {t:?} {aabb:?}");
            if separates {
                seen.insert(axis);
            }
        }
    }
    assert_eq!(seen.len(), 13);
}

/// The sides of the vectors, and indices beyond 2.
#[test]
fn vectors_are_what_they_are_said_to_be() {
    let t = Triangle::new([0.0, 0.0, 0.0], [1.0, 2.0, 3.0], [5.0, 1.0, 2.0]).unwrap();
    let vector = |axis: Axis| axis.vector(&t).to_array();
    assert_eq!(vector(Axis::Face(1)), [0.0, 1.0, 0.0]);
    assert_eq!(vector(Axis::Face(5)), [0.0, 0.0, 1.0]);
    assert_eq!(vector(Axis::Normal), [1.0, 13.0, -9.0]);
    assert_eq!(vector(Axis::Edge { axis: 0, edge: 0 }), [0.0, -3.0, 2.0]);
    assert_eq!(vector(Axis::Edge { axis: 4, edge: 4 }), [-1.0, 0.0, -4.0]);
    assert_eq!(vector(Axis::Edge { axis: 2, edge: 2 }), [1.0, -5.0, 0.0]);
}
