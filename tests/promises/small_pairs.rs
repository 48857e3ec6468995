//! Boxes against boxes and points, and bounding boxes, compared with integers of any size.

use dashu_int::IBig;
use septum::{Aabb, Obb, Overlaps};
use septum_kit::{BoxNumbers, Rng, Sample, for_every_scalar};

type Point<S> = [S; 3];

/// The exponent of a power of two that divides every number, and one.
struct Unit(i32);

impl Unit {
    fn of<S: Sample>(rows: &[Point<S>]) -> Self {
        let parts = rows.iter().flatten().map(|x| x.mantissa_exponent());
        Self(parts.filter(|x| x.0 != 0).map(|x| x.1).min().unwrap_or(0).min(0))
    }
    fn whole<S: Sample>(&self, x: S) -> IBig {
        let (m, e) = x.mantissa_exponent();
        if m == 0 { IBig::ZERO } else { IBig::from(m) << (e - self.0) as usize }
    }
}

fn rows<S: Sample>(b: &BoxNumbers<S>) -> [Point<S>; 2] {
    let (BoxNumbers::Center(p, q) | BoxNumbers::Corners(p, q)) = *b;
    [p, q]
}

/// The two ends of a box on axis `i`.
fn ends<S: Sample>(b: &BoxNumbers<S>, unit: &Unit, i: usize) -> [IBig; 2] {
    let [p, q] = rows(b).map(|row| unit.whole(row[i]));
    match b {
        BoxNumbers::Center(..) => [&p - &q, p + q],
        BoxNumbers::Corners(..) => [p, q],
    }
}

/// Whether clipping one box by the other leaves a point: on each axis, from the greater lower end
/// to the lesser upper end.
fn boxes_meet<S: Sample>(a: &BoxNumbers<S>, b: &BoxNumbers<S>) -> bool {
    let unit = Unit::of(&[rows(a), rows(b)].concat());
    (0..3).all(|i| {
        let ([a, b], [c, d]) = (ends(a, &unit, i), ends(b, &unit, i));
        a.max(c) <= b.min(d)
    })
}

/// The distribution of numbers.
#[derive(Clone, Copy, Debug)]
enum Regime {
    Grid,
    Near,
    Far,
    Tiny,
    Extreme,
    Any,
}

const REGIMES: [Regime; 6] =
    [Regime::Grid, Regime::Near, Regime::Far, Regime::Tiny, Regime::Extreme, Regime::Any];

fn number<S: Sample>(rng: &mut Rng, regime: Regime) -> S {
    match regime {
        Regime::Grid => S::whole(rng.whole(-4, 4)),
        Regime::Near => S::nearest(rng.real(-2.0, 2.0)),
        Regime::Far => S::nearest(1e5 + rng.real(-2.0, 2.0)).moved(rng.whole(-9, 9)),
        Regime::Tiny => S::from_ordinal(rng.whole(-9, 9)),
        Regime::Extreme => match rng.below(3) {
            0 => S::LEAST.moved(rng.whole(0, 3)),
            1 => S::GREATEST.moved(-rng.whole(0, 3)),
            _ => S::nearest(rng.real(-1.0, 1.0) * S::GREATEST.approximate()),
        },
        Regime::Any => {
            let greatest = S::GREATEST.ordinal();
            S::from_ordinal(rng.whole(-greatest, greatest))
        }
    }
}

fn magnitude<S: Sample>(x: S) -> S {
    S::from_ordinal(x.ordinal().saturating_abs())
}

fn a_box<S: Sample>(rng: &mut Rng, regime: Regime) -> BoxNumbers<S> {
    let p = rng.triple(|rng| number::<S>(rng, regime));
    let q = rng.triple(|rng| number::<S>(rng, regime));
    if rng.one_in(2) {
        // Half-extents of far boxes are near zero.
        let small = if matches!(regime, Regime::Far) { Regime::Near } else { regime };
        let half = rng.triple(|rng| magnitude(number::<S>(rng, small)));
        return BoxNumbers::Center(p, half);
    }
    let ordered = |i: usize| if p[i] <= q[i] { (p[i], q[i]) } else { (q[i], p[i]) };
    let all = [0, 1, 2].map(ordered);
    BoxNumbers::Corners(all.map(|x| x.0), all.map(|x| x.1))
}

fn check_boxes<S: Sample>(a: &BoxNumbers<S>, b: &BoxNumbers<S>) -> bool {
    let (p, q) = (a.shape().unwrap(), b.shape().unwrap());
    let meet = boxes_meet(a, b);
    assert_eq!(p.overlaps(&q), meet, "{} {a:?} {b:?}", S::name());
    assert_eq!(q.overlaps(&p), meet, "{} {b:?} {a:?}", S::name());
    assert!(!meet || p.may_overlap(&q), "{} {a:?} {b:?}", S::name());
    meet
}

/// Two boxes of each kind, and both sides of the place where one number makes them touch.
fn boxes<S: Sample>() {
    let mut rng = Rng::new(0xb0b0);
    for regime in REGIMES {
        let (mut met, mut flips) = (0, 0);
        for _ in 0..20_000 {
            let (a, b) = (a_box::<S>(&mut rng, regime), a_box::<S>(&mut rng, regime));
            met += usize::from(check_boxes(&a, &b));
            flips += usize::from(rng.one_in(8) && touch(&mut rng, &a, &b));
        }
        assert!(met > 100, "{} {regime:?}: {met} met", S::name());
        assert!(
            flips > 20 || matches!(regime, Regime::Extreme),
            "{} {regime:?}: {flips}",
            S::name()
        );
    }
}

/// Moves one number of `b` until the verdict flips, and checks both sides; returns whether it
/// flips.
fn touch<S: Sample>(rng: &mut Rng, a: &BoxNumbers<S>, b: &BoxNumbers<S>) -> bool {
    let i = rng.below(3);
    let with = |n: i64| {
        let mut b = *b;
        let is_center = matches!(b, BoxNumbers::Center(..));
        let (BoxNumbers::Center(p, q) | BoxNumbers::Corners(p, q)) = &mut b;
        p[i] = S::from_ordinal(n);
        let is_box = is_center || p[i] <= q[i];
        is_box.then_some(b)
    };
    let start = rows(b)[0][i].ordinal();
    let end = match b {
        BoxNumbers::Center(..) => rows(a)[0][i].ordinal(),
        BoxNumbers::Corners(..) => rows(b)[1][i].ordinal(),
    };
    let verdict = |n: i64| with(n).map(|b| boxes_meet(a, &b));
    let (Some(first), Some(last)) = (verdict(start), verdict(end)) else { return false };
    if first == last {
        return false;
    }
    let (mut from, mut to) = (i128::from(start), i128::from(end));
    while (to - from).abs() > 1 {
        let middle = (from + to) >> 1;
        if verdict(middle as i64) == Some(first) { from = middle } else { to = middle }
    }
    for n in [from, to] {
        check_boxes(a, &with(n as i64).unwrap());
    }
    true
}

/// All intervals on a small grid along one axis, in all forms.
fn intervals<S: Sample>() {
    let mut all = Vec::new();
    for p in -3..=3 {
        for q in 0..=3 {
            let row = |n: i64| [S::whole(0), S::whole(n), S::whole(0)];
            all.push(BoxNumbers::Center(row(p), row(q)));
            if p <= q {
                all.push(BoxNumbers::Corners(row(p), row(q)));
            }
        }
    }
    let met = all.iter().flat_map(|a| all.iter().map(move |b| check_boxes(a, b)));
    let met = met.filter(|met| *met).count();
    assert!(met > 100 && met < all.len() * all.len() - 100);
}

fn points<S: Sample>() {
    let mut rng = Rng::new(0x9017);
    for regime in REGIMES {
        let mut inside = 0;
        for _ in 0..8_000 {
            let b = a_box::<S>(&mut rng, regime);
            let p = match rng.below(3) {
                // Next to a face, as near as the scalar allows.
                0 => {
                    let unit = Unit::of(&rows(&b));
                    let mut p = rows(&b)[0];
                    let i = rng.below(3);
                    let x = ends(&b, &unit, i)[rng.below(2)].to_f64().value();
                    p[i] = S::nearest(x * 2_f64.powi(unit.0)).moved(rng.whole(-2, 2));
                    p
                }
                _ => rng.triple(|rng| number::<S>(rng, regime)),
            };
            let expected = boxes_meet(&b, &BoxNumbers::Corners(p, p));
            assert_eq!(b.shape().unwrap().contains(p), expected, "{} {b:?} {p:?}", S::name());
            inside += usize::from(expected);
        }
        assert!(inside > 50, "{} {regime:?}: {inside} inside", S::name());
    }
}

for_every_scalar!(boxes, intervals, points);

#[test]
fn no_point_is_where_a_coordinate_is_no_number() {
    let by_corners = Aabb::from_min_max([f32::MIN; 3], [f32::MAX; 3]).unwrap();
    let by_center = Aabb::from_center_half_extents([0.0_f32; 3], [f32::MAX; 3]).unwrap();
    let axes = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
    let oriented = Obb::new([0.0_f32; 3], axes, [f32::MAX; 3]).unwrap();
    for x in [f32::NAN, f32::INFINITY, f32::NEG_INFINITY] {
        for i in 0..3 {
            let mut p = [0.0; 3];
            assert!(by_corners.contains(p) && by_center.contains(p) && oriented.contains(p));
            p[i] = x;
            assert!(!by_corners.contains(p) && !by_center.contains(p) && !oriented.contains(p));
        }
    }
}

/// Generic functions need the trait; the inherent methods do not.
fn count<S: Sample, T: Overlaps<Aabb<S>>>(shapes: &[T], cell: &Aabb<S>) -> usize {
    shapes.iter().filter(|shape| shape.overlaps(cell)).count()
}

#[test]
fn boxes_are_counted_like_other_shapes() {
    let cell = |x: f64| Aabb::from_min_max([x; 3], [x + 1.0; 3]).unwrap();
    assert_eq!(count(&[cell(0.0), cell(1.0), cell(2.5)], &cell(1.0)), 2);
}
