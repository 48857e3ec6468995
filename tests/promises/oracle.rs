//! The oracle itself: on cases with obvious answers, and compared with a second theorem.

use fixed::types::I8F8;
use septum::Axis;
use septum_kit::{BoxNumbers, Case, Lattice, Rng, Sample, Set, for_every_scalar, meets, separates};

/// The cube from −1 to 1 in both forms.
fn cubes() -> [BoxNumbers<f64>; 2] {
    [BoxNumbers::Center([0.0; 3], [1.0; 3]), BoxNumbers::Corners([-1.0; 3], [1.0; 3])]
}

#[track_caller]
fn assert_meets(vertices: [[f64; 3]; 3], expected: bool) {
    for aabb in cubes() {
        for vertices in [vertices, [vertices[2], vertices[1], vertices[0]]] {
            let case = Case { vertices, aabb };
            assert_eq!(meets(&case), expected, "{case:?}");
            assert_eq!(Lattice::new(&case).widened().meets(), expected, "{case:?}, wide");
        }
    }
}

#[test]
fn what_anyone_can_see() {
    // A vertex inside; all inside; the cube pierced by an edge, and by the middle.
    assert_meets([[0.0; 3], [5.0, 0.0, 0.0], [0.0, 5.0, 0.0]], true);
    assert_meets([[0.1, 0.0, 0.0], [0.0, 0.2, 0.0], [0.0, 0.0, 0.3]], true);
    assert_meets([[-5.0, 0.0, 0.0], [5.0, 0.0, 0.0], [5.0, 9.0, 0.0]], true);
    assert_meets([[-9.0, -9.0, 0.5], [9.0, -9.0, 0.5], [0.0, 9.0, 0.5]], true);
    // Beside a face, beyond an edge, beyond a corner.
    assert_meets([[2.0, 0.0, 0.0], [5.0, 0.0, 0.0], [5.0, 9.0, 0.0]], false);
    assert_meets([[2.5, 0.0, 0.0], [0.0, 2.5, 0.0], [3.0, 3.0, 1.0]], false);
    assert_meets([[3.5, 0.0, 0.0], [0.0, 3.5, 0.0], [0.0, 0.0, 3.5]], false);
}

#[test]
fn contact_counts() {
    // A vertex, an edge and the inside, on a face, an edge and a corner.
    assert_meets([[1.0, 0.0, 0.0], [5.0, 0.0, 0.0], [5.0, 9.0, 0.0]], true);
    assert_meets([[1.0, 1.0, 0.0], [5.0, 1.0, 0.0], [5.0, 9.0, 0.0]], true);
    assert_meets([[1.0, 1.0, 1.0], [5.0, 1.0, 1.0], [5.0, 9.0, 1.0]], true);
    assert_meets([[2.0, 0.0, 0.0], [0.0, 2.0, 0.0], [3.0, 3.0, 1.0]], true);
    assert_meets([[3.0, 0.0, 0.0], [0.0, 3.0, 0.0], [0.0, 0.0, 3.0]], true);
    assert_meets([[-9.0, -9.0, 1.0], [9.0, -9.0, 1.0], [0.0, 9.0, 1.0]], true);
    // One unit in the last place of a double away.
    let off = 3.0 + 2_f64.powi(-51);
    assert_meets([[off, 0.0, 0.0], [0.0, off, 0.0], [0.0, 0.0, off]], false);
    assert_meets([[off, 0.0, 0.0], [0.0, 3.0, 0.0], [0.0, 0.0, 3.0]], false);
    let off = 1.0 + 2_f64.powi(-52);
    assert_meets([[-9.0, -9.0, off], [9.0, -9.0, off], [0.0, 9.0, off]], false);
}

#[test]
fn segments_and_points() {
    let [corner, edge, out] = [[1.0; 3], [0.0, 1.0, 1.0], [1.0, 1.5, 0.0]];
    assert_meets([corner; 3], true);
    assert_meets([edge; 3], true);
    assert_meets([[0.0; 3]; 3], true);
    assert_meets([out; 3], false);
    assert_meets([[2.0, 0.0, 1.0], [0.0, 2.0, 1.0], [0.0, 2.0, 1.0]], true);
    assert_meets([[2.0, 0.0, 1.0], [-2.0, 4.0, 1.0], [0.0, 2.0, 1.0]], true);
    assert_meets([[2.0, 0.5, 1.0], [0.0, 2.5, 1.0], [0.0, 2.5, 1.0]], false);
    assert_meets([[2.0, 0.5, 1.0], [-2.0, 4.5, 1.0], [0.0, 2.5, 1.0]], false);
    // On the line of an edge of the cube, before it and up to it.
    assert_meets([[3.0, 1.0, 1.0], [2.0, 1.0, 1.0], [4.0, 1.0, 1.0]], false);
    assert_meets([[3.0, 1.0, 1.0], [1.0, 1.0, 1.0], [4.0, 1.0, 1.0]], true);
}

#[test]
fn flat_boxes_and_points() {
    let vertices = [[0.0, 0.0, 0.0], [4.0, 0.0, 0.0], [0.0, 4.0, 0.0]];
    let at = |center, half| meets(&Case { vertices, aabb: BoxNumbers::Center(center, half) });
    assert!(at([1.0, 1.0, 0.0], [0.0; 3]) && at([2.0, 2.0, 0.0], [0.0; 3]));
    assert!(!at([2.0, 2.1, 0.0], [0.0; 3]) && !at([1.0, 1.0, 1e-300], [0.0; 3]));
    assert!(at([1.0, 1.0, 0.0], [5.0, 5.0, 0.0]) && !at([1.0, 1.0, 1.0], [5.0, 5.0, 0.0]));
    assert!(at([2.5, 2.5, 0.0], [0.5, 0.5, 9.0]) && !at([2.5, 2.5, 0.0], [0.4, 0.5, 0.0]));
}

/// All tests depend on the decomposition of numbers into bits, so it is compared with the types'
/// own conversions.
#[test]
fn numbers_are_taken_apart_rightly() {
    let mut rng = Rng::new(13);
    let special = [0.0, f32::MIN_POSITIVE, f32::MAX, f32::from_bits(1), f32::EPSILON, 1.0];
    let random = (0..100_000).map(|_| f32::from_bits(rng.bits() as u32));
    for x in special.into_iter().chain(random).filter(|x| x.is_finite()) {
        assert_eq!(x.approximate(), f64::from(x), "{x:e}");
        assert_eq!(f32::from_ordinal(x.ordinal()), x, "{x:e}");
    }
    let special = [0.0, f64::MIN_POSITIVE, f64::MAX, f64::from_bits(1), f64::EPSILON, 1.0];
    let random = (0..100_000).map(|_| f64::from_bits(rng.bits()));
    for x in special.into_iter().chain(random).filter(|x| x.is_finite()) {
        assert_eq!(x.approximate(), x, "{x:e}");
        assert_eq!(f64::from_ordinal(x.ordinal()), x, "{x:e}");
    }
    for x in (i16::MIN..=i16::MAX).map(I8F8::from_bits) {
        assert_eq!(x.approximate(), x.to_num::<f64>(), "{x}");
        assert_eq!(I8F8::from_ordinal(x.ordinal()), x, "{x}");
    }
}

/// A step leads to the next value; no value lies between.
#[test]
fn neighbours_are_adjacent() {
    let mut rng = Rng::new(14);
    for _ in 0..100_000 {
        let x = f32::from_bits(rng.bits() as u32);
        if x.is_finite() && x < f32::MAX {
            let (low, high) = (f64::from(x), f64::from(x.moved(1)));
            let middle = ((low + high) / 2.0) as f32;
            assert!(low < high && (f64::from(middle) == low || f64::from(middle) == high), "{x:e}");
        }
    }
    assert_eq!(f32::MAX.moved(1), f32::MAX);
    assert_eq!(I8F8::MIN.moved(-1), I8F8::MIN);
    assert_eq!(I8F8::ZERO.moved(-1), -I8F8::DELTA);
}

/// Clipping and the 13 axes are different theorems and must agree; so must both integer widths.
fn agrees_with_projections<S: Sample>() {
    for set in Set::ALL {
        for case in set.cases::<S>(11, 3_000) {
            let meets = meets(&case);
            let separated = Axis::ALL.iter().any(|&axis| separates(&case, axis));
            assert_eq!(meets, !separated, "{set:?}: {case:?}");
            assert_eq!(meets, Lattice::new(&case).widened().meets(), "{set:?}, wide: {case:?}");
        }
    }
}

/// Every set contains both verdicts, or it would show little.
fn every_set_has_both_verdicts<S: Sample>() {
    for set in Set::ALL {
        let cases = set.cases::<S>(12, 2_000);
        let met = cases.iter().filter(|case| meets(case)).count();
        let fits = set.misfit::<S>().is_none();
        assert!(!fits || (50..1_950).contains(&met), "{set:?}: {met} of 2000 meet");
    }
}

for_every_scalar!(agrees_with_projections, every_set_has_both_verdicts);
