//! Rays and triangles; the oracle solves for the intersection.

use std::any::Any;

use septum::{Facing, Feature, Ray, Triangle};

use crate::candidate::{Candidate, Course};
use crate::native;
use crate::pairs::Pairs;
use crate::ray_triangle as tests;
use septum_kit::Sample;
use septum_kit::rays::{RayCase, RaySet, Truth, crossing};

use super::Exam;

/// Every set for which the scalar has the range. Peers, which support only t ≥ 0, skip the two sets
/// with other ranges.
pub(crate) fn sets<S: Sample>(scalar: &'static str) -> Vec<Exam<&'static str>> {
    let exam = |set: RaySet| Exam {
        label: set.name(),
        ask: Box::new(move |seed, count| {
            let cases = set.cases::<S>(seed, count);
            let mut all = ours(scalar, &cases);
            if !matches!(set, RaySet::Ranges | RaySet::Behind) {
                all.extend(peers(scalar, &cases));
            }
            all
        }),
    };
    RaySet::ALL.into_iter().filter(|set| set.misfit::<S>().is_none()).map(exam).collect()
}

type In<S> = Course<Ray<S>, Triangle<S>>;
type Solved<'a, S> = (&'a RayCase<S>, Option<Truth>);

/// Our methods.
pub(crate) fn ours<S: Sample>(scalar: &'static str, cases: &[RayCase<S>]) -> Vec<Candidate> {
    let solved = solve(cases);
    let all = course((scalar, ""), solved.iter(), |_| true);
    // In contact both answers of `hit_once` are right, so contacts are left out.
    let clear = course((scalar, ""), solved.iter().filter(|case| !is_contact(case)), |_| true);
    let is_once = |candidate: &Candidate| candidate.who.contains("once");
    let mut candidates = tests::ours(&all);
    candidates.retain(|candidate| !is_once(candidate));
    candidates.extend(tests::ours(&clear).into_iter().filter(is_once));
    candidates.extend(tests::rounded(&all));
    candidates
}

/// Methods that support only t ≥ 0, for the scalars that they support: the peers, and a naive
/// implementation.
pub(crate) fn peers<S: Sample>(scalar: &'static str, cases: &[RayCase<S>]) -> Vec<Candidate> {
    let solved = solve(cases);
    let asked = || solved.iter().filter(|(case, _)| case.is_plain());
    let plain: Box<dyn Any> = Box::new(course((scalar, ""), asked(), |_| true));
    let plain = match plain.downcast::<In<f32>>() {
        Ok(plain) => plain,
        Err(plain) => {
            return plain
                .downcast()
                .ok()
                .map(|plain| tests::wrapping(&plain))
                .into_iter()
                .collect();
        }
    };
    let front = |truth: &Truth| truth.facing == Facing::Front;
    let culling: Box<dyn Any> = Box::new(course((scalar, "culls"), asked(), front));
    let culling = culling.downcast::<In<f32>>().expect("the same scalar");
    let mut candidates = tests::peers(&plain, &culling);
    candidates.extend(native::rays(&plain));
    candidates.push(tests::in_floats(&plain));
    candidates.push(tests::distance_only(&plain));
    candidates
}

fn solve<S: Sample>(cases: &[RayCase<S>]) -> Vec<Solved<'_, S>> {
    cases.iter().map(|case| (case, crossing(case))).collect()
}

fn is_contact<S: Sample>((case, truth): &Solved<'_, S>) -> bool {
    let is_end = |truth: &Truth, end: &Option<S>| end.is_some_and(|x| truth.t.compare(x).is_eq());
    truth.as_ref().is_some_and(|truth| {
        truth.feature != Feature::Interior
            || is_end(truth, &case.t_min)
            || is_end(truth, &case.t_max)
    })
}

fn course<'a, S: Sample>(
    name: (&'static str, &'static str),
    solved: impl Iterator<Item = &'a Solved<'a, S>>,
    counts: fn(&Truth) -> bool,
) -> In<S> {
    let (mut pairs, mut truth) = (Pairs::default(), Vec::new());
    for (case, found) in solved {
        pairs.push(case.ray(), [case.triangle()]);
        truth.push(found.as_ref().is_some_and(counts));
    }
    Course::new(name, pairs, truth)
}

trait Plain {
    /// Whether the range is t ≥ 0.
    fn is_plain(&self) -> bool;
}

impl<S: Sample> Plain for RayCase<S> {
    fn is_plain(&self) -> bool {
        self.t_min == Some(S::ZERO) && self.t_max.is_none()
    }
}
