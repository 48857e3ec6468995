//! Boxes against boxes and points, and bounding boxes, compared with integers of any size.

use septum::{Aabb, Obb, Overlaps};
use septum_kit::aabbs::{AabbPair, AabbSet, ends_of};
use septum_kit::flat::Truth;
use septum_kit::{BoxNumbers, Each, Rng, Sample, for_every_scalar};

/// The centre or the least corner, by the form of the box.
fn start<S: Copy>(aabb: &BoxNumbers<S>) -> [S; 3] {
    let (BoxNumbers::Center(p, _) | BoxNumbers::Corners(p, _)) = *aabb;
    p
}

/// Two boxes of each set, and both sides of the place where one number makes them touch.
fn boxes<S: Sample>() {
    let mut rng = Rng::new(0xb0b0);
    let mut seen = [0; 3];
    for set in AabbSet::ALL {
        let (mut met, mut flips) = (0, 0);
        for _ in 0..20_000 {
            let pair = set.case::<S>(&mut rng);
            let truth = pair.check();
            seen[truth as usize] += 1;
            met += usize::from(truth != Truth::Apart);
            flips += usize::from(rng.one_in(8) && touch(&mut rng, &pair));
        }
        assert!(met > 100, "{} {set:?}: {met} met", S::name());
        assert!(flips > 20 || set == AabbSet::Extreme, "{} {set:?}: {flips}", S::name());
    }
    assert!(seen.iter().all(|&n| n > 1_000), "{}: {seen:?}", S::name());
}

/// Moves one number of the second box until the verdict flips, and checks both sides; returns
/// whether it flips.
fn touch<S: Sample>(rng: &mut Rng, pair: &AabbPair<S>) -> bool {
    let (i, [a, b]) = (rng.below(3), pair.boxes);
    let with = |n: i64| {
        let mut b = b;
        let is_center = matches!(b, BoxNumbers::Center(..));
        let (BoxNumbers::Center(p, q) | BoxNumbers::Corners(p, q)) = &mut b;
        p[i] = S::from_ordinal(n);
        let is_box = is_center || p[i] <= q[i];
        is_box.then_some(AabbPair { boxes: [a, b] })
    };
    let first = start(&b)[i].ordinal();
    let end = match b {
        BoxNumbers::Center(..) => start(&a)[i].ordinal(),
        BoxNumbers::Corners(_, greatest) => greatest[i].ordinal(),
    };
    let verdict = |n: i64| with(n).map(|pair| pair.truth() != Truth::Apart);
    let (mut from, mut to) = (i128::from(first), i128::from(end));
    let (Some(first), Some(last)) = (verdict(first), verdict(end)) else { return false };
    if first == last {
        return false;
    }
    while (to - from).abs() > 1 {
        let middle = (from + to) >> 1;
        if verdict(middle as i64) == Some(first) { from = middle } else { to = middle }
    }
    for n in [from, to] {
        with(n as i64).unwrap().check();
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
    let mut seen = [0; 3];
    for &a in &all {
        for &b in &all {
            seen[AabbPair { boxes: [a, b] }.check() as usize] += 1;
        }
    }
    assert!(seen.iter().all(|&n| n > 100), "{seen:?}");
}

fn points<S: Sample>() {
    let mut rng = Rng::new(0x9017);
    for set in AabbSet::ALL {
        let mut inside = 0;
        for _ in 0..8_000 {
            let b = set.aabb::<S>(&mut rng);
            let p = match rng.below(3) {
                // Next to a face, as near as the scalar allows.
                0 => {
                    let (mut p, i) = (start(&b), rng.below(3));
                    let x = ends_of(&b, i)[rng.below(2)];
                    p[i] = S::nearest(x).moved(rng.whole(-2, 2));
                    p
                }
                _ => rng.triple(|rng| set.number::<S>(rng)),
            };
            let pair = AabbPair { boxes: [b, BoxNumbers::Corners(p, p)] };
            let expected = pair.truth() != Truth::Apart;
            assert_eq!(b.shape().unwrap().contains(p), expected, "{} {b:?} {p:?}", S::name());
            inside += usize::from(expected);
        }
        assert!(inside > 50, "{} {set:?}: {inside} inside", S::name());
    }
}

for_every_scalar!(boxes, intervals, points);

/// The distance is beyond the numbers of the scalar: the gap and its error bound are infinite.
#[test]
fn boxes_a_range_apart_are_disjoint() {
    fn check<S: Sample>(far: f64) {
        let at = |p: [f64; 3]| p.each(S::nearest);
        let corners = BoxNumbers::Corners(at([far, 0.0, 0.0]), at([1.067 * far, 1.0, 1.0]));
        let center = BoxNumbers::Center(at([-far, 0.5, 0.5]), at([0.0, 0.5, 0.5]));
        assert_eq!(AabbPair { boxes: [corners, center] }.check(), Truth::Apart);
    }
    check::<f32>(3e38);
    check::<f64>(1e308);
}

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
