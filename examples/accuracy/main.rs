//! Counts wrong answers: every mode, on every scalar, on every set of cases,
//! against exact clipping.
//!
//! ```text
//! cargo run --release --example accuracy
//! ```
//!
//! Fails if the exact mode is ever wrong, or the conservative one misses an
//! overlap.

mod measure;
mod report;
#[path = "../../tests/support/mod.rs"]
mod support;

use std::num::NonZeroUsize;
use std::path::PathBuf;
use std::process::ExitCode;
use std::sync::Mutex;
use std::sync::atomic::{AtomicUsize, Ordering};

use clap::Parser;
use fixed::types::{I4F4, I8F8, I16F16, I32F32};
use indicatif::{ProgressBar, ProgressStyle};
use measure::{Instance, Tally};
use report::Row;
use support::Set;

/// Counts wrong answers of every mode, on every scalar, on every set of cases.
///
/// Each case is decided by exact clipping too: by another theorem than the
/// crate's. Prints wrong answers per million, false disjoint / false overlap.
#[derive(Parser)]
struct Options {
    /// Cases in each set
    #[arg(long, value_name = "N", default_value = "200000")]
    cases: NonZeroUsize,

    /// Seed of the cases: the same seed gives the same cases everywhere
    #[arg(long, value_name = "N", default_value_t = 0)]
    seed: u64,

    /// Writes the counts to this file too, as comma-separated values
    #[arg(long, value_name = "FILE")]
    csv: Option<PathBuf>,
}

/// Cases in one piece of work. Part of what makes a seed's cases what they are.
const PIECE: usize = 5_000;

/// One piece of one set in one scalar.
struct Job {
    row: usize,
    seed: u64,
    count: usize,
}

fn main() -> ExitCode {
    let options = Options::parse();
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
    if let Some(path) = &options.csv {
        if let Err(error) = std::fs::write(path, report::csv(&rows)) {
            eprintln!("error: {}: {error}", path.display());
            return ExitCode::FAILURE;
        }
    }
    let broken = report::broken_promises(&rows);
    for promise in &broken {
        eprintln!("error: {promise}");
    }
    if broken.is_empty() { ExitCode::SUCCESS } else { ExitCode::FAILURE }
}

/// Fills in the rows, on all cores.
fn run(options: &Options, rows: &mut [Row<'_>]) {
    let jobs: Vec<Job> = (0..rows.len())
        .filter(|&row| rows[row].misfit().is_none())
        .flat_map(|row| pieces(options, row))
        .collect();
    let bar = ProgressBar::new(jobs.iter().map(|job| job.count as u64).sum());
    bar.set_style(
        ProgressStyle::with_template("{bar:40} {human_pos} of {human_len} cases, {eta} left")
            .expect("a valid template"),
    );

    let (next, tallies) = (AtomicUsize::new(0), Mutex::new(vec![Tally::default(); rows.len()]));
    let threads = std::thread::available_parallelism().map_or(1, NonZeroUsize::get);
    std::thread::scope(|scope| {
        for _ in 0..threads {
            scope.spawn(|| {
                while let Some(job) = jobs.get(next.fetch_add(1, Ordering::Relaxed)) {
                    let tally = rows[job.row].measure(job.seed, job.count);
                    tallies.lock().expect("no thread panics")[job.row] += tally;
                    bar.inc(job.count as u64);
                }
            });
        }
    });
    bar.finish_and_clear();
    for (row, tally) in rows.iter_mut().zip(tallies.into_inner().expect("no thread panics")) {
        row.tally = tally;
    }
}

/// A set, piece by piece, so that its cases do not depend on the number of cores.
fn pieces(options: &Options, row: usize) -> impl Iterator<Item = Job> {
    let (cases, seed) = (options.cases.get(), options.seed);
    (0..cases.div_ceil(PIECE)).map(move |piece| Job {
        row,
        seed: seed.wrapping_add(piece as u64),
        count: PIECE.min(cases - piece * PIECE),
    })
}
