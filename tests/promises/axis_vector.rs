//! The vector of an axis separates the shapes that the axis separates, checked by projection.

use septum::sweep::{FirstContact, Motion};
use septum::{Aabb, Axis, Obb, Triangle};
use septum_kit::{Each, Rng, three};

#[test]
fn vectors_separate() {
    let mut rng = Rng::new(0xa715);
    let mut seen = std::collections::HashSet::new();
    for _ in 0..60_000 {
        // Small integers, so that nothing is rounded.
        let mut point = || rng.triple(|rng| rng.whole(-6, 6) as f64);
        let ([a, b, c], p) = ([point(), point(), point()], point());
        let t = Triangle::new(a, b, c).unwrap();
        let max = p.each(|x| x + 1.0 + rng.below(3) as f64);
        let aabb = Aabb::from_min_max(p, max).unwrap();
        for axis in Axis::ALL {
            let n = axis.vector(&t).to_array();
            let on = |x: [f64; 3]| x[0] * n[0] + x[1] * n[1] + x[2] * n[2];
            let range = |all: &[f64]| {
                let least = all.iter().copied().fold(f64::INFINITY, f64::min);
                (least, all.iter().copied().fold(f64::NEG_INFINITY, f64::max))
            };
            let corner = |k: usize| three(|i: usize| if k >> i & 1 == 0 { p[i] } else { max[i] });
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

/// Fields are public, so that an index may be any number.
#[test]
fn normals_of_contacts_have_the_side_of_their_axis() {
    let aabb = Aabb::from_min_max([0.0; 3], [1.0; 3]).unwrap();
    let motion = Motion::new([0.0; 3], [1.0, -2.0, 3.0]).unwrap();
    let normal = |i: u8| {
        let axis = Some(Axis::Face(i));
        FirstContact { t: 0.5, axis }.normal(&motion, &aabb).unwrap().to_array()
    };
    assert_eq!([3, 4, 5].each(normal), [[-1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, -1.0]]);
    assert_eq!([0, 1, 2].each(normal), [3, 4, 5].each(normal));
}

/// The normal of a face is perpendicular to two axes, and leads along the third one, whichever hand
/// the axes have.
#[test]
fn vectors_of_oriented_boxes_are_outward_normals() {
    let (mut rng, mut hands) = (Rng::new(0x0bb7), [0; 2]);
    for _ in 0..2_000 {
        let axes = [(); 3].each(|()| rng.triple(|rng| rng.whole(-6, 6) as f64));
        let Ok(obb) = Obb::from_skewed_axes([1.0; 3], axes, [1.0; 3]) else { continue };
        let dot = |a: &[f64; 3], b: &[f64; 3]| a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
        for i in 0..3 {
            let n = Axis::Face(i as u8 + 3).vector(&obb).to_array();
            let along = three(|k: usize| dot(&n, &axes[k]));
            assert!((0..3).all(|k| (along[k] > 0.0) == (k == i)), "{axes:?}: {n:?}");
            assert!((0..3).all(|k| (along[k] == 0.0) != (k == i)), "{axes:?}: {n:?}");
        }
        let [[a, b, c], v, w] = axes;
        let volume = a * (v[1] * w[2] - v[2] * w[1])
            + b * (v[2] * w[0] - v[0] * w[2])
            + c * (v[0] * w[1] - v[1] * w[0]);
        hands[usize::from(volume > 0.0)] += 1;
    }
    assert!(hands.iter().all(|&n| n > 500), "{hands:?}");
}
