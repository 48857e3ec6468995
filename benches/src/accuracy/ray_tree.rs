//! Rays through a tree; the oracle tests every triangle.

use septum::Scalar;

use crate::candidate::Candidate;
use crate::ray_tree::{Aim, course, ours, peers, scene, yardstick_on};
use crate::unit::{F32, F64, I8F8_15, I16F16_18, I16F16_26, I32F32_34, Unit};

use super::Exam;

const SETS: [(Aim, &str); 2] = [(Aim::Anywhere, "random rays"), (Aim::Vertex, "rays at vertices")];

/// Both sets in every scalar.
pub(crate) fn sets() -> impl Iterator<Item = Vec<Exam<&'static str>>> {
    [
        of_all(),
        of_ours(F64),
        of_ours(I8F8_15),
        of_ours(I16F16_18),
        of_ours(I16F16_26),
        of_ours(I32F32_34),
    ]
    .into_iter()
}

/// Ours and the peers, in `f32`.
fn of_all() -> Vec<Exam<&'static str>> {
    exams(|aim, seed, count| {
        let course = course(&scene(aim, seed, count), &F32);
        let mut all = ours(&course);
        all.push(yardstick_on(&course));
        all.extend(peers(&course));
        all
    })
}

fn of_ours<S: Scalar>(unit: Unit<S>) -> Vec<Exam<&'static str>> {
    // A unit's name may list several numbers; the counts are for all numbers of the scalar.
    let unit = Unit { name: unit.name.split(',').next().expect("a name"), ..unit };
    exams(move |aim, seed, count| ours(&course(&scene(aim, seed, count), &unit)))
}

fn exams(
    ask: impl Fn(Aim, u64, usize) -> Vec<Candidate> + Copy + Send + Sync + 'static,
) -> Vec<Exam<&'static str>> {
    let exam =
        |(aim, label)| Exam { label, ask: Box::new(move |seed, count| ask(aim, seed, count)) };
    SETS.into_iter().map(exam).collect()
}
