//! Predicts the count over all queries from a sample.

/// The confidence of all predictions of a survey together.
pub(crate) const CONFIDENCE: f64 = 0.95;

/// A number of verdicts that rounding changes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Prediction {
    /// Counted in the sample.
    pub(crate) changed: u64,
    pub(crate) least: u64,
    pub(crate) most: u64,
}

impl Prediction {
    /// The prediction for `all` queries, from `changed` verdicts out of `asked`. The sample is
    /// drawn with replacement. All of `at_once` predictions together hold with the stated
    /// confidence.
    ///
    /// If a share p of all verdicts changes, a sample of n with k changed verdicts, or a less
    /// likely one, has a probability of at most exp(−n·d), where d is the divergence k/n·ln(k/n /
    /// p) + (1 − k/n)·ln((1 − k/n) / (1 − p)) (H. Chernoff, 1952). The prediction includes every
    /// share for which that is above half of the risk. Unlike the normal approximation this holds
    /// for every n and p.
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

    /// The count itself, if all queries were tested.
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

/// The boundary of the possible shares, between `inside`, which is possible, and `outside`. The
/// result is on the side of `outside`.
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
