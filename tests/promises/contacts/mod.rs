//! Overlapping shapes: the minimum translation separates them, and is minimal.

mod points;
mod round;
mod surface;

use septum::contact::{Features, contact};
use septum::{Aabb, Obb, Triangle};
use septum_kit::boxes::BoxSet;
use septum_kit::contacts::ContactSet;
use septum_kit::fixed::types::{I0F64, I32F32};
use septum_kit::{Each, Rng, Sample, for_every_scalar, with_every_scalar};

/// The number of cases of each set, and the number also checked by linear programming.
const CASES: usize = 120;
const PROGRAMMED: usize = 20;

/// Counts the cases with and without a contact.
fn check<S: Sample>(set: ContactSet, seed: u64, cases: usize, programmed: usize) -> [usize; 2] {
    // For numbers of any size, the amount of shrinking is not known to be small enough.
    let any_bits = matches!(set, ContactSet::Like(BoxSet::Bits | BoxSet::Huge));
    let (mut rng, mut seen) = (Rng::new(seed), [0; 2]);
    for n in 0..cases {
        if let Some(is_contact) = set.case::<S>(&mut rng).check(!any_bits && n < programmed) {
            seen[usize::from(is_contact)] += 1;
        }
    }
    assert!(any_bits || seen.iter().all(|&n| n > cases / 20), "{} {set:?}: {seen:?}", S::name());
    seen
}

fn agrees_with_the_oracles<S: Sample>() {
    for set in ContactSet::ALL {
        check::<S>(set, 0xc0a1, CASES, PROGRAMMED);
    }
}
for_every_scalar!(agrees_with_the_oracles);

/// A million cases or more: `cargo test --release --test promises contacts -- --ignored
/// --nocapture`.
#[test]
#[ignore = "takes half an hour"]
fn agrees_with_the_oracles_on_a_million() {
    fn many<S: Sample>() {
        for set in ContactSet::ALL {
            let seen = check::<S>(set, 77, 21_000, 3_000);
            println!("{:8} {set:?}: none, contact: {seen:?}", S::name());
        }
    }
    with_every_scalar!(many);
}

/// Of equal depths the first axis wins: a triangle's face, faces of the first shape, of the second,
/// edges.
#[test]
fn equal_ways_have_an_order() {
    let unit = Aabb::from_min_max([-1.0, -1.0, -1.0], [1.0, 1.0, 1.0]).unwrap();
    let same = contact(&unit, &unit).unwrap().translation;
    // Against x, by the upper face of the first box; the depth is exact.
    assert_eq!((same.features, same.depth), (Features::First(1), 2.0));
    assert_eq!(same.vector.to_array(), [-2.0, 0.0, 0.0]);
    let axes = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
    let obb = Obb::new([0.0; 3], axes, [1.0; 3]).unwrap();
    assert_eq!(contact(&obb, &unit).unwrap().translation, same);
    assert_eq!(contact(&unit, &obb).unwrap().translation, same);
    // A large triangle, in the middle: its face wins, though it is the second shape.
    let big = Triangle::new([-9.0, -9.0, 0.0], [9.0, -9.0, 0.0], [0.0, 9.0, 0.0]).unwrap();
    let out = contact(&unit, &big).unwrap().translation;
    assert_eq!((out.features, out.depth), (Features::Second(0), 1.0));
    assert_eq!(out.vector.to_array(), [0.0, 0.0, -1.0]);
    let out = contact(&big, &unit).unwrap().translation;
    assert_eq!((out.features, out.vector.to_array()), (Features::First(0), [0.0, 0.0, -1.0]));
}

/// Two candidates are equal, and a third is too near to them for a comparison.
#[test]
fn a_third_candidate_may_come_between_equals() {
    fn check<S: Sample>(place: usize) {
        let mut rng = Rng::new(4242);
        let cases = (0..=place).map(|_| ContactSet::Like(BoxSet::Huge).case::<S>(&mut rng));
        assert!(cases.last().unwrap().check(false).is_some());
    }
    check::<I0F64>(7_703);
    check::<I32F32>(13_902);
}

/// Equal axes, and directions that were tested before, are skipped, without missing an axis.
#[test]
fn boxes_that_share_axes_part_by_the_rest() {
    let axes = [[0.6, 0.8, 0.0], [-0.8, 0.6, 0.0], [0.0, 0.0, 1.0]];
    let turned = [axes[1], axes[2], axes[0].each(|x: f64| -x)];
    let lower = Obb::new([0.0; 3], axes, [1.0, 2.0, 3.0]).unwrap();
    for other in [axes, turned] {
        for k in 0..3 {
            let half = [1.0, 2.0, 3.0][k] + 0.5;
            let center = axes[k].each(|x| x * (half - 0.125));
            let upper = Obb::new(center, other, [0.5; 3]).unwrap();
            let out = contact(&lower, &upper).unwrap().translation;
            assert!((out.depth - 0.125).abs() < 1e-12, "{out:?}");
            assert_eq!(out.features, Features::First(2 * k as u8 + 1));
        }
    }
}

/// The same box, given by axes twice as long and half-extents half as great, shares no axis, but
/// has the same contact.
#[test]
fn shared_axes_are_no_case_of_their_own() {
    let mut rng = Rng::new(0x54a6);
    let (mut contacts, mut of_second) = (0, 0);
    for n in 0..600 {
        let (s, c) = rng.real(0.0, 6.3).sin_cos();
        let axes = [[c, s, 0.0], [-s, c, 0.0], [0.0, 0.0, 1.0]];
        let aligned = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
        // All three axes are equal, or one is.
        let others = [[axes[1], axes[2], axes[0]], aligned, axes][n % 3];
        let mut numbers = || rng.triple(|rng| rng.real(0.2, 1.0));
        let (center, half, other_half) = (numbers(), numbers(), numbers());
        let first = Obb::new([0.0; 3], axes, half).unwrap();
        let second = Obb::new(center, others, other_half).unwrap();
        let longer = others.each(|u| u.each(|x| 2.0 * x));
        let apart = Obb::from_skewed_axes(center, longer, other_half.each(|x| x / 2.0)).unwrap();
        let found = [&second, &apart].each(|b| contact(&first, b).map(|c| c.translation));
        assert_eq!(found[0], found[1]);
        contacts += usize::from(found[0].is_some());
        of_second +=
            usize::from(matches!(found[0], Some(t) if matches!(t.features, Features::Second(_))));
    }
    assert!(contacts > 100 && of_second > 10, "{contacts} {of_second}");
}

/// Skewed boxes with one axis equal or opposite: the cross products with it that repeat another
/// direction are skipped, and all other pairs are tested.
#[test]
fn one_shared_axis_leaves_the_other_pairs() {
    let mut rng = Rng::new(0x54a7);
    let (mut contacts, mut by_edges) = (0, 0);
    for n in 0..900 {
        let mut axes = || [(); 3].each(|()| rng.triple(|rng| rng.real(-1.0, 1.0)));
        let (axes, mut others) = (axes(), axes());
        let sign = if n % 2 == 0 { 1.0 } else { -1.0 };
        others[n % 3] = axes[n / 3 % 3].each(|x| sign * x);
        let mut numbers = |most: f64| rng.triple(|rng| rng.real(0.2, most));
        let (center, half, other_half) = (numbers(1.4), numbers(1.0), numbers(1.0));
        let Ok(first) = Obb::from_skewed_axes([0.0; 3], axes, half) else { continue };
        let longer = others.each(|u| u.each(|x| 2.0 * x));
        let second = [(others, other_half), (longer, other_half.each(|x| x / 2.0))]
            .each(|(axes, half)| Obb::from_skewed_axes(center, axes, half));
        let [Ok(second), Ok(apart)] = second else { continue };
        let found = [&second, &apart].each(|b| contact(&first, b).map(|c| c.translation));
        assert_eq!(found[0], found[1]);
        contacts += usize::from(found[0].is_some());
        by_edges +=
            usize::from(matches!(found[0], Some(t) if matches!(t.features, Features::Edges(..))));
    }
    assert!(contacts > 100 && by_edges > 30, "{contacts} {by_edges}");
}

/// Beyond the range of the scalar the vector is clamped, and `is_sufficient` is `false`.
#[test]
fn beyond_the_range_is_its_end() {
    use septum_kit::fixed::types::I8F8;
    let all = Aabb::from_min_max([I8F8::MIN; 3], [I8F8::MAX; 3]).unwrap();
    let out = contact(&all, &all).unwrap().translation;
    assert_eq!((out.depth, out.is_sufficient), (I8F8::MAX, false));
    assert_eq!(out.vector.to_array(), [I8F8::MIN, I8F8::ZERO, I8F8::ZERO]);
    let all = Aabb::from_min_max([f32::MIN; 3], [f32::MAX; 3]).unwrap();
    let out = contact(&all, &all).unwrap().translation;
    assert_eq!((out.depth, out.is_sufficient), (f32::INFINITY, false));
    assert!(contact(&all, &all).unwrap().points().iter().all(|p| !p.depth.is_nan()));
}

/// The least number of a fixed-point type has no counterpart above zero, and is returned where it
/// suffices.
#[test]
fn the_least_number_is_a_way_out() {
    use septum_kit::fixed::types::I4F4;
    let aabb = |min: [f64; 3], max: [f64; 3]| {
        Aabb::from_min_max(min.each(I4F4::from_num), max.each(I4F4::from_num)).unwrap()
    };
    let lower = aabb([-8.0; 3], [0.0, 7.5, 7.5]);
    let out = contact(&lower, &aabb([-8.0; 3], [7.5; 3])).unwrap().translation;
    assert_eq!(out.vector.to_array(), [I4F4::MIN, I4F4::ZERO, I4F4::ZERO]);
    assert_eq!((out.depth, out.is_sufficient), (I4F4::MAX, true));
    // The other way it takes 8, which is no number of the type.
    let out = contact(&aabb([-8.0; 3], [7.5; 3]), &lower).unwrap().translation;
    assert_eq!((out.vector.x, out.is_sufficient), (I4F4::MAX, false));
}

#[test]
fn debug_shows_the_points_found() {
    let floor = Triangle::new([-8.0_f32, -8.0, 0.0], [8.0, -8.0, 0.0], [0.0, 8.0, 0.0]).unwrap();
    let sunk = Aabb::from_min_max([0.0, 0.0, -0.5], [1.0, 1.0, 8.0]).unwrap();
    let found = contact(&sunk, &floor).unwrap();
    assert_eq!(format!("{found:?}").matches("on_first").count(), found.points().len());
}
