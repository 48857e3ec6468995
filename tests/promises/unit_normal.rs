//! Unit normals, compared with integers of any size.

use dashu_int::IBig;
use fixed::types::{I0F8, I0F16, I0F64, I1F7, I1F15, I4F4, I8F0, I16F16, I64F0};
use proptest::prelude::*;
use septum::interop::FixedPoint;
use septum::{Facing, Feature, Hit, Triangle, Vec3};
#[cfg(any(feature = "libm", feature = "micromath"))]
use septum_kit::Rng;
#[cfg(feature = "libm")]
use septum_kit::compare_with_unit;
use septum_kit::{Each, Points, Sample, for_scalars, is_nearest_to_unit, normal_of, three};

fn triangle<S: Sample>(points: &Points<S>) -> Triangle<S> {
    Triangle::new(points[0], points[1], points[2]).unwrap()
}

fn check_integer<S: Sample + FixedPoint>(points: &Points<S>) {
    let (n, square) = normal_of(points);
    let found = triangle(points).unit_normal();
    assert_eq!(found.is_none(), square == IBig::ZERO, "{points:?}");
    if let Some(found) = found {
        for (x, n) in found.to_array().into_iter().zip(&n) {
            assert!(is_nearest_to_unit(x, n, &square), "{points:?}: {found:?}");
        }
    }
}

/// Every triangle on a small grid, at every corner of the type's range.
fn every_small<S: Sample + FixedPoint>() {
    for corner in [S::LEAST, S::GREATEST.moved(-3), S::ZERO] {
        for n in 0..4_i64.pow(6) {
            let digit = |k: u32| corner.moved(n / 4_i64.pow(k) % 4);
            let b = [digit(0), digit(1), digit(2)];
            let c = [digit(3), digit(4), digit(5)];
            check_integer(&[[corner.moved(1), corner.moved(2), corner], b, c]);
        }
    }
}

#[test]
fn nearest_on_every_small_triangle() {
    every_small::<I4F4>();
    every_small::<I8F0>();
    every_small::<I1F7>();
    every_small::<I0F8>();
    every_small::<I16F16>();
    every_small::<I0F64>();
}

/// Any coordinate of a type of so many bits and a sign; the ends of the type; small ones.
fn coordinate(whole_bits: u32) -> impl Strategy<Value = i64> {
    let (least, shift) = (-1_i64 << whole_bits, 63 - whole_bits);
    prop_oneof![
        3 => any::<i64>().prop_map(move |x| x >> shift),
        1 => (any::<i64>(), 0..whole_bits).prop_map(move |(x, less)| x >> shift >> less),
        1 => (any::<bool>(), -2_i64..=2).prop_map(move |(up, n)| {
            if up { !least } else { least }.saturating_add(n).clamp(least, !least)
        }),
    ]
}

/// A triangle, large or small, in half of the cases a sliver: a vertex near the midpoint of the
/// other two. The numbers are bits, so that it is compiled once for all types.
fn points(whole_bits: u32) -> impl Strategy<Value = Points<i64>> {
    let point = || proptest::array::uniform3(coordinate(whole_bits));
    let aside = proptest::option::of(proptest::array::uniform3(-2_i64..=2));
    let less = prop_oneof![Just(0), 0..whole_bits];
    (point(), point(), point(), aside, less).prop_map(|(a, b, c, aside, less)| {
        let [a, b, c] = [a, b, c].each(|p| p.each(|x| x >> less));
        let middle = |i: usize| ((i128::from(a[i]) + i128::from(b[i])) >> 1) as i64;
        [a, b, aside.map_or(c, |steps| three(|i| middle(i).saturating_add(steps[i])))]
    })
}

/// Checks the triangles of these points.
fn all(points: impl Strategy<Value = Points<i64>>, check: &dyn Fn(&Points<i64>)) {
    let config = ProptestConfig { failure_persistence: None, ..ProptestConfig::with_cases(1_500) };
    proptest!(config, |(points in points)| check(&points));
}

fn nearest<S: Sample + FixedPoint>() {
    all(points(S::WHOLE_BITS), &|points| check_integer(&points.each(|p| p.each(S::from_ordinal))));
}

for_scalars!([
    i4f4: fixed::types::I4F4,
    i8f8: fixed::types::I8F8,
    i0f16: fixed::types::I0F16,
    i1f15: fixed::types::I1F15,
    i16f16: fixed::types::I16F16,
    i32f32: fixed::types::I32F32,
    i64f0: fixed::types::I64F0,
    i1f63: fixed::types::I1F63,
    i0f64: fixed::types::I0F64,
] nearest);

#[test]
fn the_largest_normals_fit() {
    fn check<S: Sample + FixedPoint>() {
        let (l, g) = (S::LEAST, S::GREATEST);
        // The largest triangle in a cube, and the largest in a face of it.
        check_integer(&[[l, l, l], [g, g, l], [g, l, g]]);
        check_integer(&[[l, l, l], [g, l, l], [g, g, l]]);
        check_integer(&[[g, l, l], [l, g, l], [l, l, g]]);
    }
    check::<I4F4>();
    check::<I0F16>();
    check::<I16F16>();
    check::<I64F0>();
    check::<I0F64>();
}

#[test]
fn no_normal_of_a_segment_or_a_point() {
    let p = |x: i64| [I16F16::from_num(x), I16F16::from_num(2 * x), I16F16::from_num(-x)];
    let segment = Triangle::new(p(-3), p(1), p(2)).unwrap();
    assert_eq!(segment.unit_normal(), None);
    assert_eq!(Triangle::new(p(1), p(1), p(1)).unwrap().unit_normal(), None);
}

#[test]
fn one_where_the_type_has_none() {
    let [o, x] = [I1F15::ZERO, I1F15::from_bits(77)];
    let up = Triangle::new([o; 3], [x, o, o], [o, x, o]).unwrap();
    let down = Triangle::new([o; 3], [o, x, o], [x, o, o]).unwrap();
    assert_eq!(up.unit_normal(), Some(Vec3::new(o, o, I1F15::MAX)));
    assert_eq!(down.unit_normal(), Some(Vec3::new(o, o, I1F15::MIN)));
    let hit = Hit { t: o, u: o, v: o, facing: Facing::Back, feature: Feature::Interior };
    let turned = hit.oriented(down.unit_normal().unwrap());
    assert_eq!(turned, Vec3::new(o, o, I1F15::MAX));
    let front = Hit { facing: Facing::Front, ..hit };
    assert_eq!(front.oriented([o, x, I1F15::MIN]), Vec3::new(o, x, I1F15::MIN));
}

/// Sets of float triangles: random, far away, slivers, of mixed magnitudes, on a grid,
/// of any magnitude, tiny and huge.
#[cfg(any(feature = "libm", feature = "micromath"))]
fn float_sets<S: Sample>(cases: usize) -> impl Iterator<Item = Points<S>> {
    let mut rng = Rng::new(0x0a11);
    (0..cases).map(move |n| {
        let mut point = |far: f64| rng.triple(|r| S::nearest(far + r.real(-2.0, 2.0)));
        let (a, b, c) = match n % 9 {
            0 => (point(0.0), point(0.0), point(0.0)),
            1 => (point(1e4), point(1e4), point(1e4)),
            2 | 3 => {
                let (a, b) = (point(0.0), point(0.0));
                let steps = rng.triple(|r| r.whole(-2, 2));
                (a, b, three(|i| a[i].between(b[i]).moved(steps[i])))
            }
            4 => {
                let mut any = || {
                    rng.triple(|r| {
                        let ordinal = S::GREATEST.ordinal() as f64 * r.real(-1.0, 1.0);
                        S::from_ordinal(ordinal as i64)
                    })
                };
                (any(), any(), any())
            }
            5 => {
                let mut grid = || rng.triple(|r| S::nearest(0.25 * r.whole(-3, 3) as f64));
                (grid(), grid(), grid())
            }
            6 => {
                let scale = 2_f64.powi(rng.whole(-1000, 1000) as i32);
                let mut scaled = || rng.triple(|r| S::nearest(scale * r.real(-2.0, 2.0)));
                (scaled(), scaled(), scaled())
            }
            7 => {
                let mut tiny = || rng.triple(|r| S::from_ordinal(r.whole(-9, 9)));
                (tiny(), tiny(), tiny())
            }
            _ => {
                let mut end = || {
                    rng.triple(|r| {
                        let end = [S::LEAST, S::GREATEST, S::ZERO][r.below(3)];
                        end.moved(r.whole(-3, 3))
                    })
                };
                (end(), end(), end())
            }
        };
        [a, b, c]
    })
}

/// The error in 256ths of the last place of each component may be up to `bound`.
#[cfg(feature = "libm")]
fn largest_error<S: Sample>(find: impl Fn(&Triangle<S>) -> Option<Vec3<S>>) -> i32 {
    let (mut worst, mut degenerate) = (0, 0);
    for points in float_sets::<S>(60_000) {
        let (n, square) = normal_of(&points);
        let found = find(&triangle(&points));
        assert_eq!(found.is_none(), square == IBig::ZERO, "{points:?}");
        degenerate += usize::from(found.is_none());
        let Some(found) = found else { continue };
        for (x, n) in found.to_array().into_iter().zip(&n) {
            let (m, e) = x.mantissa_exponent();
            let fine = IBig::from(m) * 256;
            let off = |error: i32| {
                compare_with_unit(&(&fine - error), e - 8, n, &square).is_gt()
                    || compare_with_unit(&(&fine + error), e - 8, n, &square).is_lt()
            };
            while off(worst) {
                worst += 1;
                assert!(worst < 256 * 100, "{points:?}: {found:?}");
            }
        }
    }
    assert!(degenerate > 100, "{degenerate}");
    worst
}

#[cfg(feature = "libm")]
#[test]
fn libm_in_f32_is_within_51_hundredths_of_the_last_place() {
    let error = largest_error(Triangle::<f32>::unit_normal);
    println!("largest error: {error} / 256 of the last place");
    assert!((120..=130).contains(&error), "{error}");
}

#[cfg(feature = "libm")]
#[test]
fn libm_in_f64_is_within_6_of_the_last_place() {
    let error = largest_error(Triangle::<f64>::unit_normal);
    println!("largest error: {error} / 256 of the last place");
    assert!(error <= 6 * 256, "{error}");
}

/// Twice the area is 2^-160: pairs of floats compute zero, and must not trust it.
#[cfg(feature = "libm")]
#[test]
fn libm_in_f64_knows_what_pairs_of_floats_do_not() {
    let x = 2_f64.powi(-80);
    let t = Triangle::new([1.0, 1.0, 0.0], [x, 2.0 * x, 0.0], [2.0 * x, 3.0 * x, 0.0]).unwrap();
    assert_eq!(t.unit_normal(), Some(Vec3::new(0.0, 0.0, -1.0)));
}

#[cfg(feature = "micromath")]
#[test]
fn micromath_is_some_per_cent_too_long_or_too_short() {
    let mut rng = Rng::new(0x6d);
    let mut point = || rng.triple(|r| r.real(-2.0, 2.0) as f32);
    let (mut short, mut long, mut angle) = (1.0_f64, 1.0_f64, 0.0_f64);
    for _ in 0..200_000 {
        let [a, b, c] = [point(), point(), point()];
        let edge = |p: [f32; 3]| three(|i| f64::from(p[i]) - f64::from(a[i]));
        let (e, f) = (edge(b), edge(c));
        let n = [e[1] * f[2] - e[2] * f[1], e[2] * f[0] - e[0] * f[2], e[0] * f[1] - e[1] * f[0]];
        let length = |v: &[f64; 3]| v.iter().map(|x| x * x).sum::<f64>().sqrt();
        // This method is not meant for slivers.
        if length(&n) < 0.1 * length(&e) * length(&f) {
            continue;
        }
        let found = Triangle::new(a, b, c).unwrap().unit_normal_fast().unwrap();
        let found = found.to_array().each(f64::from);
        let l = length(&found);
        (short, long) = (short.min(l), long.max(l));
        let off = three(|i| found[i] / l - n[i] / length(&n));
        angle = angle.max(length(&off));
    }
    println!("length {short} to {long}, angle {angle}");
    // As documented, on either side.
    assert!((0.965..0.967).contains(&short) && (1.033..1.035).contains(&long), "{short} {long}");
    assert!(angle < 1e-5, "{angle}");
}

#[cfg(feature = "micromath")]
#[test]
fn micromath_has_nothing_to_say_outside_its_range() {
    for points in float_sets::<f32>(40_000) {
        if let Some(n) = triangle(&points).unit_normal_fast() {
            let square: f64 = n.to_array().iter().map(|&x| f64::from(x).powi(2)).sum();
            assert!((0.93..1.08).contains(&square), "{points:?}: {n:?}");
        }
    }
}
