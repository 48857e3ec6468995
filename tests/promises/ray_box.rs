//! A ray against an axis-aligned box: the exact verdict, and t of entry and exit.

use septum::prepared::PreparedRay;
use septum::{Aabb, Ray};
use septum_kit::lines::{Fraction, Line, LineBox, LineSet};
use septum_kit::{BoxNumbers, Each, Rng, Sample, for_every_scalar, three};

/// Rays and segments alike.
fn exact_on_every_set<S: Sample>() {
    for set in LineSet::ALL {
        let rng = &mut Rng::new(0xb0c5);
        let mut met = 0;
        for _ in 0..10_000 {
            let case = set.case::<S>(rng);
            let meets = case.meets();
            assert_eq!(case.overlaps(), meets, "{set:?}: {case:?}");
            assert!(case.may_overlap() || !meets, "{set:?}: {case:?}");
            met += usize::from(meets);
        }
        let both = matches!(set, LineSet::Far | LineSet::Small) || (200..9_800).contains(&met);
        assert!(both, "{set:?}: {met} meet");
    }
}

/// Correctly rounded in fixed point, within the bound in floats.
fn t_range_on_every_set<S: Sample>() {
    for set in LineSet::ALL {
        let rng = &mut Rng::new(0x7a9e);
        for _ in 0..10_000 {
            let case = set.case::<S>(rng);
            check_range(&case, set);
        }
    }
}
for_every_scalar!(exact_on_every_set, t_range_on_every_set, faces_on_a_grid);

fn check_range<S: Sample>(case: &LineBox<S>, set: LineSet) {
    let Some(ray) = case.ray() else { return };
    let found = ray.t_range(&case.aabb());
    check_faces(case);
    let expected = case.clip();
    assert_eq!(found.is_some(), expected.is_some(), "{set:?}: {case:?}");
    let (Some((enter, leave)), Some([Some(from), Some(to)])) = (found, expected) else { return };
    assert!(enter <= leave, "{case:?}");
    for (t, expected) in [(enter, from), (leave, to)] {
        assert!(is_rounded(t, &expected), "{set:?}: {t:?} of {case:?}");
    }
}

/// The faces of entry and exit, with t as of `t_range`.
fn check_faces<S: Sample>(case: &LineBox<S>) -> Option<[Option<u8>; 2]> {
    let (ray, aabb) = (case.ray()?, case.aabb());
    let (found, expected) = (ray.crossings(&aabb), case.faces());
    assert_eq!(found.map(|both| both.each(|one| one.face)), expected, "{case:?}");
    let range = found.map(|[enter, leave]| (enter.t, leave.t));
    assert_eq!(range, ray.t_range(&aabb), "{case:?}");
    assert_eq!(PreparedRay::new(&ray).crossings(&aabb), found, "{case:?}");
    for crossing in found.into_iter().flatten() {
        let normal = crossing.normal(&aabb).map(|n| n.to_array().each(S::approximate));
        let expected = crossing.face.map(|face| {
            let mut unit = [0.0; 3];
            unit[usize::from(face / 2)] = if face % 2 == 0 { -1.0 } else { 1.0 };
            unit
        });
        let has_one = S::nearest(1.0).approximate() == 1.0;
        assert!(!has_one || normal == expected, "{crossing:?}");
    }
    expected
}

/// From each point of a small grid in each direction of one: through faces, edges and corners,
/// along them, and from on and in the box, within ranges that begin and end anywhere.
fn faces_on_a_grid<S: Sample>() {
    let digits = |n: usize| [n % 5, n / 5 % 5, n / 25 % 5];
    let (mut seen, mut inside, mut shared) = ([[0; 2]; 6], 0, 0);
    let whole = |x: f64| S::nearest(x / 4.0);
    let corners = [[-1.0, -1.0, -1.0], [1.0, 1.0, 0.0]].each(|p| p.each(whole));
    let flat = [[-1.0, 0.0, -1.0], [1.0, 0.0, 1.0]].each(|p| p.each(whole));
    let ends = [-1.0, 0.0, 0.25, 0.5, 1.0].map(S::nearest);
    for n in 0..125 * 125 {
        let at = |n: usize| digits(n).each(|x| whole(x as f64 - 2.0));
        let (origin, d) = (at(n % 125), at(n / 125));
        let range = match n % 4 {
            0 => [Some(S::ZERO), None],
            1 => [None, None],
            2 => [Some(ends[n % 5]), None],
            _ => [Some(ends[0]), Some(ends[1 + n / 5 % 4])],
        };
        let line = Line::Ray(origin, d, range);
        for [min, max] in [corners, flat] {
            let half = [0, 1, 2]
                .each(|i: usize| S::nearest((max[i].approximate() - min[i].approximate()) / 2.0));
            let center = three(|i: usize| S::nearest(min[i].approximate() + half[i].approximate()));
            for aabb in [BoxNumbers::Corners(min, max), BoxNumbers::Center(center, half)] {
                if line.ray().is_none() {
                    continue;
                }
                let case = LineBox { line, aabb };
                let Some(faces) = check_faces(&case) else { continue };
                for (k, face) in faces.into_iter().enumerate() {
                    match face {
                        None => inside += 1,
                        Some(face) => seen[usize::from(face)][k] += 1,
                    }
                }
                shared += usize::from(faces[0].is_some() && faces[0] == faces[1].map(|f| f ^ 1));
            }
        }
    }
    assert!(seen.as_flattened().iter().all(|&n| n > 100) && inside > 1_000, "{seen:?} {inside}");
    assert!(shared > 100, "{shared}");
}

fn is_rounded<S: Sample>(t: S, expected: &Fraction) -> bool {
    let is_float = S::ZERO.moved(1).approximate() < 1e-30;
    if !is_float {
        return t == expected.nearest_fixed();
    }
    if !t.is_finite() {
        return true; // beyond the range; the next test has the bound
    }
    let bound = if S::name() == "f32" { (51, 100) } else { (16, 10) };
    expected.is_within(t, bound)
}

/// Every coordinate of an 8-bit type, for an origin and a direction on one axis; and every pair of
/// directions on two axes.
#[test]
fn t_is_rounded_to_the_nearest_for_all_of_i4f4() {
    use fixed::types::I4F4;
    let all = || (i8::MIN..=i8::MAX).map(I4F4::from_bits);
    let zero = I4F4::ZERO;
    let (min, max) = (I4F4::from_num(-1.25), I4F4::from_num(2.0625));
    let aabb = Aabb::from_min_max([min; 3], [max; 3]).unwrap();
    let expect = |case: &LineBox<I4F4>| case.clip().map(|[a, b]| (a.unwrap(), b.unwrap()));
    let check = |o: [I4F4; 3], d: [I4F4; 3]| {
        let range = [None, None];
        let line = Line::Ray(o, d, range);
        let case = LineBox { line, aabb: BoxNumbers::Corners([min; 3], [max; 3]) };
        let ray = Ray::new(o, d).unwrap().with_range(None, None).unwrap();
        let expected = expect(&case).map(|(a, b)| (a.nearest_fixed(), b.nearest_fixed()));
        assert_eq!(ray.t_range(&aabb), expected, "{case:?}");
    };
    for o in all() {
        for d in all().filter(|&d| d != zero) {
            check([zero, o, zero], [zero, d, zero]);
        }
    }
    for x in all() {
        for y in all().filter(|&y| x != zero || y != zero) {
            check([I4F4::from_num(-2), zero, zero], [x, y, zero]);
        }
    }
}

#[test]
fn ranges_end_where_they_say() {
    let cell = Aabb::from_min_max([1.0, 0.0, 0.0], [2.0, 1.0, 1.0]).unwrap();
    let ray = Ray::new([0.0, 0.5, 1.0], [0.5, -0.0, 0.0]).unwrap();
    let met =
        |from: Option<f64>, to: Option<f64>| ray.with_range(from, to).unwrap().overlaps(&cell);
    let below = 2.0_f64.next_down();
    assert!(met(None, Some(2.0)) && !met(None, Some(below)));
    assert!(met(Some(4.0), None) && !met(Some(4.0_f64.next_up()), None));
    assert!(
        met(Some(2.0), Some(2.0)) && met(Some(-9.0), Some(9.0)) && !met(Some(-9.0), Some(-1.0))
    );
    assert_eq!(ray.t_range(&cell), Some((2.0, 4.0)));
    assert_eq!(ray.with_range(3.0, 9.0).unwrap().t_range(&cell), Some((3.0, 4.0)));
    assert_eq!(ray.with_range(5.0, 9.0).unwrap().t_range(&cell), None);
}

/// The distance from one end of the range to the other exceeds the range, yet t is 2.
#[test]
fn a_difference_may_overflow_where_t_does_not() {
    fn check<S: Sample>() {
        let (zero, one, end) = (S::ZERO, S::nearest(1.0), S::GREATEST);
        let box_to = |x: S| Aabb::from_min_max([S::LEAST, zero, zero], [x, zero, zero]).unwrap();
        let ray = Ray::new([end, zero, zero], [S::LEAST, zero, zero]).unwrap();
        let line = ray.with_range(None, None).unwrap();
        let two = S::nearest(2.0);
        assert_eq!(line.t_range(&box_to(zero)), Some((one, two)));
        assert_eq!(line.t_range(&box_to(S::LEAST)), Some((two, two)));
        assert_eq!(ray.with_range(None, one).unwrap().t_range(&box_to(zero)), Some((one, one)));
    }
    check::<f32>();
    check::<f64>();
}

/// No number is above this t, so its error is measured in the last place below.
#[test]
fn t_may_be_the_greatest_number() {
    fn check<S: Sample>() {
        let (x, zero) = (S::nearest(1.75), S::ZERO);
        let case = LineBox {
            line: Line::Ray([x; 3], [S::nearest(-1.0), zero, zero], [None; 2]),
            aabb: BoxNumbers::Corners([S::LEAST, zero, zero], [zero, x, x]),
        };
        let (_, leave) = case.ray().unwrap().t_range(&case.aabb()).unwrap();
        assert_eq!(leave, S::GREATEST);
        let [_, truth] = case.clip().unwrap();
        let truth = truth.unwrap();
        assert!(truth.is_within(leave, (1, 100)));
        assert!(!truth.is_within(leave.moved(-1), (99, 100)));
    }
    check::<f32>();
    check::<f64>();
}

/// A range in fixed point counts in the scalar's own unit, for every position of the point.
#[test]
fn ranges_have_the_scalars_unit() {
    use fixed::types::{I0F8, I0F32, I0F64, I1F7, I8F0, I16F16, I32F0, I64F0};
    fn check<S: Sample>() {
        let rng = &mut Rng::new(0x017);
        for set in [LineSet::Bits, LineSet::Huge] {
            for _ in 0..10_000 {
                let case = set.case::<S>(rng);
                assert_eq!(case.overlaps(), case.meets(), "{}: {case:?}", S::name());
                check_range(&case, set);
            }
        }
    }
    check::<I0F8>();
    check::<I1F7>();
    check::<I8F0>();
    check::<I16F16>();
    check::<I0F32>();
    check::<I32F0>();
    check::<I0F64>();
    check::<I64F0>();
}
