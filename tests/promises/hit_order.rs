//! Hits in their true order, compared with fractions of integers of any size.

use std::cmp::Ordering;

use dashu_int::IBig;
use septum::{Ray, Triangle};
use septum_kit::{Each, Ring, Rng, Sample, for_every_scalar};

type Point<S> = [S; 3];

/// The t of the plane of a triangle, as a fraction with a positive divisor.
fn fraction<S: Sample>(o: Point<S>, d: Point<S>, t: [Point<S>; 3], unit: i32) -> [IBig; 2] {
    let row = |p: &Point<S>| {
        p.each(|x| {
            let (m, e) = x.mantissa_exponent();
            if m == 0 { IBig::ZERO } else { IBig::from(m) << (e - unit) as usize }
        })
    };
    let ([a, b, c], o, d) = (t.each_ref().each(row), row(&o), row(&d));
    let n = IBig::cross(&IBig::difference(&b, &a), &IBig::difference(&c, &a));
    let (num, den) = (IBig::dot(&n, &IBig::difference(&a, &o)), IBig::dot(&n, &d));
    let sign = IBig::from(Ring::sign(&den));
    [num * &sign, den * sign]
}

fn expected<S: Sample>(o: Point<S>, d: Point<S>, a: [Point<S>; 3], b: [Point<S>; 3]) -> Ordering {
    let rows = [a.as_slice(), &b, &[o, d]].concat();
    let parts = rows.as_flattened().iter().map(|x| x.mantissa_exponent());
    let unit = parts.filter(|x| x.0 != 0).map(|x| x.1).min().unwrap_or(0);
    let ([p, q], [r, s]) = (fraction(o, d, a, unit), fraction(o, d, b, unit));
    (p * s).cmp(&(r * q))
}

fn order<S: Sample>() {
    let mut rng = Rng::new(0x50f7);
    let mut counts = [0; 3];
    let mut close = 0;
    for case in 0..12_000 {
        let scale = [1.0, 1e-3, 3.0][case % 3];
        let near = |rng: &mut Rng| S::nearest(rng.real(-scale, scale));
        let grid = |rng: &mut Rng| S::whole(rng.whole(-4, 4));
        let number = |rng: &mut Rng| if case % 2 == 0 { near(rng) } else { grid(rng) };
        let (o, d) = (rng.triple(number), rng.triple(number));
        let Ok(ray) = Ray::new(o, d) else { continue };
        let a = rng.triple(|rng| rng.triple(number));
        // The same triangle, rotated or mirrored; or moved by a unit or so; or any other.
        let mut b = a;
        b.rotate_left(rng.below(3));
        if rng.one_in(2) {
            b.swap(0, 1);
        }
        match rng.below(4) {
            0 => {}
            1 | 2 => {
                let x = &mut b[rng.below(3)][rng.below(3)];
                *x = x.moved(rng.whole(-2, 2));
            }
            _ => b = rng.triple(|rng| rng.triple(number)),
        }
        let shape = |[a, b, c]: [Point<S>; 3]| Triangle::new(a, b, c).unwrap();
        let (p, q) = (shape(a), shape(b));
        // The whole line, so that half of the triangles are not behind it.
        let line = ray.with_range(None, None).unwrap();
        let hits = line.hit(&p).zip(line.hit(&q));
        let told = || format!("{} {ray:?} {p:?} {q:?}", S::name());
        let Some((hit, other)) = hits else {
            assert_eq!(line.compare_hits(&p, &q), None, "{}", told());
            continue;
        };
        let expected = expected(o, d, a, b);
        assert_eq!(line.compare_hits(&p, &q), Some(expected), "{}", told());
        assert_eq!(line.compare_hits(&q, &p), Some(expected.reverse()), "{}", told());
        counts[(expected as i8 + 1) as usize] += 1;
        close += usize::from(expected.is_ne() && hit.t == other.t);
    }
    let name = S::name();
    assert!(counts.iter().all(|&count| count > 30), "{name}: {counts:?}");
    assert!(close > 5, "{name}: {close} in order and not as rounded");
}

for_every_scalar!(order);
