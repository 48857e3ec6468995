//! Spheres against other shapes: exact.

use std::cmp::Ordering;
use std::env;

use septum::relation::{Relate, Relation};
use septum::{Plane, Ray, ShapeError, Sphere};
use septum_kit::fixed::types::{I4F4, I8F8, I16F16, I32F32};
use septum_kit::spheres::{CapsuleCase, Other, SphereCase, SphereSet};
use septum_kit::{Each, Rng, Sample, for_every_scalar, not_finite, with_every_scalar};

/// Checks all answers about a case.
fn check<S: Sample>(case: &SphereCase<S>) -> Ordering {
    let truth = case.truth();
    let (answers, relation) = (case.answers(), case.relation());
    assert!(answers.check(truth, relation), "{answers:?} {truth:?} {relation:?} {case:?}");
    if let Some(found) = case.closest() {
        let checked = case.check_closest(&found);
        assert_eq!(checked, Some(Ok(())), "{found:?} {case:?}");
    }
    if let Some((squared, is_rounded)) = case.distance_squared() {
        assert!(is_rounded, "{squared:?} {case:?}");
    }
    if let Some((range, is_right)) = case.distance_squared_range() {
        assert!(is_right, "{range:?} {case:?}");
    }
    if let Some(range) = case.check_range() {
        assert!(range.is_ok(), "{range:?} {case:?}");
    }
    truth
}

/// How many cases of a set overlap, touch and are apart.
fn of_set<S: Sample>(set: SphereSet, seed: u64, cases: usize) -> [usize; 3] {
    let (mut rng, mut seen) = (Rng::new(seed), [0; 3]);
    for _ in 0..cases {
        seen[(check(&set.case::<S>(&mut rng)) as i8 + 1) as usize] += 1;
    }
    seen
}

fn exact_on_all_sets<S: Sample>() {
    for set in SphereSet::ALL {
        let seen = of_set::<S>(set, 0x5b4e, 1_200);
        assert!(seen[0] > 50 && seen[2] > 50, "{} {set:?}: {seen:?}", S::name());
        let touching = matches!(set, SphereSet::Grid | SphereSet::Touch);
        assert!(seen[1] > 20 || !touching, "{} {set:?}: {seen:?}", S::name());
    }
}
for_every_scalar!(exact_on_all_sets);

/// `CASES=1000000 cargo test --release --test promises spheres_by_many -- --ignored --nocapture`: so
/// many cases of each set and scalar.
#[test]
#[ignore = "as long as you like"]
fn spheres_by_many() {
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

/// Every triangle on a small grid in a plane, and points around it whose distances are roots.
fn every_small_triangle<S: Sample>() {
    let grid = |n: usize| [n % 3, n / 3, 0].each(|x| S::whole(x as i64));
    for n in 0..729 {
        let other = Other::Triangle([n % 9, n / 9 % 9, n / 81].each(grid));
        for m in 0..18 {
            let center = [m % 3 - 1, m / 3 % 3 + 1, m / 9].each(S::whole);
            for radius in 0..4 {
                check(&SphereCase { center, radius: S::whole(radius), other });
            }
        }
    }
}
#[test]
fn every_triangle_on_a_small_grid() {
    every_small_triangle::<f32>();
    every_small_triangle::<I16F16>();
}

/// Every direction on a small grid with every range of small whole numbers, and spheres around points
/// whose distances are roots.
fn every_small_ray<S: Sample>() {
    let whole = |p: [i64; 3]| p.each(S::whole);
    let ends = [None, Some(-2.0), Some(-1.0), Some(0.0), Some(1.0), Some(2.0)];
    let ranges = ends.iter().flat_map(|from| ends.map(|to| [*from, to]));
    let ranges = ranges.filter(|[from, to]| from.zip(*to).is_none_or(|(from, to)| from <= to));
    let mut touching = 0;
    for range in ranges.map(|range| range.each(|t| t.map(S::nearest))) {
        for n in (0..27).filter(|&n| n != 13) {
            let direction = whole([n % 3 - 1, n / 3 % 3 - 1, n / 9 - 1]);
            let other = Other::Ray([whole([0, 1, 0]), direction], range);
            for m in 0..12 {
                let center = whole([m % 2 * 3, m / 2 % 2 * 4, m / 4 * 2 - 2]);
                for radius in 0..6 {
                    let case = SphereCase { center, radius: S::whole(radius), other };
                    touching += usize::from(check(&case).is_eq());
                }
            }
        }
    }
    assert!(touching > 500, "{touching}");
}
#[test]
fn every_ray_on_a_small_grid() {
    every_small_ray::<f32>();
    every_small_ray::<I16F16>();
}

#[test]
fn invalid_spheres_are_refused() {
    assert_eq!(Sphere::new([f32::NAN; 3], 1.0), Err(not_finite("center", None)));
    assert_eq!(Sphere::new([0.0; 3], f64::INFINITY), Err(not_finite("radius", None)));
    assert_eq!(Sphere::new([0.0; 3], -f32::from_bits(1)), Err(ShapeError::NegativeRadius));
    assert!(Sphere::new([0.0; 3], -0.0_f32).is_ok());
    assert!(!Sphere::new([0.0_f32; 3], 1.0).unwrap().contains([f32::NAN, 0.0, 0.0]));
}

#[test]
fn points_on_a_plane_or_a_ray() {
    let at = |x: f32| Sphere::new([x, 0.0, 0.0], 0.0).unwrap();
    let plane = Plane::from_equation([0.0, 0.0, 1.0], 0.0).unwrap();
    assert_eq!(at(3.0).relation(&plane), Relation::Overlapping);
    let ray = Ray::new([1.0, 0.0, 0.0], [1.0, 0.0, 0.0]).unwrap();
    let of = |ray: &Ray<f32>| [0.0, 1.0, 2.0, 3.0].each(|x| at(x).relation(ray) as u8);
    assert_eq!(of(&ray), [0, 1, 2, 2]);
    assert_eq!(of(&ray.with_range(0.0, 2.0).unwrap()), [0, 1, 2, 1]);
    assert_eq!(of(&ray.with_range(None, 1.0).unwrap()), [2, 2, 1, 0]);
    assert_eq!(of(&ray.with_range(1.0, 1.0).unwrap()), [0, 0, 2, 0]);
}

/// Times at the ends of fixed point and beyond them: of spheres and capsules many directions away.
#[test]
fn ranges_at_the_ends_of_fixed_point() {
    fn check<S: Sample>() {
        let (mut rng, mut least) = (Rng::new(0xe4d5), 0);
        for _ in 0..2_000 {
            // In raw bits: a time is a quotient of two of them.
            let (step, radius) = (rng.whole(1, 3), rng.whole(1, 9));
            let far = -(S::LEAST.approximate() as i64) * step + rng.whole(-2, 2) * radius;
            let sign = if rng.one_in(2) { 1 } else { -1 };
            let raw = |p: [i64; 3]| p.each(|x| S::ZERO.moved(x));
            let (y, z) = (rng.whole(0, radius), rng.whole(0, 2));
            let numbers = [raw([0; 3]), raw([sign * step, 0, 0])];
            let (center, radius) = (raw([far, y, z]), S::ZERO.moved(radius));
            let other = || Other::Ray(numbers, [None; 2]);
            let sphere = SphereCase { center, radius, other: other() };
            let ends = [center, raw([far, y + rng.whole(1, 5), z])];
            let capsule = CapsuleCase { ends, radius, other: other() };
            for range in [sphere.check_range(), capsule.check_range()] {
                let found = range.unwrap().unwrap_or_else(|found| {
                    panic!("{}: {found} {sphere:?} {capsule:?}", S::name())
                });
                least += usize::from(found.is_some_and(|(_, leave)| leave == S::LEAST));
            }
        }
        assert!(least > 300, "{}: {least}", S::name());
    }
    check::<I4F4>();
    check::<I8F8>();
    check::<I16F16>();
    check::<I32F32>();
}

/// A root of exactly the power of two beyond the greatest float lies above that float.
#[test]
fn a_root_beyond_the_greatest_float_is_infinite() {
    let short = |n: i32| 2_f32.powi(n);
    let ray = Ray::new([0.0; 3], [short(-24), short(-24), 0.0]).unwrap();
    let ball = Sphere::new([short(104), short(104), 0.0], 0.0).unwrap();
    assert_eq!(ray.t_range_sphere(&ball), Some((f32::MAX, f32::INFINITY)));
    let long = |n: i32| 2_f64.powi(n);
    let ray = Ray::new([0.0; 3], [long(-25), 0.0, 0.0]).unwrap();
    let ball = Sphere::new([long(999), 0.0, 0.0], 0.0).unwrap();
    assert_eq!(ray.t_range_sphere(&ball), Some((f64::MAX, f64::INFINITY)));
    let line = ray.with_range(None, None).unwrap();
    let behind = Sphere::new([-long(999), 0.0, 0.0], 0.0).unwrap();
    assert_eq!(line.t_range_sphere(&behind), Some((f64::NEG_INFINITY, f64::MIN)));
}
