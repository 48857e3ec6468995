//! The witness: `separating_axis` returns an axis exactly if there is no overlap, namely the first
//! that separates, and `is_separated_by` is right for each of the 13. Checked by projection on the
//! axes, in integers.

use septum::Axis;
use septum_kit::{Sample, Set, for_every_scalar, separates};

fn first_of_those_that_separate<S: Sample>() {
    for set in Set::ALL {
        for case in set.cases::<S>(51, 2_000) {
            let (triangle, aabb) = case.shapes();
            let mut first = None;
            for axis in Axis::ALL {
                let truth = separates(&case, axis);
                assert_eq!(
                    triangle.is_separated_by(&aabb, axis),
                    truth,
                    "{set:?} {axis:?} {case:?}"
                );
                first = first.or(truth.then_some(axis));
            }
            assert_eq!(triangle.separating_axis(&aabb), first, "{set:?}: {case:?}");
            assert_eq!(triangle.overlaps(&aabb), first.is_none(), "{set:?}: {case:?}");
        }
    }
}

/// Indices count modulo 3, because a stored axis may have any index.
fn indices_wrap<S: Sample>() {
    for case in Set::Random.cases::<S>(52, 2_000) {
        let (triangle, aabb) = case.shapes();
        let by = |axis| triangle.is_separated_by(&aabb, axis);
        for i in 0..3_u8 {
            assert_eq!(by(Axis::Face(i)), by(Axis::Face(252 + i)));
            for k in 0..3_u8 {
                let axis = Axis::Edge { axis: i, edge: k };
                assert_eq!(by(axis), by(Axis::Edge { axis: i + 3, edge: k + 252 }));
            }
        }
    }
}

for_every_scalar!(first_of_those_that_separate, indices_wrap);
