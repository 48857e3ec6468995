//! Contacts of spheres and capsules: the verdict is exact, the translation separates and is the
//! least, and the points lie on both shapes.

use septum_kit::spheres::{CapsuleCase, Found, Other, SphereSet};
use septum_kit::{BoxNumbers, Each, Rng, Sample, for_every_scalar};

/// How many cases of a set have no contact, one from outside, and one from inside.
fn of_set<S: Sample>(set: SphereSet, seed: u64, cases: usize) -> [usize; 3] {
    let (mut rng, mut seen) = (Rng::new(seed), [0; 3]);
    for n in 0..cases {
        let mut case = set.capsule::<S>(&mut rng);
        if n % 3 == 0 {
            case.ends[1] = case.ends[0];
        }
        if let Some(found) = case.check_contacts() {
            seen[found as usize] += 1;
        }
    }
    seen
}

fn round_shapes_agree_with_rationals<S: Sample>() {
    for set in SphereSet::ALL {
        let seen = of_set::<S>(set, 0xc0a7, 300);
        assert!(seen[0] > 5 && seen[1] + seen[2] > 3, "{} {set:?}: {seen:?}", S::name());
    }
}
for_every_scalar!(round_shapes_agree_with_rationals);

/// Every segment on a small grid against a triangle, a triangle that is a segment, a point, a box
/// and a flat box, so that cores cross, touch and lie in one plane or line.
fn every_segment<S: Sample>(radii: std::ops::Range<i64>) -> [usize; 3] {
    let whole = |p: [i64; 3]| p.each(S::whole);
    let corners = |p: [i64; 3], q: [i64; 3]| Other::Box(BoxNumbers::Corners(whole(p), whole(q)));
    let shapes = [
        Other::Triangle([[0, 0, 0], [2, 0, 0], [0, 2, 0]].each(whole)),
        Other::Triangle([[0, 0, 0], [2, 0, 1], [0, 2, 1]].each(whole)),
        Other::Triangle([[0, 0, 0], [2, 2, 2], [1, 1, 1]].each(whole)),
        Other::Triangle([[1, 1, 1]; 3].each(whole)),
        corners([0, 0, 0], [2, 1, 2]),
        corners([0, 0, 1], [2, 2, 1]),
        corners([1, 1, 0], [1, 1, 2]),
        corners([1, 1, 1], [1, 1, 1]),
        Other::Box(BoxNumbers::Center(whole([1, 1, 1]), whole([1, 0, 2]))),
    ];
    let at = |n: i64| whole([n % 3, n / 3 % 3, n / 9]);
    let mut seen = [0; 3];
    for (a, b) in (0..27).flat_map(|a| (0..=a).map(move |b| (a, b))) {
        for other in shapes {
            for radius in radii.clone() {
                let case = CapsuleCase { ends: [at(a), at(b)], radius: S::whole(radius), other };
                seen[case.check_contacts().unwrap() as usize] += 1;
            }
        }
    }
    seen
}

#[test]
fn every_segment_on_a_small_grid() {
    let seen = every_segment::<f32>(0..3);
    assert!(seen.iter().all(|&n| n > 300), "{seen:?}");
    assert_eq!(seen, every_segment::<septum_kit::fixed::types::I16F16>(0..3));
    assert_eq!([Found::Nothing, Found::Shallow, Found::Deep].each(|f| f as usize), [0, 1, 2]);
}
