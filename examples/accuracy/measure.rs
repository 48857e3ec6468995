//! Runs every mode on every case, and counts wrong answers.

use std::ops::AddAssign;

use septum::published;
use septum::{Aabb, Triangle};

use septum_kit::{Sample, Set, meets};

/// The modes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Mode {
    /// `overlaps`
    Exact,
    /// `may_overlap`
    Conservative,
    /// `overlaps_rounded`
    Rounded,
    /// `overlaps_as_published`
    Published,
}

impl Mode {
    pub(crate) const ALL: [Self; 4] =
        [Self::Exact, Self::Conservative, Self::Rounded, Self::Published];

    pub(crate) fn name(self) -> &'static str {
        match self {
            Self::Exact => "exact",
            Self::Conservative => "conservative",
            Self::Rounded => "rounded",
            Self::Published => "as published",
        }
    }

    fn ask<S: Sample>(self, triangle: &Triangle<S>, aabb: &Aabb<S>) -> bool {
        match self {
            Self::Exact => triangle.overlaps(aabb),
            Self::Conservative => triangle.may_overlap(aabb),
            Self::Rounded => published::shared_normal::overlaps(triangle, aabb),
            Self::Published => published::akenine_moller::overlaps(triangle, aabb),
        }
    }
}

/// Wrong answers of one mode.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) struct Wrong {
    pub(crate) false_disjoint: u64,
    pub(crate) false_overlap: u64,
}

/// The counts of one set.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Tally {
    pub(crate) cases: u64,
    pub(crate) overlaps: u64,
    /// In the order of [`Mode::ALL`].
    pub(crate) wrong: [Wrong; 4],
}

impl AddAssign for Tally {
    fn add_assign(&mut self, other: Self) {
        self.cases += other.cases;
        self.overlaps += other.overlaps;
        for (sum, wrong) in self.wrong.iter_mut().zip(other.wrong) {
            sum.false_disjoint += wrong.false_disjoint;
            sum.false_overlap += wrong.false_overlap;
        }
    }
}

/// The measurement, made for one scalar.
pub(crate) struct Instance {
    pub(crate) name: String,
    pub(crate) misfit: fn(Set) -> Option<&'static str>,
    pub(crate) measure: fn(Set, u64, usize) -> Tally,
}

impl Instance {
    pub(crate) fn of<S: Sample>() -> Self {
        Self { name: S::name(), misfit: Set::misfit::<S>, measure: measure::<S> }
    }
}

fn measure<S: Sample>(set: Set, seed: u64, count: usize) -> Tally {
    let mut tally = Tally::default();
    for case in set.cases::<S>(seed, count) {
        let (triangle, aabb) = case.shapes();
        let truth = meets(&case);
        tally.cases += 1;
        tally.overlaps += u64::from(truth);
        for (mode, wrong) in Mode::ALL.into_iter().zip(&mut tally.wrong) {
            let answer = mode.ask(&triangle, &aabb);
            wrong.false_disjoint += u64::from(truth && !answer);
            wrong.false_overlap += u64::from(answer && !truth);
        }
    }
    tally
}
