//! Spheres, capsules and points near triangles; the oracle compares squared distances, which are
//! rational.

use septum::Triangle;
use septum_kit::spheres::{CapsuleCase, Other, SphereCase, SphereSet};
use septum_kit::{Rng, Sample};

use super::{Exam, in_scalar};
use crate::candidate::{Candidate, Course};
use crate::distance::{Closest, Near, OfCapsule, OfSphere, Query, course, ours};

/// Without the ends of the range, where parry3d stops at an assertion.
const SETS: [(SphereSet, &str); 6] = [
    (SphereSet::Random, "random"),
    (SphereSet::Grid, "grid"),
    (SphereSet::Slivers, "slivers"),
    (SphereSet::Far, "far"),
    (SphereSet::Small, "small"),
    (SphereSet::Touch, "touch"),
];

fn sets<Q: Query, S: Sample>(
    scalar: &'static str,
    case: fn(SphereSet, &mut Rng) -> CapsuleCase<S>,
) -> Vec<Exam<&'static str>> {
    let exam = |(set, label): (SphereSet, &'static str)| Exam {
        label,
        ask: Box::new(move |seed: u64, count: usize| {
            let rng = &mut Rng::new(seed ^ (set as u64 + 240) << 56);
            let near = std::iter::repeat_with(|| case(set, rng)).filter_map(|case| match case {
                CapsuleCase { other: Other::Triangle(triangle), .. } => Some((case, triangle)),
                _ => None,
            });
            answers::<Q, S>(scalar, near.take(count))
        }) as super::Ask,
    };
    SETS.into_iter().map(exam).collect()
}

fn of_sphere<S: Sample>(set: SphereSet, rng: &mut Rng) -> CapsuleCase<S> {
    let SphereCase { center, radius, other } = set.case(rng);
    CapsuleCase { ends: [center; 2], radius, other }
}

pub(crate) fn sphere_sets<S: Sample>(scalar: &'static str) -> Vec<Exam<&'static str>> {
    sets::<OfSphere, S>(scalar, of_sphere)
}

pub(crate) fn capsule_sets<S: Sample>(scalar: &'static str) -> Vec<Exam<&'static str>> {
    sets::<OfCapsule, S>(scalar, SphereSet::capsule)
}

pub(crate) fn closest_sets<S: Sample>(scalar: &'static str) -> Vec<Exam<&'static str>> {
    sets::<Closest, S>(scalar, of_sphere)
}

/// Our answers, and in floats the textbook's and the peer's, for these cases.
pub(crate) fn answers<Q: Query, S: Sample>(
    scalar: &'static str,
    cases: impl IntoIterator<Item = Near<S>>,
) -> Vec<Candidate> {
    let course = course::<Q, S>(scalar, cases);
    let mut all = ours::<Q, S>(&course);
    if let Some(course) = in_scalar::<Course<Q::Asked<f32>, Triangle<f32>>>(&course) {
        all.extend(Q::in_f32(course));
    }
    if let Some(course) = in_scalar::<Course<Q::Asked<f64>, Triangle<f64>>>(&course) {
        all.extend(Q::in_f64(course));
    }
    all
}
