//! Counts wrong answers of every candidate, ours and the peers', on cases that exact oracles
//! decide.

mod contact;
mod distance;
mod line_obb;
mod obb_obb;
mod ray_aabb;
mod ray_tree;
mod ray_triangle;
mod sweep;
mod triangle_aabb;
mod triangle_triangle;

pub(crate) use contact::{answers as contacts, sets as contact_sets};
pub(crate) use distance::{answers as distances, capsule_sets, closest_sets, sphere_sets};
pub(crate) use line_obb::sets as line_obb_sets;
pub(crate) use obb_obb::sets as obb_sets;
pub(crate) use ray_aabb::sets as ray_box_sets;
pub(crate) use ray_tree::sets as ray_tree_sets;
pub(crate) use ray_triangle::{
    ours as ray_triangle, peers as ray_triangle_peers, sets as ray_triangle_sets,
};
pub(crate) use sweep::{answers as sweeps, sets as sweep_sets};
pub(crate) use triangle_aabb::{
    ours as triangle_box, peers as triangle_box_peers, sets as triangle_box_sets,
};
pub(crate) use triangle_triangle::sets as triangle_pair_sets;

use std::any::Any;

use crate::candidate::Candidate;
use septum_kit::jobs::{on_all_cores, pieces};

/// Makes cases from a seed, and returns candidates that have answered them.
pub(crate) type Ask = Box<dyn Fn(u64, usize) -> Vec<Candidate> + Send + Sync>;

/// A set of cases for some candidates.
pub(crate) struct Exam<Label> {
    pub(crate) label: Label,
    pub(crate) ask: Ask,
}

/// The answers of one candidate on one set.
#[derive(Clone, Debug)]
pub(crate) struct Tally {
    pub(crate) who: String,
    pub(crate) scalar: &'static str,
    pub(crate) form: &'static str,
    pub(crate) cases: u64,
    pub(crate) false_disjoint: u64,
    pub(crate) false_overlap: u64,
}

impl Tally {
    fn new(candidate: &Candidate) -> Self {
        Self {
            who: candidate.who.clone(),
            scalar: candidate.scalar,
            form: candidate.form,
            cases: candidate.pairs as u64,
            false_disjoint: candidate.false_disjoint as u64,
            false_overlap: candidate.false_overlap as u64,
        }
    }

    pub(crate) fn per_million(&self) -> f64 {
        (self.false_disjoint + self.false_overlap) as f64 * 1e6 / self.cases.max(1) as f64
    }
}

/// Cases in one piece of work. A seed's cases depend on it.
const PIECE: usize = 5_000;

/// The tallies of each exam, in order; every exam has the same number of cases and the same seeds.
pub(crate) fn examine<Label: Sync>(exams: &[Exam<Label>], cases: usize) -> Vec<Vec<Tally>> {
    let jobs: Vec<(usize, u64, usize)> = (0..exams.len())
        .flat_map(|exam| pieces(0, cases, PIECE).map(move |(seed, count)| (exam, seed, count)))
        .collect();
    let mut tallies: Vec<Vec<Tally>> = exams.iter().map(|_| Vec::new()).collect();
    on_all_cores(
        &jobs,
        |&(_, _, count)| count,
        |&(exam, seed, count)| {
            (exams[exam].ask)(seed, count).iter().map(Tally::new).collect::<Vec<_>>()
        },
        |&(exam, ..), found| add(&mut tallies[exam], found),
    );
    tallies
}

fn add(sums: &mut Vec<Tally>, found: Vec<Tally>) {
    if sums.is_empty() {
        *sums = found;
        return;
    }
    for (sum, tally) in sums.iter_mut().zip(found) {
        debug_assert_eq!((&sum.who, sum.form), (&tally.who, tally.form));
        sum.cases += tally.cases;
        sum.false_disjoint += tally.false_disjoint;
        sum.false_overlap += tally.false_overlap;
    }
}

/// The course, if it is in this scalar, for methods that do not support all.
fn in_scalar<In: 'static>(course: &dyn Any) -> Option<&In> {
    course.downcast_ref()
}
