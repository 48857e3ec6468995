//! Spheres that move past triangles and boxes: the verdict is exact, and the time is the greatest
//! number not above the true one.

use std::env;

use septum_kit::spheres::{SphereSet, SphereSweep};
use septum_kit::{Rng, Sample, for_every_scalar, with_every_scalar};

/// How many cases of a set miss, begin in contact, and meet on the way.
fn of_set<S: Sample>(set: SphereSet, seed: u64, cases: usize) -> [usize; 3] {
    let (mut rng, mut seen) = (Rng::new(seed), [0; 3]);
    for _ in 0..cases {
        seen[SphereSweep::<S>::of_set(set, &mut rng).check()] += 1;
    }
    seen
}

fn exact_on_all_sets<S: Sample>() {
    for set in SphereSet::ALL {
        let seen = of_set::<S>(set, 0x5eeb, 300);
        assert!(seen[0] > 5 && seen[2] > 5, "{} {set:?}: {seen:?}", S::name());
    }
}
for_every_scalar!(exact_on_all_sets);

/// `CASES=1000000 cargo test --release --test promises moving_spheres_by_many -- --ignored
/// --nocapture`: so many cases of each set and scalar. A late time would fail.
#[test]
#[ignore = "as long as you like"]
fn moving_spheres_by_many() {
    fn many<S: Sample>() {
        let cases = env::var("CASES").ok().and_then(|n| n.parse().ok()).unwrap_or(10_000);
        for set in SphereSet::ALL {
            let [missed, start, way] = of_set::<S>(set, 83, cases);
            let (name, set) = (S::name(), format!("{set:?}"));
            println!(
                "{name:7} {set:8} {missed:8} miss, {start:8} begin in contact, {way:8} meet, 0 late"
            );
        }
    }
    with_every_scalar!(many);
}
