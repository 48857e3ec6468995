//! `overlaps` gives the exact answer: on every set, in every scalar, and on numbers of any
//! magnitude, compared with exact clipping.

use fixed::types::{I1F15, I16F0, I33F31};
use proptest::prelude::*;
use septum::prepared::PreparedTriangle;
use septum_kit::{BoxNumbers, Case, Each, Sample, Set, for_every_scalar, meets, three};

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
fn case_of<S: Sample>(number: impl Strategy<Value = S>) -> impl Strategy<Value = Case<S>> {
    let pool = proptest::collection::vec(number, 3);
    (pool, proptest::array::uniform15(0..6_usize), any::<bool>()).prop_map(
        |(pool, picks, center)| {
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
        },
    )
}

fn agrees<S: Sample>(case: &Case<S>) -> Result<(), TestCaseError> {
    let (triangle, aabb) = case.shapes();
    prop_assert_eq!(triangle.overlaps(&aabb), meets(case));
    prop_assert_eq!(PreparedTriangle::new(&triangle).overlaps(&aabb), meets(case));
    prop_assert!(triangle.may_overlap(&aabb) || !meets(case));
    Ok(())
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::with_cases(10_000) })]

    #[test]
    fn any_f32(case in case_of(proptest::num::f32::ANY.prop_filter("finite", |x| x.is_finite()))) {
        agrees(&case)?;
    }

    #[test]
    fn any_f64(case in case_of(proptest::num::f64::ANY.prop_filter("finite", |x| x.is_finite()))) {
        agrees(&case)?;
    }

    #[test]
    fn any_i1f15(case in case_of(any::<i16>().prop_map(I1F15::from_bits))) {
        agrees(&case)?;
    }

    #[test]
    fn any_i16f0(case in case_of(any::<i16>().prop_map(I16F0::from_bits))) {
        agrees(&case)?;
    }

    #[test]
    fn any_i33f31(case in case_of(any::<i64>().prop_map(I33F31::from_bits))) {
        agrees(&case)?;
    }
}
