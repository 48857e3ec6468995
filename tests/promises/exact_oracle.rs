//! `overlaps` gives the exact answer: on every set, in every scalar, and on numbers of any
//! magnitude, compared with exact clipping.

use proptest::prelude::*;
use septum::prepared::PreparedTriangle;
use septum_kit::{
    BoxNumbers, Case, Each, Sample, Set, for_every_scalar, for_scalars, meets, three,
};

use super::any_bits::AnyBits;

fn every_set<S: Sample>() {
    for set in Set::ALL {
        for case in set.cases::<S>(21, 12_000) {
            let (triangle, aabb) = case.shapes();
            let answer = meets(&case);
            assert_eq!(triangle.overlaps(&aabb), answer, "{set:?}: {case:?}");
            let prepared = PreparedTriangle::new(&triangle);
            assert_eq!(prepared.overlaps(&aabb), answer, "prepared, {set:?}: {case:?}");
        }
    }
}

for_every_scalar!(every_set);

/// Fifteen numbers chosen from three and their negatives, so that many coincide.
fn case_of<S: Sample>(pool: [S; 3], picks: &[usize; 15], center: bool) -> Case<S> {
    let pick = |i: usize| {
        let x = pool[picks[i] % 3];
        if picks[i] < 3 { x } else { S::from_ordinal(x.ordinal().saturating_neg()) }
    };
    let row = |r: usize| [pick(3 * r), pick(3 * r + 1), pick(3 * r + 2)];
    let (p, q) = (row(3), row(4));
    let sorted = |i: usize| if p[i] < q[i] { [p[i], q[i]] } else { [q[i], p[i]] };
    let aabb = if center {
        let magnitude = |x: S| S::from_ordinal(x.ordinal().saturating_abs());
        BoxNumbers::Center(p, q.each(magnitude))
    } else {
        BoxNumbers::Corners(three(|i| sorted(i)[0]), three(|i| sorted(i)[1]))
    };
    Case { vertices: [row(0), row(1), row(2)], aabb }
}

/// Of bits, which of them are picked, and in which form the box is given.
type Check<'a> = &'a dyn Fn([i64; 3], &[usize; 15], bool);

fn all(bits: BoxedStrategy<i64>, check: Check<'_>) {
    let config = ProptestConfig { failure_persistence: None, ..ProptestConfig::with_cases(10_000) };
    let picks = proptest::array::uniform15(0..6_usize);
    proptest!(config, |(bits in proptest::array::uniform3(bits), picks in picks, center: bool)| {
        check(bits, &picks, center);
    });
}

fn any<S: AnyBits>() {
    all(S::any_bits(), &|bits, picks, center| {
        let case = case_of(bits.each(S::of_bits), picks, center);
        let (triangle, aabb) = case.shapes();
        let answer = meets(&case);
        assert_eq!(triangle.overlaps(&aabb), answer, "{case:?}");
        let prepared = PreparedTriangle::new(&triangle);
        assert_eq!(prepared.overlaps(&aabb), answer, "prepared: {case:?}");
        assert!(triangle.may_overlap(&aabb) || !answer, "{case:?}");
    });
}

for_scalars!([
    f32: f32,
    f64: f64,
    i1f15: fixed::types::I1F15,
    i16f0: fixed::types::I16F0,
    i33f31: fixed::types::I33F31,
] any);
