//! Counts wrong answers: every mode, on every scalar, on every set of cases,
//! against exact clipping.
//!
//! ```text
//! cargo accuracy
//! ```
//!
//! Fails if the exact mode is ever wrong, or the conservative one misses an
//! overlap.

mod measure;
mod report;

use std::fs::File;
use std::io::Write;
use std::num::NonZeroUsize;
use std::path::{Path, PathBuf};
use std::process::ExitCode;

use clap::Parser;
use fixed::types::{I4F4, I8F8, I16F16, I32F32};
use measure::{Instance, Tally};
use report::Row;
use septum_kit::Set;
use septum_kit::jobs::{on_all_cores, pieces};
use septum_tools::cli::{self, any, valid};

/// Counts wrong answers of every mode, on every scalar, on every set of cases.
///
/// Exact clipping decides each case too, by another theorem than the crate's. Prints
/// wrong answers per million, false disjoint / false overlap.
#[derive(Parser)]
struct Options {
    /// Cases in each set
    #[arg(long, value_name = "N", default_value = "200000", allow_negative_numbers = true,
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

/// One piece of one set in one scalar.
struct Job {
    row: usize,
    seed: u64,
    count: usize,
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
        Instance::of::<I4F4>(),
        Instance::of::<I8F8>(),
        Instance::of::<I16F16>(),
        Instance::of::<I32F32>(),
    ];
    let mut rows: Vec<Row<'_>> =
        scalars.iter().flat_map(|scalar| Set::ALL.map(|set| Row::new(scalar, set))).collect();
    run(&options, &mut rows);

    report::print(&rows);
    if let Some((path, mut file)) = csv {
        if let Err(error) = file.write_all(report::csv(&rows).as_bytes()) {
            return cannot_write(path, &error);
        }
    }
    let broken = report::broken_promises(&rows);
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
fn run(options: &Options, rows: &mut [Row<'_>]) {
    let jobs: Vec<Job> = (0..rows.len())
        .filter(|&row| rows[row].misfit().is_none())
        .flat_map(|row| {
            let job = move |(seed, count)| Job { row, seed, count };
            pieces(options.seed, options.cases.get(), PIECE).map(job)
        })
        .collect();
    let mut tallies = vec![Tally::default(); rows.len()];
    on_all_cores(
        &jobs,
        |job| job.count,
        |job| rows[job.row].measure(job.seed, job.count),
        |job, tally| tallies[job.row] += tally,
    );
    for (row, tally) in rows.iter_mut().zip(tallies) {
        row.tally = tally;
    }
}
