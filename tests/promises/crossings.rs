//! The segment in which two triangles cross: an exact verdict, and ends as near as the docs state.

use std::collections::HashMap;

use septum::mesh::OwnedTree;
use septum_kit::fixed::types::I8F8;
use septum_kit::flat::{Flat, FlatCase, FlatSet};
use septum_kit::{Each, Rng, Sample, for_every_scalar, for_scalars, three, with_every_scalar};

/// The number of cases of each set.
const CASES: usize = 1_000;

/// The greatest error in units in the last place; zero stands for the nearest number.
fn bound<S: Sample>(x: S) -> f64 {
    let least_normal = match S::name().as_str() {
        "f32" => f64::from(f32::MIN_POSITIVE),
        "f64" => f64::MIN_POSITIVE,
        _ => return 0.0,
    };
    if x.approximate().abs() > least_normal { 0.51 } else { 0.76 }
}

/// Checks a case; returns whether there is a segment.
fn check<S: Sample>(case: &FlatCase<S>) -> bool {
    let Some(ends) = case.check_crossing() else { return false };
    for (x, truth) in ends.as_flattened() {
        let most = bound(*x);
        let is_near =
            if most == 0.0 { truth.is_nearest(*x) } else { truth.error_in_ulp(*x) < most };
        assert!(is_near, "{x:?} is {}: {case:?}", truth.approximate());
    }
    true
}

/// The number of cases with a segment in each set.
fn agrees<S: Sample>(seed: u64, cases: usize) -> [usize; FlatSet::ALL.len()] {
    FlatSet::ALL.map(|set| {
        let mut rng = Rng::new(seed);
        (0..cases).filter(|_| check(&set.case::<S>(&mut rng))).count()
    })
}

fn agrees_with_fractions<S: Sample>() {
    let seen = agrees::<S>(0x5e91, CASES);
    assert!(seen.iter().filter(|&&n| n > CASES / 50).count() > 4, "{}: {seen:?}", S::name());
}
for_every_scalar!(agrees_with_fractions);

/// More than a million cases: `cargo test --release --test promises crossings -- --ignored
/// --nocapture`.
#[test]
#[ignore = "takes minutes"]
fn agrees_with_fractions_on_a_million() {
    fn many<S: Sample>() {
        println!("{:8} {:?}", S::name(), agrees::<S>(0x5e92, 20_000));
    }
    with_every_scalar!(many);
}

/// All pairs of a triangle with those between points of a small grid.
#[test]
fn every_pair_on_a_grid() {
    let point = |n: i64| [n % 3 - 1, n / 3 % 3 - 1, n / 9 - 1].each(I8F8::whole);
    let mut seen = 0;
    for n in 0..27_i64.pow(3) {
        let flat = Flat::Triangle([point(n % 27), point(n / 27 % 27), point(n / 729)]);
        for triangle in [[0, 2, 6], [0, 13, 16], [1, 15, 20]] {
            seen += usize::from(check(&FlatCase { flat, triangle: triangle.each(point) }));
        }
    }
    assert!(seen > 10_000, "{seen}");
}

/// Two closed surfaces, oriented outward, intersect in loops: at each point as many segments end as
/// begin. In random numbers no edge crosses an edge or lies in a face.
fn segments_make_loops<S: Sample>() {
    const FACES: [[u16; 3]; 4] = [[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]];
    let (mut rng, mut seen) = (Rng::new(0x100b), 0);
    for _ in 0..400 {
        let mut solid = || {
            let o = rng.triple(|rng| rng.real(-0.5, 0.5));
            let mut corner = |axis: usize| {
                let mut p = rng.triple(|rng| rng.real(-0.2, 0.2));
                if axis < 3 {
                    p[axis] += 1.0;
                }
                three(|i: usize| S::nearest(o[i] + p[i]))
            };
            let corners = [corner(3), corner(0), corner(1), corner(2)];
            OwnedTree::new(corners, FACES).expect("a mesh")
        };
        let (first, second) = (solid(), solid());
        let mut ends = HashMap::new();
        let _ = first.as_tree().crossings(&second.as_tree(), |_, _, segment| {
            let (from, to) = segment.ends().expect("by its ends");
            for (p, n) in [(from, 1), (to, -1)] {
                *ends.entry(p.to_array().each(S::ordinal)).or_insert(0) += n;
            }
            std::ops::ControlFlow::<()>::Continue(())
        });
        assert!(ends.values().all(|&n| n == 0), "{}: {first:?} {second:?}", S::name());
        seen += ends.len();
    }
    assert!(seen > 1_000, "{}: {seen}", S::name());
}
for_scalars!(
    [f32: f32, f64: f64, i16f16: septum_kit::fixed::types::I16F16]
    segments_make_loops
);
