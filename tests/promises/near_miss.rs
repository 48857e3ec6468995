//! Verdicts are exact if a triangle and a box are one unit apart, touch, or overlap by one unit, at
//! every magnitude. The nearer to contact, the later the stage that decides.

use septum::prepared::PreparedTriangle;
use septum_kit::{NearMiss, Rng, Sample, for_every_scalar, meets};

fn exact_by_one_unit<S: Sample>() {
    let rng = &mut Rng::new(0x0911);
    for _ in 0..30_000 {
        let near = NearMiss::any::<S>(rng);
        for by_center in [true, false] {
            let case = near.case::<S>(rng, by_center);
            let (triangle, aabb) = case.shapes();
            let expected = near.meets;
            assert_eq!(meets(&case), expected, "the oracle: {near:?} {case:?}");
            assert_eq!(triangle.overlaps(&aabb), expected, "{case:?}");
            let prepared = PreparedTriangle::new(&triangle);
            assert_eq!(prepared.overlaps(&aabb), expected, "{case:?}");
            assert!(!expected || triangle.may_overlap(&aabb), "{case:?}");
        }
    }
}
for_every_scalar!(exact_by_one_unit);
