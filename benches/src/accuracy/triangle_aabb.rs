//! Triangles and boxes; the oracle clips.

use std::any::TypeId;

use septum::{Aabb, Triangle};

use crate::candidate::{Candidate, Course};
use crate::pairs::Pairs;
use crate::triangle_aabb as tests;
use crate::unit::Form;
use septum_kit::{BoxNumbers, Case, Sample, Set, meets};

use super::{Exam, in_scalar};

/// Every set for which the scalar has the range, for our modes.
pub(crate) fn sets<S: Sample>(scalar: &'static str) -> Vec<Exam<&'static str>> {
    let exam = |set: Set| Exam {
        label: set.name(),
        ask: Box::new(move |seed, count| {
            let cases = set.cases::<S>(seed, count);
            let mut all = ours(scalar, &cases);
            all.extend(peers(scalar, &cases));
            all
        }),
    };
    Set::ALL.into_iter().filter(|set| set.misfit::<S>().is_none()).map(exam).collect()
}

/// Our modes, each with boxes in either form.
pub(crate) fn ours<S: Sample>(scalar: &'static str, cases: &[Case<S>]) -> Vec<Candidate> {
    Form::ALL.into_iter().flat_map(|form| tests::ours(&course(scalar, cases, form))).collect()
}

/// The peers, for scalars that they support.
pub(crate) fn peers<S: Sample>(scalar: &'static str, cases: &[Case<S>]) -> Vec<Candidate> {
    if TypeId::of::<S>() != TypeId::of::<f32>() {
        return Vec::new();
    }
    let [by_center, by_corners] = Form::ALL.map(|form| course(scalar, cases, form));
    match (in_scalar::<In<f32>>(&by_center), in_scalar::<In<f32>>(&by_corners)) {
        (Some(by_center), Some(by_corners)) => tests::peers_on(by_center, by_corners),
        _ => Vec::new(),
    }
}

type In<S> = Course<Triangle<S>, Aabb<S>>;

fn course<S: Sample>(scalar: &'static str, cases: &[Case<S>], form: Form) -> In<S> {
    let (mut pairs, mut truth) = (Pairs::default(), Vec::new());
    for case in cases {
        if matches!(case.aabb, BoxNumbers::Center(..)) == (form == Form::Center) {
            pairs.push(case.triangle(), [case.aabb()]);
            truth.push(meets(case));
        }
    }
    Course::new((scalar, form.name()), pairs, truth)
}
