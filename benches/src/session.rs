//! A session: scenes one after the other, each with its groups of candidates.

use std::error::Error;
use std::iter::once;
use std::path::Path;

use indicatif::{ProgressBar, ProgressStyle};

use crate::candidate::Candidate;
use crate::pairs::Pairs;
use crate::race;
use crate::report::Report;

/// Makes a group of candidates for a scene.
pub type Group<Scene> = (&'static str, Box<dyn Fn(&Scene) -> Vec<Candidate>>);

pub struct Session {
    rounds: usize,
    only: Option<String>,
    scene: Option<String>,
    report: Report,
    honest: bool,
}

impl Session {
    /// A session with `rounds` rounds, restricted to groups and scenes whose names contain the
    /// given texts.
    pub fn new(rounds: usize, only: Option<String>, scene: Option<String>) -> Self {
        Self { rounds, only, scene, report: Report::default(), honest: true }
    }

    /// Times the groups on one scene and prints their table. Each group brings its own data, races
    /// against the yardstick, and is dropped before the next. Scenes with many pairs get fewer
    /// rounds.
    pub fn measure<L, R>(
        &mut self,
        name: &str,
        scene: impl FnOnce() -> Pairs<L, R>,
        yardstick: fn(&Pairs<L, R>) -> Candidate,
        groups: &[Group<Pairs<L, R>>],
    ) {
        let wanted = |name: &str, part: &Option<String>| {
            part.as_ref().is_none_or(|part| name.contains(part.as_str()))
        };
        let groups: Vec<_> = groups.iter().filter(|(name, _)| wanted(name, &self.only)).collect();
        if groups.is_empty() || !wanted(name, &self.scene) {
            return;
        }
        let scene = scene();
        let yardstick = yardstick(&scene);
        let rounds = race::rounds(self.rounds, yardstick.pairs);
        let bar = ProgressBar::new((rounds * groups.len()) as u64);
        let style = ProgressStyle::with_template("{prefix} {wide_bar} {msg} {eta}");
        bar.set_style(style.expect("the template is valid"));
        bar.set_prefix(name.to_owned());

        let mut first = true;
        for (group, make) in groups {
            bar.set_message(*group);
            let made = make(&scene);
            let candidates: Vec<&Candidate> = once(&yardstick).chain(&made).collect();
            let timings = race::race(&candidates, rounds, &bar);
            for (candidate, timing) in candidates.iter().zip(&timings).skip(usize::from(!first)) {
                self.honest &= candidate.kept_its_word();
                self.report.add(name, candidate, timing);
            }
            first = false;
        }
        bar.finish_and_clear();
        println!("{name}, {} pairs\n{}\n", yardstick.pairs, self.report.table(name));
    }

    /// Whether every test kept its promise.
    pub fn is_honest(&self) -> bool {
        self.honest
    }

    pub fn write_csv(&self, path: &Path) -> Result<(), Box<dyn Error>> {
        self.report.write_csv(path)
    }
}
