//! The survey of a scene: the effect of each type on it, and the cost of a query.

use std::collections::BTreeMap;
use std::time::Duration;

use septum_kit::Rng;

use crate::advice::Row;
use crate::costs::Costs;
use crate::effect::Effect;
use crate::kind::{Candidates, Kind};
use crate::options::Target;
use crate::prediction::Prediction;
use crate::question::Off;
use crate::race::race;
use crate::scene::{Query, Scene};
use crate::stage::Stage;
use crate::verdict;
use septum_kit::jobs::{on_all_cores, pieces};

/// Queries in one piece of work.
const PIECE: usize = 4096;

/// How many queries are timed. They stay in a cache.
const TIMED: usize = 8192;

/// The result.
pub(crate) struct Survey {
    pub(crate) rows: Vec<Row>,
    pub(crate) too_large: Vec<Kind>,
    /// The size of the sample, and whether it contains all queries.
    pub(crate) asked: u64,
    /// The time of a query in `f32`, if it was measured.
    pub(crate) each: Option<Duration>,
}

/// The plan of a survey.
pub(crate) struct Plan<'a> {
    pub(crate) target: Target,
    pub(crate) sample: usize,
    pub(crate) full: bool,
    pub(crate) costs: &'a Costs,
}

impl Survey {
    pub(crate) fn of(scene: &Scene, plan: &Plan<'_>) -> Self {
        let Candidates { held: kinds, too_large } = Candidates::of(scene);
        let all = scene.queries();
        let sample = sample(scene, plan.sample);
        let asked = sample.len() as u64;
        let changed = changes(scene, &kinds, asked, |n| sample[n as usize]);
        let counted = plan.full.then(|| changes(scene, &kinds, all, |n| scene.query(n)));

        let timed = &sample[..sample.len().min(TIMED)];
        let race = (plan.target == Target::Host && kinds.contains(&Kind::F32))
            .then(|| race(scene, Kind::F32, &kinds, timed));
        let effects: Vec<_> = kinds.iter().map(|&kind| Effect::of(kind, scene)).collect();
        let predicted = effects.iter().filter(|effect| effect.moved > 0.0).count();
        let row = |(k, &kind): (usize, &Kind)| {
            let (effect, shares) = (effects[k], Stage::shares(kind, plan.target, scene, &sample));
            let prediction = if effect.moved == 0.0 {
                // Without rounding the exact verdicts are the same.
                Prediction::counted(changed[k])
            } else {
                Prediction::new(changed[k], asked, all, predicted)
            };
            Row {
                kind,
                effect,
                off: Off::of(kind, scene, &sample),
                stages: in_words(kind, &shares),
                prediction,
                counted: counted.as_ref().map(|counted| counted[k]),
                timing: race.as_ref().map(|(_, timings)| timings[k]),
                instructions: plan.costs.instructions(kind, &shares),
                time: plan.costs.time(kind, &shares),
                code: plan.costs.code(kind),
            }
        };
        let rows = kinds.iter().enumerate().map(row).collect();
        Self { rows, too_large, asked, each: race.map(|(each, _)| each) }
    }
}

/// A random sample of queries, or all queries if there are no more than `most`.
fn sample(scene: &Scene, most: usize) -> Vec<Query> {
    let all = scene.queries();
    if all <= most as u64 {
        return (0..all).map(|n| scene.query(n)).collect();
    }
    let mut rng = Rng::new(0);
    (0..most).map(|_| scene.query(rng.whole(0, all as i64 - 1) as u64)).collect()
}

/// The number of queries for which each type changes the verdict, computed on all cores.
fn changes(
    scene: &Scene,
    kinds: &[Kind],
    count: u64,
    query: impl Fn(u64) -> Query + Sync,
) -> Vec<u64> {
    // With the first seed 0, a piece's seed is its index.
    let jobs: Vec<(u64, usize)> = pieces(0, count as usize, PIECE).collect();
    let mut sum = vec![0; kinds.len()];
    on_all_cores(
        &jobs,
        |&(_, size)| size,
        |&(piece, size)| {
            let first = piece * PIECE as u64;
            verdict::changes(scene, kinds, (first..first + size as u64).map(&query))
        },
        |_, changed| sum.iter_mut().zip(changed).for_each(|(sum, n)| *sum += n),
    );
    sum
}

/// The stages, with their shares if there are several.
fn in_words(kind: Kind, shares: &BTreeMap<Stage, f64>) -> String {
    let one = |(stage, share): (&Stage, &f64)| {
        let name = stage.name(kind);
        match shares.len() {
            1 => name.into(),
            _ => format!("{name} {:.0} %", 100.0 * share),
        }
    };
    shares.iter().map(one).collect::<Vec<_>>().join("\n")
}
