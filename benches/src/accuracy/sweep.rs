//! A box that moves past a triangle; the oracle clips the prism of triangle and time.

use septum::sweep::Sweep;
use septum_kit::sweeps::{SweepCase, SweepSet};
use septum_kit::{BoxNumbers, Sample, Set};

use super::{Exam, in_scalar};
use crate::candidate::{Candidate, Course};
use crate::pairs::Pairs;
use crate::sweep::{Given, Shot, Timed, ours, peers};

const SETS: [(SweepSet, &str); 8] = [
    (SweepSet::Of(Set::Random), "random"),
    (SweepSet::Of(Set::Grid), "grid"),
    (SweepSet::Of(Set::Slivers), "slivers"),
    (SweepSet::Of(Set::Far), "far"),
    (SweepSet::Of(Set::Touch), "touch at rest"),
    (SweepSet::Touch, "touch"),
    (SweepSet::Graze, "graze"),
    (SweepSet::Floor, "floor"),
];

pub(crate) fn sets<S: Sample>(scalar: &'static str) -> Vec<Exam<&'static str>> {
    let exam = |(set, label): (SweepSet, &'static str)| Exam {
        label,
        ask: Box::new(move |seed, count| answers(scalar, &set.cases::<S>(seed, count))),
    };
    let is_held = |(set, _): &(SweepSet, &str)| match set {
        SweepSet::Of(set) => set.misfit::<S>().is_none(),
        _ => true,
    };
    SETS.into_iter().filter(is_held).map(exam).collect()
}

/// Our answers, and in `f32` the peers', for these cases.
pub(crate) fn answers<S: Sample>(scalar: &'static str, cases: &[SweepCase<S>]) -> Vec<Candidate> {
    let truth: Vec<bool> = cases.iter().map(|case| case.truth().is_some()).collect();
    let (mut pairs, mut shots) = (Pairs::default(), (Pairs::default(), Vec::new()));
    for (case, &meets) in cases.iter().zip(&truth) {
        let due = meets.then(|| latest(case));
        if let Some(given) = in_scalar(case).and_then(shot) {
            shots.0.push(Timed { given, due }, [()]);
            shots.1.push(meets);
        }
        let (triangle, aabb) = case.case.shapes();
        let given = Given { aabb, motion: case.motion().reversed(), triangle };
        pairs.push(Timed { given, due }, [()]);
    }
    let mut all = ours(&Course::new((scalar, ""), pairs, truth));
    if scalar == "f32" {
        all.extend(peers(&Course::new((scalar, ""), shots.0, shots.1)));
    }
    all
}

/// The true time of impact in `f64`, rounded down, for scalars that `f64` holds with digits to
/// spare. For other scalars only the verdict is checked.
fn latest<S: Sample>(case: &SweepCase<S>) -> f64 {
    if matches!(S::name().as_str(), "f64" | "I32F32") {
        return f64::INFINITY;
    }
    let wide = |p: [S; 3]| p.map(S::approximate);
    let aabb = case.case.aabb.map(S::approximate);
    let case = SweepCase {
        case: septum_kit::Case { vertices: case.case.vertices.map(wide), aabb },
        way: case.way.map(wide),
    };
    let (triangle, aabb) = case.case.shapes();
    triangle.first_contact(&case.motion(), &aabb).map_or(f64::INFINITY, |first| first.t)
}

/// The case in the peers' form, with the box by its centre and the motion as a difference, if `f32`
/// holds that.
fn shot(case: &SweepCase<f32>) -> Option<Shot> {
    let BoxNumbers::Center(center, half) = case.case.aabb else { return None };
    let [to, from] = case.way;
    let way = [0, 1, 2].map(|i: usize| to[i] - from[i]);
    let is_exact = (0..3).all(|i| f64::from(way[i]) == f64::from(to[i]) - f64::from(from[i]));
    is_exact.then_some(Shot { center, half, way, triangle: case.case.vertices })
}
