//! A prepared ray against boxes: the answers of the oracle, and of the unprepared ray.

use septum::prepared::PreparedRay;
use septum_kit::lines::{Line, LineBox, LineSet};
use septum_kit::{BoxNumbers, Each, Rng, Sample, for_every_scalar, three};

/// Compares the oracle, the ray and the prepared ray.
fn check<S: Sample>(case: &LineBox<S>, meets: bool) {
    let (ray, aabb) = (case.ray().unwrap(), case.aabb());
    let prepared = PreparedRay::new(&ray);
    assert_eq!(prepared.overlaps(&aabb), meets, "{}: {case:?}", S::name());
    assert_eq!(prepared.overlaps(&aabb), ray.overlaps(&aabb), "{}: {case:?}", S::name());
    assert_eq!(prepared.t_range(&aabb), ray.t_range(&aabb), "{}: {case:?}", S::name());
}

fn exact_on_every_set<S: Sample>() {
    for set in LineSet::ALL {
        let rng = &mut Rng::new(0x9e9a);
        let (mut rays, mut met) = (0, 0);
        for _ in 0..12_000 {
            let case = set.case::<S>(rng);
            if case.ray().is_none() {
                continue;
            }
            let meets = case.meets();
            check(&case, meets);
            (rays, met) = (rays + 1, met + usize::from(meets));
        }
        let both = matches!(set, LineSet::Far | LineSet::Small) || (200..rays - 200).contains(&met);
        assert!(both, "{set:?}: {met} of {rays} meet");
    }
}
for_every_scalar!(exact_on_every_set);

/// All origins and directions of {−1, 0, 1}³ against all boxes of {−1, 0, 1}³, including flat boxes
/// and points, by corners and by centre, with ranges from 0 and up to 1/2: 600,000 cases, most of
/// them in contact, in `f32` and in one other scalar in turn. Half-extents of 1/2 need a type with
/// fraction bits.
#[test]
fn the_smallest_grid() {
    use fixed::types::{I4F4, I16F16, I32F32};
    let triples = |n: i64| {
        let side = 2 * n + 1;
        (0..side.pow(3)).map(move |k| [k / side / side, k / side % side, k % side].each(|x| x - n))
    };
    let corners = || triples(1).flat_map(|a| triples(1).map(move |b| (a, b)));
    let boxes: Vec<_> = corners().filter(|(a, b)| (0..3).all(|i| a[i] <= b[i])).collect();
    assert_eq!(boxes.len(), 216);
    let (mut cases, mut met) = (0, 0);
    for d in triples(1).filter(|d| *d != [0; 3]) {
        for o in triples(1) {
            for (min, max) in &boxes {
                for to in [None, Some(0.5)] {
                    let numbers = Numbers { o, d, min: *min, max: *max, to };
                    let meets = numbers.case::<f64>(true).meets();
                    for by_corners in [true, false] {
                        check(&numbers.case::<f32>(by_corners), meets);
                        // Four cases differ in the form of the box and in the range.
                        match (cases + cases / 4) % 4 {
                            0 => check(&numbers.case::<f64>(by_corners), meets),
                            1 => check(&numbers.case::<I4F4>(by_corners), meets),
                            2 => check(&numbers.case::<I16F16>(by_corners), meets),
                            _ => check(&numbers.case::<I32F32>(by_corners), meets),
                        }
                        cases += 1;
                        met += usize::from(meets);
                    }
                }
            }
        }
    }
    assert_eq!(cases, 606_528);
    assert!((50_000..550_000).contains(&met), "{met}");
}

struct Numbers {
    o: [i64; 3],
    d: [i64; 3],
    min: [i64; 3],
    max: [i64; 3],
    to: Option<f64>,
}

impl Numbers {
    fn case<S: Sample>(&self, by_corners: bool) -> LineBox<S> {
        let (min, max) = (self.min.each(|x| x as f64), self.max.each(|x| x as f64));
        let half = |sign: f64| three(|i: usize| S::nearest((max[i] + sign * min[i]) / 2.0));
        let plain = |v: [f64; 3]| v.each(S::nearest);
        LineBox {
            line: Line::Ray(
                self.o.each(|x| S::nearest(x as f64)),
                self.d.each(|x| S::nearest(x as f64)),
                [Some(S::ZERO), self.to.map(S::nearest)],
            ),
            aabb: if by_corners {
                BoxNumbers::Corners(plain(min), plain(max))
            } else {
                BoxNumbers::Center(half(1.0), half(-1.0))
            },
        }
    }
}

/// Numbers of all magnitudes, with ranges of all kinds: t that overflows or underflows, directions
/// without a reciprocal.
fn exact_at_every_magnitude<S: Sample>(exponents: [i64; 2]) {
    let rng = &mut Rng::new(0xed6e);
    let power = |rng: &mut Rng, [low, high]: [i64; 2]| {
        let mut x = rng.real(1.0, 2.0);
        let e = rng.whole(low, high);
        // As two factors, because either may be subnormal.
        x *= 2_f64.powi((e / 2) as i32) * 2_f64.powi((e - e / 2) as i32);
        S::nearest([x, -x, 0.0][rng.below(3)])
    };
    let narrow = exponents.each(|e| e / 8);
    let mut met = 0;
    for k in 0..120_000 {
        // Sometimes an invertible direction, against any box.
        let along = if k % 2 == 0 { narrow } else { exponents };
        let mut row = |ends: [i64; 2]| rng.triple(|rng| power(rng, ends));
        let (o, d, p, q, t) =
            (row(exponents), row(along), row(exponents), row(exponents), row(exponents));
        let aabb = if k % 3 == 0 {
            BoxNumbers::Center(
                p,
                q.each(|x| if x < S::ZERO { S::nearest(-x.approximate()) } else { x }),
            )
        } else {
            let least = |i: usize| if p[i] < q[i] { p[i] } else { q[i] };
            let greatest = |i: usize| if p[i] < q[i] { q[i] } else { p[i] };
            BoxNumbers::Corners(three(least), three(greatest))
        };
        let ends = match k % 7 {
            0 => [None, None],
            1 => [None, Some(t[0])],
            2 => [Some(t[0]), None],
            3 if t[0] <= t[1] => [Some(t[0]), Some(t[1])],
            _ => [Some(S::ZERO), None],
        };
        if d == [S::ZERO; 3] {
            continue;
        }
        let case = LineBox { line: Line::Ray(o, d, ends), aabb };
        let meets = case.meets();
        check(&case, meets);
        met += usize::from(meets);
    }
    assert!(met > 5_000, "{met}");
}

#[test]
fn exact_at_every_magnitude_of_f32() {
    exact_at_every_magnitude::<f32>([-149, 127]);
}

#[test]
fn exact_at_every_magnitude_of_f64() {
    exact_at_every_magnitude::<f64>([-1074, 1023]);
}

/// Small integers times the least number, or nearly the greatest, along directions of every size:
/// contact of every kind where t would underflow or overflow. The range begins at 0 or at −0.
fn exact_in_contact_at_the_ends<S: Sample>(coordinates: [i32; 3], directions: [i32; 5]) {
    let rng = &mut Rng::new(0x0e4d);
    let mut met = 0;
    for k in 0..120_000 {
        let (a, b) = (coordinates[k % 3], directions[k / 3 % 5]);
        // As two factors, because either may be subnormal.
        let times =
            |x: i64, e: i32| S::nearest(x as f64 * 2_f64.powi(e / 2) * 2_f64.powi(e - e / 2));
        let (o, p, q) = (
            rng.triple(|rng| rng.whole(-3, 3)),
            rng.triple(|rng| rng.whole(-3, 3)),
            rng.triple(|rng| rng.whole(0, 3)),
        );
        let d = rng.triple(|rng| rng.whole(-3, 3));
        if d == [0; 3] {
            continue;
        }
        let at = |v: [i64; 3]| v.each(|x| times(x, a));
        let aabb = if k % 2 == 0 {
            BoxNumbers::Center(at(p), at(q))
        } else {
            BoxNumbers::Corners(at(p), at(three(|i: usize| p[i] + q[i])))
        };
        let zero = if k % 7 == 0 { S::nearest(-0.0) } else { S::ZERO };
        let line = Line::Ray(at(o), d.each(|x| times(x, b)), [Some(zero), None]);
        let case = LineBox { line, aabb };
        let meets = case.meets();
        check(&case, meets);
        met += usize::from(meets);
    }
    assert!((10_000..110_000).contains(&met), "{met}");
}

#[test]
fn exact_in_contact_at_the_ends_of_f32() {
    exact_in_contact_at_the_ends::<f32>([-149, -126, 125], [-41, -38, 0, 37, 40]);
}

#[test]
fn exact_in_contact_at_the_ends_of_f64() {
    exact_in_contact_at_the_ends::<f64>([-1074, -1022, 1020], [-402, -390, 0, 390, 400]);
}

/// A ray from the world's origin through the corner of a box, and the corner moved by one unit in
/// the last place: the two values of t are as close as possible.
fn exact_next_to_corners<S: Sample>() {
    let rng = &mut Rng::new(0xc042);
    let mut met = 0;
    for k in 0..20_000 {
        let size = S::GREATEST.approximate().min(16.0);
        let corner = rng.triple(|rng| S::nearest(rng.real(size / 16.0, size / 4.0)));
        // In half of the cases the direction is the corner itself, with t = 1 on all axes;
        // otherwise it is rounded.
        let scale = if k % 2 == 0 { 1.0 } else { rng.real(0.5, 1.0) };
        let d = corner.each(|x| S::nearest(x.approximate() * scale));
        let side = rng.triple(|rng| rng.one_in(2));
        let (mut min, mut max) = (corner, corner);
        for i in 0..3 {
            let moved = corner[i].moved(rng.whole(-1, 1));
            let far = S::nearest(corner[i].approximate() + if side[i] { 1.0 } else { -1.0 });
            (min[i], max[i]) = if far < moved { (far, moved) } else { (moved, far) };
        }
        let line = Line::Ray([S::ZERO; 3], d, [Some(S::ZERO), None]);
        let case = LineBox { line, aabb: BoxNumbers::Corners(min, max) };
        let meets = case.meets();
        check(&case, meets);
        met += usize::from(meets);
    }
    assert!((4_000..19_000).contains(&met), "{}: {met}", S::name());
}
for_every_scalar!(exact_next_to_corners);
