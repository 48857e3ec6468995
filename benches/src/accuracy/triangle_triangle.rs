//! Two triangles; the oracle computes in integers.

use septum::Triangle;
use septum_kit::flat::{Flat, FlatCase, FlatSet, Truth};
use septum_kit::{Rng, Sample};

use super::{Exam, in_scalar};
use crate::candidate::Course;
use crate::pairs::Pairs;
use crate::triangle_triangle::{by_axes, by_volumes, ours, peers};

type In<S> = Course<Triangle<S>, Triangle<S>>;

/// Every set for which the scalar has the range.
pub(crate) fn sets<S: Sample>(scalar: &'static str) -> Vec<Exam<&'static str>> {
    let exam = |set: FlatSet| Exam {
        label: name(set),
        ask: Box::new(move |seed, count| {
            let rng = &mut Rng::new(seed ^ (set as u64 + 160) << 56);
            let (mut pairs, mut truth) = (Pairs::default(), Vec::new());
            while truth.len() < count {
                let case: FlatCase<S> = set.case(rng);
                let Flat::Triangle([a, b, c]) = case.flat else { continue };
                let [d, e, f] = case.triangle;
                let (Ok(t), Ok(u)) = (Triangle::new(a, b, c), Triangle::new(d, e, f)) else {
                    continue;
                };
                pairs.push(t, [u]);
                truth.push(case.truth() != Truth::Apart);
            }
            let course = Course::new((scalar, ""), pairs, truth);
            let mut all = ours(&course);
            if let Some(course) = in_scalar::<In<f32>>(&course) {
                all.push(by_axes(course, "11 axes"));
                all.push(by_volumes(course));
                all.extend(peers(course));
            }
            all.extend(in_scalar::<In<f64>>(&course).map(by_volumes));
            all
        }),
    };
    let is_held = |set: &FlatSet| *set != FlatSet::Small || S::nearest(1.0 / 16384.0) != S::ZERO;
    FlatSet::ALL.into_iter().filter(is_held).map(exam).collect()
}

fn name(set: FlatSet) -> &'static str {
    match set {
        FlatSet::Random => "random",
        FlatSet::Grid => "grid",
        FlatSet::Plane => "in one plane",
        FlatSet::Touch => "touch",
        FlatSet::Slivers => "slivers",
        FlatSet::Far => "far",
        FlatSet::Small => "small",
        FlatSet::Bits => "bits",
        FlatSet::Huge => "huge",
    }
}
