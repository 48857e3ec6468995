//! Rays and segments against oriented boxes: the exact verdict, and t of entry and exit.

use fixed::types::{I1F63, I64F0};
use septum::{Aabb, Obb, Ray, Segment, Vec3};
use septum_kit::boxes::BoxSet;
use septum_kit::lines::{Fraction, Line, LineBox, LineObb, LineSet};
use septum_kit::{BoxNumbers, Each, Rng, Sample, for_every_scalar, three};

fn exact_on_every_set<S: Sample>() {
    check_sets::<S>(2_000);
}
for_every_scalar!(exact_on_every_set);

/// Inputs for which all sums are as long as they can be.
#[test]
fn exact_at_the_ends_of_64_bits() {
    check_sets::<I1F63>(1_000);
    check_sets::<I64F0>(1_000);
}

fn check_sets<S: Sample>(cases: u32) {
    for set in BoxSet::ALL {
        let rng = &mut Rng::new(0x0bb5);
        let (mut asked, mut met) = (0, 0);
        for _ in 0..cases {
            let case = LineObb::<S>::case(set, rng);
            let Some(meets) = case.check() else { continue };
            check_range(&case);
            asked += 1;
            met += u32::from(meets);
        }
        let both = met > cases / 20 && asked - met > cases / 20;
        assert!(both || matches!(set, BoxSet::Huge | BoxSet::Bits), "{set:?}: {met} of {asked}");
        assert!(asked > cases / 20 || S::name() == "I1F63", "{set:?}: {asked}");
    }
}

fn check_range<S: Sample>(case: &LineObb<S>) {
    let Some(ray) = case.line.ray() else { return };
    let found = ray.t_range_obb(&case.obb.shape().unwrap());
    check_faces(case);
    let expected = case.clip();
    assert_eq!(found.is_some(), expected.is_some(), "{case:?}");
    let (Some((enter, leave)), Some([Some(from), Some(to)])) = (found, expected) else { return };
    assert!(enter <= leave, "{case:?}");
    for (t, expected) in [(enter, from), (leave, to)] {
        assert!(is_rounded(t, &expected), "{t:?} of {case:?}");
    }
}

/// The faces of entry and exit, with t as of `t_range_obb`.
fn check_faces<S: Sample>(case: &LineObb<S>) -> Option<[Option<u8>; 2]> {
    let (ray, obb) = (case.line.ray()?, case.obb.shape().ok()?);
    let (found, expected) = (ray.crossings_obb(&obb), case.faces());
    assert_eq!(found.map(|both| both.each(|one| one.face)), expected, "{case:?}");
    let range = found.map(|[enter, leave]| (enter.t, leave.t));
    assert_eq!(range, ray.t_range_obb(&obb), "{case:?}");
    expected
}

fn is_rounded<S: Sample>(t: S, expected: &Fraction) -> bool {
    let is_float = S::ZERO.moved(1).approximate() < 1e-30;
    if !is_float {
        return t == expected.nearest_fixed();
    }
    // Below the least normal number all floats have one spacing, and t may be rounded twice.
    let exponent = |x: S| x.mantissa_exponent().1;
    let bound = if exponent(t) == exponent(S::ZERO) { 76 } else { 51 };
    !t.is_finite() || expected.is_within(t, (bound, 100))
}

/// An oriented box with axes along the coordinate axes is the axis-aligned box.
fn as_an_aabb<S: Sample>() {
    let one = S::nearest(1.0);
    let along = three(|i: usize| {
        let mut axis = [S::ZERO; 3];
        axis[i] = one;
        Vec3::from(axis)
    });
    let mut asked = 0;
    for set in LineSet::ALL {
        let rng = &mut Rng::new(0xa0bb);
        for _ in 0..2_000 {
            let case: LineBox<S> = set.case(rng);
            let BoxNumbers::Center(center, half) = case.aabb else { continue };
            let Ok(obb) = Obb::from_skewed_axes(center, along, half) else { continue };
            let aabb = case.aabb();
            match (case.ray(), case.segment()) {
                (Some(ray), _) => {
                    assert_eq!(ray.overlaps(&obb), ray.overlaps(&aabb), "{case:?}");
                    assert_eq!(ray.t_range_obb(&obb).is_some(), ray.t_range(&aabb).is_some());
                }
                (None, segment) => {
                    let segment = segment.unwrap();
                    assert_eq!(segment.overlaps(&obb), segment.overlaps(&aabb), "{case:?}");
                }
            }
            asked += 1;
        }
    }
    assert!(asked > 4_000, "{asked}");
}
for_every_scalar!(as_an_aabb);

/// Every line from one point of a small grid to another, past a skewed box: every kind of contact.
#[test]
fn every_line_on_a_grid() {
    let axes = [[1.0, 1.0, 0.0], [-1.0, 1.0, 0.0], [0.0, 1.0, 1.0]];
    let obb = septum_kit::boxes::ObbNumbers { center: [0.0_f32; 3], axes, half: [1.0, 0.5, 1.0] };
    let (mut met, mut asked, mut seen) = (0, 0, [0; 7]);
    for n in 0..7_usize.pow(4) {
        let digit = |k: u32| (n / 7_usize.pow(k) % 7) as f32 - 3.0;
        let (a, b) = ([digit(0), digit(1), -2.0], [digit(2), digit(3), 2.0]);
        for line in [Line::Ends(a, b), Line::Ray(a, [b[0], b[1], 1.0], [None, Some(2.0)])] {
            let case = LineObb { line, obb };
            met += u32::from(case.check().unwrap());
            asked += 1;
            for face in check_faces(&case).into_iter().flatten() {
                seen[face.map_or(6, usize::from)] += 1;
            }
        }
    }
    assert!(met > 500 && asked - met > 500, "{met} of {asked}");
    // Every range ends in the plane z = 0, below the upper side of the last axis.
    assert!(seen[..5].iter().all(|&n| n > 50) && seen[5] == 0 && seen[6] > 20, "{seen:?}");
}

/// The ray begins at zero times its direction, however long that is.
#[test]
fn a_long_ray_from_its_origin() {
    let unit = [[1, 0, 0], [0, 1, 0], [0, 0, 1]];
    let unit = unit.each(|axis| Vec3::from(axis.each(I64F0::from_num)));
    let zero = [I64F0::ZERO; 3];
    let obb = Obb::from_skewed_axes(zero, unit, [I64F0::ONE; 3]).unwrap();
    for bits in 0..63 {
        let way = [I64F0::from_bits(1 << bits), I64F0::ZERO, I64F0::ZERO];
        let ray = Ray::new(zero, way).unwrap();
        assert!(ray.overlaps(&obb) && ray.t_range_obb(&obb).unwrap().0 == 0, "{bits}");
    }
}

#[test]
fn ends_of_a_range_count() {
    let obb = Obb::from_turns([0.0_f64; 3], [0.125, 0.25, 0.0], [1.0, 2.0, 3.0]).unwrap();
    let aabb: Aabb<f64> = obb.aabb().unwrap();
    assert!(!Segment::new([9.0, 0.0, 0.0], [9.0; 3]).unwrap().overlaps(&obb));
    assert!(aabb.contains([0.0; 3]));
    // From the centre every direction hits.
    for d in [[1.0, 0.0, 0.0], [1e-300, 0.0, -1e-300], [0.0, 1e300, 1e300]] {
        let ray = Ray::new([0.0; 3], d).unwrap();
        assert!(ray.overlaps(&obb) && ray.t_range_obb(&obb).unwrap().0 == 0.0);
        assert!(ray.with_range(0.0, 0.0).unwrap().overlaps(&obb));
        let back = ray.with_range(None, 0.0).unwrap();
        assert!(back.t_range_obb(&obb).unwrap().1 == 0.0);
    }
}
