//! Checks many cases at the ends of each scalar's range against the oracles.
//!
//! `cargo edges` checks 100,000 cases of each kind and scalar, `cargo edges 1000000` a million. It
//! prints the number of wrong answers for each, and fails if there is one.

use std::panic::{AssertUnwindSafe, catch_unwind};
use std::process::ExitCode;

use fixed::types::extra::{U7, U64};
use fixed::types::{I4F4, I8F8, I16F16, I32F32};
use fixed::{FixedI8, FixedI64};
use septum::relation::Relate;
use septum_kit::aabbs::AabbSet;
use septum_kit::boxes::BoxSet;
use septum_kit::flat::FlatSet;
use septum_kit::jobs::{grouped, on_all_cores, pieces};
use septum_kit::lines::LineSet;
use septum_kit::meshes::MeshSet;
use septum_kit::sweeps::SweepSet;
use septum_kit::{Given, Oriented, Rng, Sample, Set, contact, fixed, side};

/// A kind of case of one scalar.
struct Kind {
    name: &'static str,
    checks: fn(seed: u64, count: usize) -> Counts,
    scalar: String,
}

#[derive(Clone, Default)]
struct Counts {
    asked: usize,
    wrong: usize,
    first: Option<String>,
}

impl Counts {
    /// Runs a check, which panics if an answer is wrong.
    fn ask(&mut self, check: impl FnOnce()) {
        self.asked += 1;
        if let Err(reason) = catch_unwind(AssertUnwindSafe(check)) {
            self.wrong += 1;
            let reason = reason.downcast_ref::<String>().cloned().unwrap_or_default();
            self.first.get_or_insert(reason);
        }
    }

    fn add(&mut self, other: Self) {
        self.asked += other.asked;
        self.wrong += other.wrong;
        self.first = self.first.take().or(other.first);
    }
}

fn boxes<S: Sample>(seed: u64, count: usize) -> Counts {
    let (mut rng, mut counts) = (Rng::new(seed), Counts::default());
    for _ in 0..count {
        let pair = AabbSet::Extreme.case::<S>(&mut rng);
        counts.ask(|| _ = pair.check());
    }
    counts
}

/// Every other pair of shapes at the ends of the type, where sums and differences overflow.
fn other_pairs<S: Sample>(seed: u64, count: usize) -> Counts {
    let (mut rng, mut counts) = (Rng::new(seed), Counts::default());
    let share = count / 8;
    for case in Set::Huge.cases::<S>(seed, share) {
        let (triangle, aabb) = case.shapes();
        counts.ask(|| {
            assert_eq!(triangle.relation(&aabb), contact::truth(&case).relation(), "{case:?}")
        });
        let [a, b, _] = case.vertices;
        let given = if rng.one_in(2) { Given::Point(b) } else { Given::Offset(b[0]) };
        if let Ok(plane) = given.plane(a) {
            let expected = side(a, given, case.aabb);
            counts.ask(|| assert_eq!(plane.side_of(&aabb), expected, "{plane:?} {aabb:?}"));
        }
    }
    for sweep in SweepSet::Of(Set::Huge).cases::<S>(seed, share) {
        counts.ask(|| _ = sweep.check());
    }
    for sweep in SweepSet::Of(Set::Huge).boxes::<S>(seed, share) {
        counts.ask(|| _ = sweep.check());
    }
    for _ in 0..share {
        let flat = FlatSet::Huge.case::<S>(&mut rng);
        counts.ask(|| _ = flat.check());
        let boxes = BoxSet::Huge.case::<S>(&mut rng);
        counts.ask(|| _ = boxes.check());
        let oriented = Oriented::<S>::case(BoxSet::Huge, &mut rng);
        counts.ask(|| _ = oriented.check());
        let line = LineSet::Huge.case::<S>(&mut rng);
        counts.ask(|| assert_eq!(line.overlaps(), line.meets(), "{line:?}"));
    }
    counts
}

fn rays<S: Sample>(seed: u64, count: usize, set: MeshSet) -> Counts {
    let (mut rng, mut counts) = (Rng::new(seed), Counts::default());
    for _ in 0..count {
        let case = set.ray::<S>(&mut rng);
        counts.ask(|| _ = case.check());
    }
    counts
}

fn beyond<S: Sample>(seed: u64, count: usize) -> Counts {
    rays::<S>(seed, count, MeshSet::Beyond)
}

fn near<S: Sample>(seed: u64, count: usize) -> Counts {
    rays::<S>(seed, count, MeshSet::Near)
}

/// Counts the triangles: each is asked about by itself too.
fn sweeps<S: Sample>(seed: u64, count: usize) -> Counts {
    let (mut rng, mut counts) = (Rng::new(seed), Counts::default());
    for k in 0..count / 16 {
        let case = MeshSet::ALL[k % 3].sweep::<S>(&mut rng);
        let triangles = case.mesh.faces.len();
        counts.ask(|| _ = case.check());
        counts.asked += triangles - 1;
    }
    counts
}

fn kinds_of<S: Sample>() -> [Kind; 5] {
    let kind = |name, checks| Kind { name, checks, scalar: S::name() };
    [
        kind("boxes, gaps that overflow", boxes::<S>),
        kind("other pairs, the same", other_pairs::<S>),
        kind("hits, t beyond the type", beyond::<S>),
        kind("hits, t alike as rounded", near::<S>),
        kind("sweeps past meshes", sweeps::<S>),
    ]
}

fn main() -> ExitCode {
    const PIECE: usize = 10_000;
    let argument = std::env::args().nth(1).map(|count| count.parse());
    let count: usize = argument.and_then(Result::ok).unwrap_or(100_000);
    let kinds: Vec<Kind> = [
        kinds_of::<f32>(),
        kinds_of::<f64>(),
        kinds_of::<I4F4>(),
        kinds_of::<FixedI8<U7>>(),
        kinds_of::<I8F8>(),
        kinds_of::<I16F16>(),
        kinds_of::<I32F32>(),
        kinds_of::<FixedI64<U64>>(),
    ]
    .into_iter()
    .flatten()
    .collect();
    // Wrong answers are printed below.
    std::panic::set_hook(Box::new(|_| {}));
    let jobs: Vec<_> =
        (0..kinds.len()).flat_map(|k| pieces(0xed6e, count, PIECE).map(move |p| (k, p))).collect();
    let mut all = vec![Counts::default(); kinds.len()];
    on_all_cores(
        &jobs,
        |&(_, (_, size))| size,
        |&(k, (seed, size))| (kinds[k].checks)(seed, size),
        |&(k, _), counts| all[k].add(counts),
    );
    for (Kind { name, scalar, .. }, Counts { asked, wrong, first }) in kinds.iter().zip(&all) {
        println!("{scalar:7} {name:26} {:>9} asked, {wrong} wrong", grouped(*asked as u64));
        if let Some(first) = first {
            println!("        {first}");
        }
    }
    let wrong = all.iter().any(|counts| counts.wrong > 0);
    if wrong { ExitCode::FAILURE } else { ExitCode::SUCCESS }
}
