//! `may_overlap` never misses: it never returns `false` for shapes that meet.

use septum_kit::{Rng, Sample, Set, Touch, for_every_scalar, meets};

fn never_false_where_sets_meet<S: Sample>() {
    for set in Set::ALL {
        for case in set.cases::<S>(31, 8_000) {
            let (triangle, aabb) = case.shapes();
            assert!(triangle.may_overlap(&aabb) || !meets(&case), "{set:?}: {case:?}");
        }
    }
}

/// Contacts in one point, without any margin.
fn never_false_on_contact<S: Sample>() {
    let mut rng = Rng::new(32);
    for _ in 0..20_000 {
        let touch = Touch::of_any_size::<S>(&mut rng);
        for by_center in [true, false] {
            let (triangle, aabb) = touch.case::<S>(by_center).shapes();
            assert!(triangle.may_overlap(&aabb), "{touch:?}");
        }
    }
}

/// Always answering `true` would never miss, so most disjoint pairs must give `false`.
fn says_no_to_most_that_are_apart<S: Sample>() {
    for set in [Set::Random, Set::Grid, Set::Slivers, Set::Far] {
        let cases = set.cases::<S>(33, 8_000);
        let apart = cases.iter().filter(|case| !meets(case)).count();
        let maybe = cases.iter().filter(|case| case.triangle().may_overlap(&case.aabb()));
        let wrong = maybe.count() - (cases.len() - apart);
        assert!(wrong * 1_000 <= apart, "{set:?}: {wrong} of {apart}");
    }
}

for_every_scalar!(
    never_false_where_sets_meet,
    never_false_on_contact,
    says_no_to_most_that_are_apart,
);
