//! The rounded and the conservative methods of rays and segments against boxes: right if components
//! are zero and the numbers are small integers, and the conservative ones never lose a box.

use fixed::types::{I8F8, I16F16, I32F32};
use septum::prepared::PreparedRay;
use septum::published;
use septum::published::slabs::SlabRay;
use septum::published::slopes::SlopeRay;
use septum_kit::lines::{Line, LineBox, LineSet};
use septum_kit::{BoxNumbers, Each, Rng, Sample, for_every_scalar, three};

/// 60 directions with one or two zero components, 125 origins, 9 boxes in two forms: 135,000 cases,
/// many with the origin in the plane of a face. Floats repeat them with negative zeros.
fn components_of_zero<S: Sample>(zero: S) {
    let number = |n: i64| if n == 0 { zero } else { S::nearest(n as f64) };
    let plain = |n: f64| S::nearest(n);
    let boxes = [
        ([-1.0, -1.0, -1.0], [1.0, 1.0, 1.0]),
        ([0.0, 0.0, 0.0], [1.0, 1.0, 1.0]),
        ([0.0, -1.0, -1.0], [0.0, 1.0, 1.0]),
        ([-1.0, 1.0, -1.0], [1.0, 1.0, 1.0]),
        ([-1.0, -1.0, -1.0], [1.0, 1.0, -1.0]),
        ([1.0, 0.0, -1.0], [1.0, 0.0, 1.0]),
        ([-1.0, 1.0, 1.0], [1.0, 1.0, 1.0]),
        ([1.0, 1.0, 0.0], [1.0, 1.0, 0.0]),
        ([0.0, 0.0, 0.0], [0.0, 0.0, 0.0]),
    ];
    let (mut cases, mut met) = (0, 0);
    let triples = || (0..125).map(|n| [n / 25, n / 5 % 5, n % 5].each(|k| [0, 1, -1, 2, -2][k]));
    let directions = triples().filter(|d| d.contains(&0) && *d != [0; 3]);
    for d in directions {
        for o in triples() {
            for (min, max) in boxes {
                let center = three(|i: usize| plain((min[i] + max[i]) / 2.0));
                let half = three(|i: usize| plain((max[i] - min[i]) / 2.0));
                let forms = [
                    BoxNumbers::Corners(min.each(plain), max.each(plain)),
                    BoxNumbers::Center(center, half),
                ];
                let ray = Line::Ray(o.each(number), d.each(number), [Some(S::ZERO), None]);
                let meets = LineBox { line: ray, aabb: forms[0] }.meets();
                let segment = Line::Center(o.each(number), d.each(number));
                let segment_meets = LineBox { line: segment, aabb: forms[0] }.meets();
                for aabb in forms {
                    check_all(&LineBox { line: ray, aabb }, meets);
                    let case = LineBox { line: segment, aabb };
                    let (shape, cell) = (case.segment().unwrap(), case.aabb());
                    assert_eq!(
                        published::separating_axes::segment_overlaps(&shape, &cell),
                        segment_meets,
                        "{case:?}"
                    );
                    assert_eq!(shape.overlaps(&cell), segment_meets, "{case:?}");
                    cases += 1;
                    met += usize::from(meets);
                }
            }
        }
    }
    assert!(cases == 135_000 && met > 14_000, "{met} of {cases}");
}

fn check_all<S: Sample>(case: &LineBox<S>, meets: bool) {
    let (ray, aabb) = (case.ray().unwrap(), case.aabb());
    let (slabs, slopes) = (SlabRay::new(&ray), SlopeRay::new(&ray));
    assert_eq!(ray.overlaps(&aabb), meets, "exact: {case:?}");
    assert_eq!(
        published::separating_axes::ray_overlaps(&ray, &aabb),
        meets,
        "as published: {case:?}"
    );
    assert_eq!(slabs.overlaps_rounded(&aabb), meets, "slabs: {case:?}");
    assert_eq!(slopes.overlaps_rounded(&aabb), meets, "slopes: {case:?}");
    assert!(slabs.may_overlap(&aabb) || !meets, "conservative: {case:?}");
    assert_eq!(PreparedRay::new(&ray).overlaps(&aabb), meets, "prepared: {case:?}");
    let range = ray.t_range(&aabb);
    assert_eq!(slabs.t_range_rounded(&aabb), range, "slabs: {case:?}");
    assert_eq!(slopes.t_enter_rounded(&aabb), range.map(|t| t.0), "slopes: {case:?}");
}

mod zeros {
    use super::*;

    #[test]
    fn f32() {
        components_of_zero(0.0_f32);
    }
    #[test]
    fn f32_below() {
        components_of_zero(-0.0_f32);
    }
    #[test]
    fn f64() {
        components_of_zero(0.0_f64);
    }
    #[test]
    fn f64_below() {
        components_of_zero(-0.0_f64);
    }
    #[test]
    fn i8f8() {
        components_of_zero(I8F8::ZERO);
    }
    #[test]
    fn i16f16() {
        components_of_zero(I16F16::ZERO);
    }
    #[test]
    fn i32f32() {
        components_of_zero(I32F32::ZERO);
    }
}

/// The conservative methods lose nothing, on any set.
fn never_false_where_they_meet<S: Sample>() {
    for set in LineSet::ALL {
        let rng = &mut Rng::new(0x517e);
        for _ in 0..25_000 {
            let case = set.case::<S>(rng);
            let Some(ray) = case.ray() else { continue };
            let aabb = case.aabb();
            let maybe = SlabRay::new(&ray).may_overlap(&aabb);
            assert!(maybe || !case.overlaps(), "{set:?}: {case:?}");
        }
    }
}

/// Always answering `true` would never miss, so most random misses must be found; and the rounded
/// methods may fail in contact, but not on random input.
fn right_on_nearly_all_that_is_random<S: Sample>() {
    let is_float = S::ZERO.moved(1).approximate() < 1e-30;
    let rng = &mut Rng::new(0x4a11);
    let (mut total, mut wrong) = (0, [0; 4]);
    for _ in 0..40_000 {
        let case = LineSet::Random.case::<S>(rng);
        let Some(ray) = case.ray() else { continue };
        let (aabb, meets) = (case.aabb(), case.overlaps());
        let found = [
            SlabRay::new(&ray).may_overlap(&aabb),
            SlabRay::new(&ray).overlaps_rounded(&aabb),
            SlopeRay::new(&ray).overlaps_rounded(&aabb),
            published::separating_axes::ray_overlaps(&ray, &aabb),
        ];
        for (wrong, found) in wrong.iter_mut().zip(found) {
            *wrong += usize::from(found != meets);
        }
        total += 1;
    }
    // In fixed point only the first keeps a promise.
    let held = if is_float { &wrong[..] } else { &wrong[..1] };
    assert!(held.iter().all(|&wrong| wrong * 5_000 <= total), "{wrong:?} of {total}");
}

for_every_scalar!(never_false_where_they_meet, right_on_nearly_all_that_is_random);

/// Rays from within rounding of a corner of a box given by its centre: both ends of the interval
/// are near zero, and centre and half-extent cancel.
fn no_box_is_lost_at_its_corners<S: Sample>() {
    let rng = &mut Rng::new(0xc042);
    let mut met = 0;
    for _ in 0..60_000 {
        let c = rng.triple(|rng| S::nearest(rng.real(-3.0, 3.0)));
        let h = rng.triple(|rng| S::nearest(rng.real(0.0, 3.0)));
        let mut o = c;
        for i in 0..3 {
            let sign = if rng.one_in(2) { 1.0 } else { -1.0 };
            let corner = c[i].approximate() + sign * h[i].approximate();
            o[i] = S::nearest(corner).moved(rng.whole(-1, 1));
        }
        let d = rng.triple(|rng| S::nearest(rng.real(-1.0, 1.0)));
        let line = Line::Ray(o, d, [None, None]);
        let case = LineBox { line, aabb: BoxNumbers::Center(c, h) };
        if d != [S::ZERO; 3] && case.overlaps() {
            met += 1;
            assert!(SlabRay::new(&case.ray().unwrap()).may_overlap(&case.aabb()), "{case:?}");
        }
    }
    assert!(met > 5_000, "{met}");
}
for_every_scalar!(no_box_is_lost_at_its_corners);

/// Inputs for which t overflows, underflows or has no reciprocal.
#[test]
fn no_box_is_lost_at_the_ends_of_the_range() {
    let rng = &mut Rng::new(0xed6e);
    let power = |rng: &mut Rng| {
        let x = 2_f64.powi(rng.whole(-149, 127) as i32) as f32 * rng.real(1.0, 2.0) as f32;
        [x, -x, 0.0][rng.below(3)].clamp(f32::MIN, f32::MAX)
    };
    let mut met = 0;
    for _ in 0..200_000 {
        let (o, d) = (rng.triple(power), rng.triple(power));
        let (p, q) = (rng.triple(power), rng.triple(power));
        let aabb = if rng.one_in(2) {
            BoxNumbers::Center(p, q.each(f32::abs))
        } else {
            let (a, b) = (three(|i| p[i].min(q[i])), three(|i| p[i].max(q[i])));
            BoxNumbers::Corners(a, b)
        };
        if d == [0.0; 3] {
            continue;
        }
        let from = if rng.one_in(2) { Some(0.0) } else { None };
        let case = LineBox { line: Line::Ray(o, d, [from, None]), aabb };
        let meets = case.overlaps();
        met += usize::from(meets);
        assert!(SlabRay::new(&case.ray().unwrap()).may_overlap(&case.aabb()) || !meets, "{case:?}");
    }
    assert!(met > 10_000, "{met}");
}
