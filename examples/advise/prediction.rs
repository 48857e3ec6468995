//! From a sample of the queries to all of them.

/// How sure a prediction is, for all types at once.
pub(crate) const CONFIDENCE: f64 = 0.95;

/// How many verdicts rounding changes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Prediction {
    /// Counted in the sample.
    pub(crate) changed: u64,
    pub(crate) least: u64,
    pub(crate) most: u64,
}

impl Prediction {
    /// The prediction for `all` queries, from `changed` verdicts of `asked`. The sample
    /// is drawn with replacement. All of `at_once` predictions together hold with the
    /// stated confidence.
    ///
    /// If a share of p has changed in truth, a sample in which k of n have, or a still
    /// less likely one, comes up with a probability of at most exp(−n·d), where d is
    /// the divergence k/n·ln(k/n / p) + (1 − k/n)·ln((1 − k/n) / (1 − p)). No share for
    /// which that is above half of the risk is left out (H. Chernoff, 1952). Unlike the
    /// normal approximation that holds for every n and p.
    pub(crate) fn new(changed: u64, asked: u64, all: u64, at_once: usize) -> Self {
        if asked == all {
            return Self::counted(changed);
        }
        let risk = (1.0 - CONFIDENCE) / at_once as f64;
        let limit = (2.0 / risk).ln() / asked as f64;
        let seen = changed as f64 / asked as f64;
        let possible = |p: f64| divergence(seen, p) <= limit;
        let low = boundary(|p| p > 0.0 && possible(p), 0.0, seen);
        let high = boundary(|p| p < 1.0 && possible(p), 1.0, seen);
        let all = all as f64;
        Self { changed, least: (low * all).floor() as u64, most: (high * all).ceil() as u64 }
    }

    /// The count itself, where all queries were asked.
    pub(crate) fn counted(changed: u64) -> Self {
        Self { changed, least: changed, most: changed }
    }

    pub(crate) fn allows(&self, counted: u64) -> bool {
        (self.least..=self.most).contains(&counted)
    }
}

fn divergence(q: f64, p: f64) -> f64 {
    let term = |q: f64, p: f64| if q == 0.0 { 0.0 } else { q * (q / p).ln() };
    term(q, p) + term(1.0 - q, 1.0 - p)
}

/// Where the possible shares end, between `inside`, which is possible, and `outside`.
/// The result is on the side of `outside`.
fn boundary(possible: impl Fn(f64) -> bool, mut outside: f64, mut inside: f64) -> f64 {
    for _ in 0..100 {
        let middle = (inside + outside) / 2.0;
        if possible(middle) {
            inside = middle;
        } else {
            outside = middle;
        }
    }
    outside
}
