//! The clock: candidates take turns, round after round, in one process.

use cpu_time::ThreadTime;
use indicatif::ProgressBar;
use std::hint::black_box;

use crate::candidate::Candidate;
use std::borrow::Borrow;

/// The time of a candidate, and its ratio to the first candidate.
pub struct Timing {
    /// Least time for the whole scene, in seconds.
    pub best: f64,
    /// The speed relative to the first candidate, by the best times.
    pub ratio: f64,
    /// The same ratio within each round: least, median, greatest.
    pub spread: [f64; 3],
    /// The same ratio: lower quartile, median, upper quartile.
    pub quartiles: [f64; 3],
}

/// The number of questions that a candidate is asked in all rounds of a scene, unless the scene is
/// too small.
const QUESTIONS: usize = 40_000_000;
/// The least number of rounds.
const FEWEST: usize = 6;

/// The number of rounds for a scene of so many pairs.
pub fn rounds(wanted: usize, pairs: usize) -> usize {
    wanted.min((QUESTIONS / pairs.max(1)).max(FEWEST))
}

/// Runs every candidate once in each round. The order rotates by one each round, so that a
/// temporary slowdown of the machine affects all candidates.
pub fn race<C: Borrow<Candidate>>(
    candidates: &[C],
    rounds: usize,
    bar: &ProgressBar,
) -> Vec<Timing> {
    let mut seconds = vec![Vec::with_capacity(rounds); candidates.len()];
    for round in 0..rounds {
        for turn in 0..candidates.len() {
            let k = (turn + round) % candidates.len();
            seconds[k].push(time(candidates[k].borrow()));
        }
        bar.inc(1);
    }
    let best = |k: usize| seconds[k].iter().copied().fold(f64::INFINITY, f64::min);
    let timing = |k: usize| {
        let mut ratios: Vec<f64> = seconds[0].iter().zip(&seconds[k]).map(|(a, b)| a / b).collect();
        ratios.sort_by(f64::total_cmp);
        let spread = [ratios[0], ratios[rounds / 2], ratios[rounds - 1]];
        let quartiles = [1, 2, 3].map(|q| ratios[(rounds - 1) * q / 4]);
        Timing { best: best(k), ratio: best(0) / best(k), spread, quartiles }
    };
    (0..candidates.len()).map(timing).collect()
}

/// The faster of two passes, because the first brings the data into the cache. Measured in this
/// thread's own time, so that other load on the machine matters less.
fn time(candidate: &Candidate) -> f64 {
    let pass = || {
        let start = ThreadTime::now();
        let count = black_box((candidate.run)());
        let seconds = start.elapsed().as_secs_f64();
        assert_eq!(count, candidate.overlaps, "{} changed its mind", candidate.who);
        seconds
    };
    pass().min(pass())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn large_scenes_get_fewer_rounds() {
        assert_eq!(rounds(100, 100_000), 100);
        assert_eq!(rounds(100, 1_000_000), 40);
        assert_eq!(rounds(100, 100_000_000), 6);
        assert_eq!(rounds(3, 100_000_000), 3);
        assert_eq!(rounds(3, 0), 3);
    }
}
