//! A plane against an axis-aligned box: exact.

use septum::{Plane, ShapeError, Side};
use septum_kit::{BoxNumbers, Each, Given, Rng, Sample, for_every_scalar, not_finite, side, three};

fn check<S: Sample>(normal: [S; 3], given: Given<S>, aabb: BoxNumbers<S>) -> Option<Side> {
    let (plane, shape) = (given.plane(normal).ok()?, aabb.shape().ok()?);
    let expected = side(normal, given, aabb);
    assert_eq!(plane.side_of(&shape), expected, "{plane:?} {shape:?}");
    assert_eq!(plane.overlaps(&shape), expected == Side::Both);
    Some(expected)
}

/// Random planes and boxes from `pick`; both forms of each.
fn sample<S: Sample>(cases: usize, pick: impl Fn(&mut Rng) -> S) -> [usize; 3] {
    let mut rng = Rng::new(0x91a4e);
    let mut seen = [0; 3];
    for n in 0..cases {
        let mut row = || rng.triple(|r| pick(r));
        let (normal, p, q, point) = (row(), row(), row(), row());
        let aabb = if n % 2 == 0 {
            BoxNumbers::Center(p, q.each(|h| if h < S::ZERO { S::ZERO } else { h }))
        } else {
            let order = |i: usize| if p[i] < q[i] { (p[i], q[i]) } else { (q[i], p[i]) };
            BoxNumbers::Corners(three(|i| order(i).0), three(|i| order(i).1))
        };
        let given = if n % 4 < 2 { Given::Point(point) } else { Given::Offset(point[0]) };
        if let Some(side) = check(normal, given, aabb) {
            seen[side as usize] += 1;
        }
    }
    seen
}

fn exact_on_random_and_on_grid<S: Sample>() {
    let size = (S::GREATEST.approximate() / 4.0).min(4.0);
    let seen = sample::<S>(40_000, |rng| S::nearest(rng.real(-size, size)));
    assert!(seen.iter().all(|&n| n > 1_000), "{seen:?}");
    // Integers, with which contact is common.
    let seen = sample::<S>(40_000, |rng| S::nearest(rng.whole(-3, 3) as f64));
    assert!(seen.iter().all(|&n| n > 1_000), "{seen:?}");
}
for_every_scalar!(exact_on_random_and_on_grid);

mod extremes {
    use super::*;

    fn exact_at_the_extremes<S: Sample>() {
        sample::<S>(20_000, |rng| {
            let end = [S::LEAST, S::GREATEST, S::ZERO, S::nearest(1.0)][rng.below(4)];
            end.moved(rng.whole(-2, 2))
        });
        // All magnitudes, distributed evenly by bits.
        sample::<S>(20_000, |rng| S::from_ordinal(rng.bits() as i64 >> rng.below(64)));
    }
    for_every_scalar!(exact_at_the_extremes);
}

#[test]
fn a_normal_of_zero_is_refused() {
    let zero = Plane::from_equation([0.0, -0.0, 0.0], 1.0);
    assert_eq!(zero, Err(ShapeError::ZeroNormal));
    let zero = Plane::from_point_normal([1.0; 3], [0.0; 3]);
    assert_eq!(zero, Err(ShapeError::ZeroNormal));
    assert_eq!(Plane::from_equation([1.0; 3], f64::NAN), Err(not_finite("d", None)));
    let infinite = Plane::from_equation([1.0, f32::INFINITY, 1.0], 0.0);
    assert_eq!(infinite, Err(not_finite("normal", None)));
    assert_eq!(Plane::from_point_normal([f32::NAN; 3], [1.0; 3]), Err(not_finite("point", None)));
    assert!(Plane::from_equation([0.0, f32::from_bits(1), 0.0], 0.0).is_ok(), "no epsilon");
}
