//! Capsules against other shapes: exact.

use std::cmp::Ordering;
use std::env;

use septum::relation::{Relate, Relation};
use septum::{Aabb, Capsule, Plane, Ray, ShapeError, Vec3};
use septum_kit::fixed::types::I16F16;
use septum_kit::spheres::{CapsuleCase, Other, SphereSet};
use septum_kit::{BoxNumbers, Each, Rng, Sample, for_every_scalar, not_finite, with_every_scalar};

/// Checks all answers about a case.
fn check<S: Sample>(case: &CapsuleCase<S>) -> Ordering {
    let truth = case.truth();
    let (answers, relation) = (case.answers(), case.relation());
    assert!(answers.check(truth, relation), "{answers:?} {truth:?} {relation:?} {case:?}");
    if let Some(range) = case.check_range() {
        assert!(range.is_ok(), "{range:?} {case:?}");
    }
    truth
}

/// How many cases of a set overlap, touch and are apart.
fn of_set<S: Sample>(set: SphereSet, seed: u64, cases: usize) -> [usize; 3] {
    let (mut rng, mut seen) = (Rng::new(seed), [0; 3]);
    for _ in 0..cases {
        seen[(check(&set.capsule::<S>(&mut rng)) as i8 + 1) as usize] += 1;
    }
    seen
}

fn exact_on_all_sets<S: Sample>() {
    for set in SphereSet::ALL {
        let seen = of_set::<S>(set, 0xca95, 500);
        assert!(seen[0] > 5 && seen[2] > 20, "{} {set:?}: {seen:?}", S::name());
        let touching = matches!(set, SphereSet::Grid | SphereSet::Touch);
        assert!(seen[1] > 10 || !touching, "{} {set:?}: {seen:?}", S::name());
    }
}
for_every_scalar!(exact_on_all_sets);

/// `CASES=1000000 cargo test --release --test promises capsules_by_many -- --ignored --nocapture`:
/// so many cases of each set and scalar.
#[test]
#[ignore = "as long as you like"]
fn capsules_by_many() {
    fn many<S: Sample>() {
        let cases = env::var("CASES").ok().and_then(|n| n.parse().ok()).unwrap_or(10_000);
        for set in SphereSet::ALL {
            let [near, touching, far] = of_set::<S>(set, 79, cases);
            let (name, set) = (S::name(), format!("{set:?}"));
            println!("{name:7} {set:8} {near:8} overlap, {touching:8} touch, {far:8} apart");
        }
    }
    with_every_scalar!(many);
}

/// Every segment on a small grid against a segment, a triangle and a box whose sides are 3, 4 and 12
/// long, for every radius that is whole.
fn every_small_segment<S: Sample>() {
    let whole = |p: [i64; 3]| p.each(S::whole);
    let shapes = [
        Other::Ends([[0, 0, 0], [4, 0, 3]].each(whole)),
        Other::Triangle([[0, 0, 0], [4, 0, 0], [0, 3, 0]].each(whole)),
        Other::Box(BoxNumbers::Corners(whole([0, 0, 0]), whole([1, 2, 1]))),
    ];
    let at = |n: i64| whole([n % 3 * 4 - 3, n / 3 % 3 * 3 - 2, n / 9 * 4 - 3]);
    let mut touching = 0;
    for (a, b) in (0..27).flat_map(|a| (0..=a).map(move |b| (a, b))) {
        for other in shapes {
            for radius in 0..6 {
                let case = CapsuleCase { ends: [at(a), at(b)], radius: S::whole(radius), other };
                touching += usize::from(check(&case).is_eq());
            }
        }
    }
    assert!(touching > 250, "{touching}");
}
#[test]
fn every_segment_on_a_small_grid() {
    every_small_segment::<f32>();
    every_small_segment::<I16F16>();
}

/// Segments on a small grid against rays in some directions, with every range of small whole
/// numbers: distances, and relations of segments without a radius.
fn every_small_ray<S: Sample>() {
    let whole = |p: [i64; 3]| p.each(S::whole);
    let ends = [None, Some(-1), Some(0), Some(1)];
    let ranges = ends.iter().flat_map(|from| ends.each(|to| [*from, to]));
    let ranges = ranges.filter(|[from, to]| from.zip(*to).is_none_or(|(from, to)| from <= to));
    let at = |n: i64| whole([n % 3 * 3 - 3, n / 3 % 3 * 2 - 1, n / 9 * 4]);
    let (mut touching, mut thin) = (0, 0);
    for range in ranges.map(|range| range.each(|t| t.map(S::whole))) {
        for d in [[3, 0, 0], [-3, 0, 0], [3, 4, 0], [0, 0, 1], [-3, 2, 4]] {
            let other = Other::Ray([whole([0, 1, 0]), whole(d)], range);
            for (a, b) in (0..18).flat_map(|a| (0..=a).map(move |b| (a, b))) {
                for radius in 0..6 {
                    let case =
                        CapsuleCase { ends: [at(a), at(b)], radius: S::whole(radius), other };
                    let truth = check(&case);
                    touching += usize::from(truth.is_eq());
                    thin += usize::from(radius == 0 && truth.is_eq());
                }
            }
        }
    }
    assert!(touching > 2_000 && thin > 300, "{touching} {thin}");
}
#[test]
fn every_small_ray_past_a_segment() {
    every_small_ray::<f32>();
    every_small_ray::<I16F16>();
}

#[test]
fn segments_on_a_ray() {
    let ray = Ray::new([0.0_f32; 3], [1.0, 0.0, 0.0]).unwrap();
    let ranges = [[Some(0.0), None], [Some(0.0), Some(2.0)], [None, Some(2.0)], [Some(2.0); 2]];
    let rays = ranges.each(|[from, to]| ray.with_range(from, to).unwrap());
    let of = |a: [f32; 2], b: [f32; 2]| {
        let [a, b] = [a, b].each(|[x, y]| [x, y, 0.0]);
        let capsules = [[a, b], [b, a]].each(|[a, b]| Capsule::new(a, b, 0.0).unwrap());
        rays.each(|ray| {
            let [first, second] = capsules.each(|c| c.relation(&ray));
            assert_eq!(first, second);
            assert_eq!(first != Relation::Disjoint, capsules[0].overlaps(&ray));
            first as u8
        })
    };
    // On the line: beyond, from an end, within, past both ends.
    assert_eq!(of([-2.0, 0.0], [-1.0, 0.0]), [0, 0, 2, 0]);
    assert_eq!(of([-2.0, 0.0], [0.0, 0.0]), [1, 1, 2, 0]);
    assert_eq!(of([0.5, 0.0], [1.5, 0.0]), [2, 2, 2, 0]);
    assert_eq!(of([0.0, 0.0], [2.0, 0.0]), [2, 2, 2, 1]);
    assert_eq!(of([1.0, 0.0], [2.0, 0.0]), [2, 2, 2, 1]);
    assert_eq!(of([2.0, 0.0], [3.0, 0.0]), [2, 1, 1, 1]);
    assert_eq!(of([-1.0, 0.0], [3.0, 0.0]), [2; 4]);
    // Across the line, or with an end on it.
    assert_eq!(of([1.0, -1.0], [1.0, 1.0]), [2, 2, 2, 0]);
    assert_eq!(of([2.0, -1.0], [2.0, 1.0]), [2, 1, 1, 2]);
    assert_eq!(of([2.0, 0.0], [3.0, 1.0]), [1; 4]);
    assert_eq!(of([1.0, 0.0], [1.0, 1.0]), [1, 1, 1, 0]);
    assert_eq!(of([0.0, -1.0], [0.0, 1.0]), [1, 1, 2, 0]);
    // Points.
    assert_eq!(of([0.0, 0.0], [0.0, 0.0]), [1, 1, 2, 0]);
    assert_eq!(of([2.0, 0.0], [2.0, 0.0]), [2, 1, 1, 2]);
}

#[test]
fn invalid_capsules_are_refused() {
    let o = [0.0_f32; 3];
    assert_eq!(Capsule::new([f32::NAN; 3], o, 1.0), Err(not_finite("a", None)));
    assert_eq!(Capsule::new(o, [f32::INFINITY; 3], 1.0), Err(not_finite("b", None)));
    assert_eq!(Capsule::new(o, o, f32::NAN), Err(not_finite("radius", None)));
    assert_eq!(Capsule::new(o, o, -f32::from_bits(1)), Err(ShapeError::NegativeRadius));
    assert!(Capsule::new(o, o, -0.0).is_ok());
    assert!(!Capsule::new(o, o, 1.0).unwrap().contains([f32::NAN, 0.0, 0.0]));
}

#[test]
fn a_capsule_in_flash_is_the_same() {
    const A: Vec3<f32> = Vec3::splat(1.0);
    const B: Vec3<f32> = Vec3::splat(4.0);
    static CAPSULE: Capsule<f32> = ShapeError::unwrap(Capsule::<f32>::const_new(A, B, 2.0));
    assert_eq!(Capsule::new(A, B, 2.0), Ok(CAPSULE));
    assert_eq!((CAPSULE.ends(), CAPSULE.radius()), ((A, B), 2.0));
    assert_eq!(CAPSULE.aabb(), Aabb::from_min_max([-1.0; 3], [6.0; 3]).ok());
    let refused = |a, b, radius| Capsule::<f32>::const_new(a, b, radius);
    let nan = Vec3::splat(f32::NAN);
    assert_eq!(refused(nan, B, 1.0), Err(not_finite("a", None)));
    assert_eq!(refused(A, nan, 1.0), Err(not_finite("b", None)));
    assert_eq!(refused(A, B, f32::INFINITY), Err(not_finite("radius", None)));
    assert_eq!(refused(A, B, -1.0), Err(ShapeError::NegativeRadius));
}

#[test]
fn segments_at_a_plane() {
    let plane = Plane::from_equation([0.0_f32, 0.0, 2.0], -2.0).unwrap();
    let of = |from, to| {
        let capsule = Capsule::new([0.0, 0.0, from], [3.0, 0.0, to], 0.0).unwrap();
        capsule.relation(&plane) as u8
    };
    assert_eq!([of(2.0, 3.0), of(1.0, 3.0), of(-1.0, 1.0)], [0, 1, 1]);
    assert_eq!([of(0.0, 3.0), of(1.0, 1.0)], [2, 2]);
}
