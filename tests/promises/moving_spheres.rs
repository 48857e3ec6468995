//! Spheres that move past triangles and boxes: the verdict is exact, and the time is the greatest
//! number not above the true one.

use std::env;

use septum::sweep::{Motion, Sweep};
use septum::{Capsule, Feature, Segment, Sphere, Triangle};
use septum_kit::fixed::types::{I0F32, I1F15};
use septum_kit::spheres::{SphereSet, SphereSweep};
use septum_kit::{Each, Rng, Sample, for_every_scalar, with_every_scalar};

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

/// The edge or vertex that a contact names is within the radius of the way, on a grid of 9 places, where many
/// contacts are at its end.
fn parts_are_on_the_way<S: Sample>(of: fn(i64) -> S) {
    let (mut rng, mut seen) = (Rng::new(0x9a27), [0; 2]);
    for _ in 0..20_000 {
        let mut point = || rng.triple(|rng| of(rng.below(9) as i64 - 4));
        let (from, to, triangle) = (point(), point(), [point(), point(), point()]);
        let radius = of(1 + rng.below(2) as i64);
        let (ball, way) = (Sphere::new(from, radius).unwrap(), Motion::new(from, to).unwrap());
        let [a, b, c] = triangle;
        let part =
            ball.first_contact(&way, &Triangle::new(a, b, c).unwrap()).and_then(|first| first.part);
        let ends = match part {
            Some(Feature::Edge(k)) => [k, (k + 1) % 3],
            Some(Feature::Vertex(k)) => [k; 2],
            _ => continue,
        };
        let [p, q] = ends.each(|k| triangle[usize::from(k)]);
        let reach = Capsule::new(from, to, radius).unwrap();
        assert!(reach.overlaps(&Segment::new(p, q).unwrap()), "{from:?} {to:?} {triangle:?}");
        seen[usize::from(p == q)] += 1;
    }
    assert!(seen.iter().all(|&n| n > 500), "{seen:?}");
}

fn no_part_is_beyond_the_end<S: Sample>() {
    parts_are_on_the_way(S::whole);
}
for_every_scalar!(no_part_is_beyond_the_end);

/// Times next to one are one number, whatever is met later.
#[test]
fn no_part_is_beyond_the_end_where_there_is_no_one() {
    parts_are_on_the_way(I0F32::from_ordinal);
    parts_are_on_the_way(I1F15::from_ordinal);
}

/// The edge comes within a radius of the centre just after the end.
#[test]
fn a_vertex_at_the_end_is_met_before_an_edge_after_it() {
    let beside = 2_f32.powi(-13);
    let corners = [[-5.0, beside, 2.0], [5.0, beside, 2.0], [0.0, 0.0, 2.0]];
    let [a, b, c] = corners;
    let (ball, up) = (Sphere::new([0.0; 3], 1.0).unwrap(), Motion::new([0.0; 3], [0.0, 0.0, 1.0]));
    let first = ball.first_contact(&up.unwrap(), &Triangle::new(a, b, c).unwrap()).unwrap();
    assert_eq!((first.t, first.part), (1.0, Some(Feature::Vertex(2))));
}
