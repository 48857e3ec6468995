//! Counts wrong answers about rays and triangles: every method, in every scalar, on every set of
//! cases, compared with the intersection in exact fractions. Also counts the rays that leak through
//! closed meshes, and measures the error of t.
//!
//! ```text
//! cargo rays
//! ```
//!
//! Fails if an exact method is ever wrong, lets a ray through, or returns a t with a larger error
//! than documented. Also fails if `hit_once` counts a wall twice.

mod leaks;
mod measure;
mod report;

use std::fs::File;
use std::io::Write;
use std::num::NonZeroUsize;
use std::path::{Path, PathBuf};
use std::process::ExitCode;

use clap::Parser;
use fixed::types::{I8F8, I16F16, I32F32};
use leaks::LeakRow;
use measure::{Instance, SetRow};
use septum_kit::jobs::{on_all_cores, pieces};
use septum_kit::rays::{Aim, RaySet, Scene};
use septum_tools::cli::{self, any, valid};

/// Counts wrong answers about rays and triangles, and leaks through closed meshes.
///
/// Solving for the point in exact fractions decides each case too. Prints
/// wrong answers per million, false miss / false hit; rays per million that get
/// through a wall of a closed mesh unseen, or meet it twice; and the largest error
/// of t.
#[derive(Parser)]
struct Options {
    /// Cases in each set, and rays at each kind of target of each mesh
    #[arg(long, value_name = "N", default_value = "100000", allow_negative_numbers = true,
        value_parser = valid("a whole number from 1 to 10^9", |&n: &NonZeroUsize| n <= MOST_CASES))]
    cases: NonZeroUsize,

    /// Seed of the cases: the same seed gives the same cases everywhere
    #[arg(long, value_name = "N", default_value_t = 0, allow_negative_numbers = true,
        value_parser = any::<u64>("a whole number of 64 bits"))]
    seed: u64,

    /// Writes the counts to this file too, as comma-separated values
    #[arg(long, value_name = "FILE")]
    csv: Option<PathBuf>,
}

/// More cases would take days, and their list of pieces much memory.
const MOST_CASES: NonZeroUsize = NonZeroUsize::new(1_000_000_000).unwrap();

/// Cases in one piece of work. The cases of a seed depend on it.
const PIECE: usize = 5_000;

/// A piece of one row of a table.
struct Job {
    is_set: bool,
    row: usize,
    seed: u64,
    count: usize,
}

enum Outcome {
    Set(measure::Tally),
    Leaks(leaks::Tally),
}

fn main() -> ExitCode {
    let options: Options = cli::read();
    // Whether the counts can be written is known before they are made.
    let csv = match options.csv.as_deref().map(|path| (path, File::create(path))) {
        None => None,
        Some((path, Ok(file))) => Some((path, file)),
        Some((path, Err(error))) => return cannot_write(path, &error),
    };
    let scalars = [
        Instance::of::<f32>(),
        Instance::of::<f64>(),
        Instance::of::<I8F8>(),
        Instance::of::<I16F16>(),
        Instance::of::<I32F32>(),
    ];
    let mut sets: Vec<SetRow<'_>> = scalars
        .iter()
        .flat_map(|scalar| RaySet::ALL.map(|set| SetRow { scalar, set, tally: Default::default() }))
        .collect();
    let mut leaks: Vec<LeakRow<'_>> = Vec::new();
    for scalar in &scalars {
        for scene in Scene::ALL {
            leaks.extend(Aim::ALL.map(|aim| LeakRow {
                scalar,
                scene,
                aim,
                tally: Default::default(),
            }));
        }
    }
    run(&options, &mut sets, &mut leaks);

    report::print(&sets, &leaks);
    if let Some((path, mut file)) = csv {
        if let Err(error) = file.write_all(report::csv(&sets, &leaks).as_bytes()) {
            return cannot_write(path, &error);
        }
    }
    let broken = report::broken_promises(&sets, &leaks);
    for promise in &broken {
        eprintln!("error: {promise}");
    }
    if broken.is_empty() { ExitCode::SUCCESS } else { ExitCode::FAILURE }
}

fn cannot_write(path: &Path, error: &std::io::Error) -> ExitCode {
    eprintln!("error: {}: cannot be written: {error}", path.display());
    ExitCode::FAILURE
}

/// Fills in the rows, on all cores.
fn run(options: &Options, sets: &mut [SetRow<'_>], leaks: &mut [LeakRow<'_>]) {
    let of_row = |is_set: bool, row: usize| {
        let job = move |(seed, count)| Job { is_set, row, seed, count };
        pieces(options.seed, options.cases.get(), PIECE).map(job)
    };
    let fit = |row: &usize| sets[*row].misfit().is_none();
    let mut jobs: Vec<Job> =
        (0..sets.len()).filter(fit).flat_map(|row| of_row(true, row)).collect();
    let fit = |row: &usize| leaks[*row].misfit().is_none();
    jobs.extend((0..leaks.len()).filter(fit).flat_map(|row| of_row(false, row)));

    let mut set_tallies = vec![measure::Tally::default(); sets.len()];
    let mut leak_tallies = vec![leaks::Tally::default(); leaks.len()];
    on_all_cores(
        &jobs,
        |job| job.count,
        |job| {
            if job.is_set {
                Outcome::Set(sets[job.row].measure(job.seed, job.count))
            } else {
                Outcome::Leaks(leaks[job.row].measure(job.seed, job.count))
            }
        },
        |job, outcome| match outcome {
            Outcome::Set(tally) => set_tallies[job.row] += tally,
            Outcome::Leaks(tally) => leak_tallies[job.row] += tally,
        },
    );
    sets.iter_mut().zip(set_tallies).for_each(|(row, tally)| row.tally = tally);
    leaks.iter_mut().zip(leak_tallies).for_each(|(row, tally)| row.tally = tally);
}
