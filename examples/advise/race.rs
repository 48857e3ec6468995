//! Timing: the types take turns, round after round, in one process.

use std::hint::black_box;
use std::time::{Duration, Instant};

use indicatif::{ProgressBar, ProgressStyle};

use crate::kind::Kind;
use crate::scene::{Query, Scene};
use crate::verdict::Asking;

const ROUNDS: usize = 60;

/// The number of rounds for types that take more than `AGES` times as long, as exact sums do if
/// they decide every query.
const FEW: usize = 3;
const AGES: f64 = 20.0;

/// Time of a query relative to the yardstick's, in the same round.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Timing {
    pub(crate) median: f64,
    /// The range of the rounds without the upper and the lower tenth.
    pub(crate) usual: [f64; 2],
}

/// Times all kinds on the same queries, relative to `yardstick`. Also returns the
/// yardstick's best time of a query.
pub(crate) fn race(
    scene: &Scene,
    yardstick: Kind,
    kinds: &[Kind],
    queries: &[Query],
) -> (Duration, Vec<Timing>) {
    let runners: Vec<Asking> =
        [yardstick].iter().chain(kinds).map(|kind| kind.asking(scene, queries)).collect();
    let bar = ProgressBar::new(ROUNDS as u64).with_message("Timing");
    bar.set_style(
        ProgressStyle::with_template("{msg} {bar:40} round {pos} of {len}, {eta} left")
            .expect("a valid template"),
    );
    let mut seconds = vec![Vec::with_capacity(ROUNDS); runners.len()];
    for round in 0..ROUNDS {
        for turn in 0..runners.len() {
            let k = (turn + round) % runners.len();
            if round >= FEW && seconds[k][0] > AGES * seconds[0][0] {
                continue;
            }
            seconds[k].push(time(&runners[k]));
        }
        bar.inc(1);
    }
    bar.finish_and_clear();
    let best = seconds[0].iter().copied().fold(f64::INFINITY, f64::min);
    let timing = |k: usize| {
        let mut ratios: Vec<f64> =
            seconds[k].iter().zip(&seconds[0]).map(|(time, unit)| time / unit).collect();
        ratios.sort_by(f64::total_cmp);
        let (rounds, tenth) = (ratios.len(), ratios.len() / 10);
        Timing { median: ratios[rounds / 2], usual: [ratios[tenth], ratios[rounds - 1 - tenth]] }
    };
    let each = Duration::from_secs_f64(best / queries.len() as f64);
    (each, (1..runners.len()).map(timing).collect())
}

/// The time of the faster of two passes. The first one brings the data into the cache.
fn time(run: &Asking) -> f64 {
    let pass = || {
        let start = Instant::now();
        black_box(run());
        start.elapsed().as_secs_f64()
    };
    pass().min(pass())
}
