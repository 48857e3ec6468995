//! Rays, segments and boxes; the oracle clips the range of t.

use std::any::Any;

use septum::{Aabb, Ray};

use crate::candidate::{Candidate, Course};
use crate::pairs::Pairs;
use crate::ray_aabb as tests;
use crate::unit::Form;
use septum_kit::lines::{Line, LineBox, LineSet};
use septum_kit::{BoxNumbers, Rng, Sample};

use super::Exam;

/// Every set for which the scalar has the range.
pub(crate) fn sets<S: Sample>(scalar: &'static str) -> Vec<Exam<&'static str>> {
    let exam = |set: LineSet| Exam {
        label: name(set),
        ask: Box::new(move |seed, count| {
            let rng = &mut Rng::new(seed ^ (set as u64 + 128) << 56);
            let cases: Vec<LineBox<S>> = (0..count).map(|_| set.case(rng)).collect();
            let mut all = ours(scalar, &cases);
            all.extend(peers(scalar, &cases));
            all
        }),
    };
    let is_held = |set: &LineSet| *set != LineSet::Small || S::nearest(1.0 / 16384.0) != S::ZERO;
    LineSet::ALL.into_iter().filter(is_held).map(exam).collect()
}

fn name(set: LineSet) -> &'static str {
    match set {
        LineSet::Random => "random",
        LineSet::Grid => "grid",
        LineSet::Grazing => "grazing",
        LineSet::Far => "far",
        LineSet::Small => "small",
        LineSet::Huge => "huge",
        LineSet::Bits => "bits",
        LineSet::Axial => "axial",
    }
}

fn form<S>(case: &LineBox<S>) -> Form {
    match case.aabb {
        BoxNumbers::Center(..) => Form::Center,
        BoxNumbers::Corners(..) => Form::Corners,
    }
}

/// Our methods on rays and on segments, each with boxes in either form.
pub(crate) fn ours<S: Sample>(scalar: &'static str, cases: &[LineBox<S>]) -> Vec<Candidate> {
    let in_form = |wanted: Form| {
        let cases = || cases.iter().filter(move |case| form(case) == wanted);
        let rays = course((scalar, wanted.name()), cases(), LineBox::ray);
        let segments = course((scalar, wanted.name()), cases(), LineBox::segment);
        tests::ours(&rays, &segments)
    };
    Form::ALL.into_iter().flat_map(in_form).collect()
}

/// The peers, for scalars that they support: rays with t ≥ 0 and boxes by their corners.
pub(crate) fn peers<S: Sample>(scalar: &'static str, cases: &[LineBox<S>]) -> Vec<Candidate> {
    let plain: Vec<_> = cases
        .iter()
        .filter(|case| form(case) == Form::Corners)
        .filter_map(|case| match case.line {
            Line::Ray(o, d, _) => {
                Some(LineBox { line: Line::Ray(o, d, [Some(S::ZERO), None]), ..*case })
            }
            _ => None,
        })
        .collect();
    let rays: Course<Ray<S>, Aabb<S>> =
        course((scalar, Form::Corners.name()), plain.iter(), LineBox::ray);
    let rays: Box<dyn Any> = Box::new(rays);
    let Ok(rays) = rays.downcast::<Course<Ray<f32>, Aabb<f32>>>() else { return Vec::new() };
    let mut candidates = tests::peers(&rays);
    candidates.push(tests::parry_cast(&rays, "parry3d cast_local_ray"));
    candidates
}

fn course<'a, S: Sample, L: 'static>(
    name: (&'static str, &'static str),
    cases: impl Iterator<Item = &'a LineBox<S>>,
    line: impl Fn(&LineBox<S>) -> Option<L>,
) -> Course<L, Aabb<S>> {
    let (mut pairs, mut truth) = (Pairs::default(), Vec::new());
    for case in cases {
        if let Some(line) = line(case) {
            pairs.push(line, [case.aabb()]);
            truth.push(case.meets());
        }
    }
    Course::new(name, pairs, truth)
}
