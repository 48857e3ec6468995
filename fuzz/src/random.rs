//! Runs every target on random bytes, without a fuzzer, and checks that the inputs are varied
//! enough.

use std::str::FromStr;

use septum::Feature;

use crate::scalars::{Check, run};
use crate::shapes::Shapes;
use crate::told::told;
use septum_kit::rays::crossing;
use septum_kit::{Case, Rng, Sample, is_collinear, meets};

/// Inputs of random bytes, of many lengths, the same every time.
fn inputs(count: usize) -> impl Iterator<Item = Vec<u8>> {
    let mut rng = Rng::new(0xf022);
    (0..count).map(move |_| {
        let length = rng.below(300);
        (0..length).map(|_| rng.bits() as u8).collect()
    })
}

macro_rules! random_bytes {
    ($($target:ident: $count:literal),* $(,)?) => {$(
        #[test]
        fn $target() {
            inputs($count).for_each(|data| crate::$target(&data));
        }
    )*};
}
random_bytes! {
    triangle_aabb: 20_000,
    triangle_obb: 20_000,
    flat_shapes: 20_000,
    contacts: 10_000,
    round_contacts: 10_000,
    oriented_pairs: 10_000,
    plane_aabb: 20_000,
    polygon_aabb: 20_000,
    ray_triangle: 20_000,
    closed_mesh: 20_000,
    ray_aabb: 20_000,
    segment_aabb: 20_000,
    spheres: 20_000,
    sweeps: 5_000,
    line_obb: 10_000,
    lanes: 2_000,
    unit_normal: 20_000,
    constructors: 20_000,
}

/// How often the check notes each kind, over all scalars.
fn count<C: Check>() -> Vec<usize> {
    inputs(40_000).for_each(|data| run::<C>(&data));
    SEEN.take()
}

std::thread_local! {
    static SEEN: std::cell::RefCell<Vec<usize>> = const { std::cell::RefCell::new(Vec::new()) };
}

/// Notes that something of this kind was seen.
fn note(kind: usize) {
    SEEN.with_borrow_mut(|seen| {
        seen.resize(seen.len().max(kind + 1), 0);
        seen[kind] += 1;
    });
}

struct Verdicts;

impl Check for Verdicts {
    fn check<S: Sample>(shapes: &mut Shapes<'_, S>) {
        let aabb = shapes.aabb();
        let case = Case { vertices: shapes.triangle(), aabb };
        note(usize::from(meets(&case)));
        note(2 + usize::from(is_collinear(&case)));
    }
}

#[test]
fn boxes_are_met_and_missed() {
    let seen = count::<Verdicts>();
    println!("apart, met; triangles, segments: {seen:?}");
    assert!(seen.iter().all(|&n| n > 4_000), "{seen:?}");
}

struct Crossings;

impl Check for Crossings {
    fn check<S: Sample>(shapes: &mut Shapes<'_, S>) {
        let Some(case) = shapes.ray_case() else { return };
        note(match crossing(&case).map(|truth| truth.feature) {
            None => 0,
            Some(Feature::Interior) => 1,
            Some(Feature::Edge(_)) => 2,
            Some(Feature::Vertex(_)) => 3,
        });
    }
}

#[test]
fn rays_miss_and_hit_everything() {
    let seen = count::<Crossings>();
    println!("missed; interior, edge, vertex: {seen:?}");
    assert!(seen.iter().all(|&n| n > 1_000), "{seen:?}");
}

/// Numbers in messages can be copied into a test.
#[test]
fn what_is_printed_is_read_back() {
    use fixed::types::{I1F63, I8F8, I33F31};
    for x in (i16::MIN..=i16::MAX).map(I8F8::from_bits) {
        assert_eq!(read_back(x), Ok(x));
    }
    let mut rng = Rng::new(1);
    for _ in 0..100_000 {
        let bits = rng.bits() as i64;
        let (x, y) = (I1F63::from_bits(bits), I33F31::from_bits(bits));
        assert_eq!((read_back(x), read_back(y)), (Ok(x), Ok(y)));
    }
}

/// Parses a number as `told` prints it.
fn read_back<S: Sample + FromStr>(x: S) -> Result<S, S::Err> {
    let told = told::<S>(&x);
    told.split(": ").nth(1).expect("a number").parse()
}
