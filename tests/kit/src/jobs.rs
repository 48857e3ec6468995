//! Counting over many cases: on all cores, with a progress bar, and readable figures.

use std::num::NonZeroUsize;
use std::sync::Mutex;
use std::sync::atomic::{AtomicUsize, Ordering};

use indicatif::{ProgressBar, ProgressStyle};

/// Runs all jobs on all cores, with a bar that advances by `size` for each, and passes their
/// outcomes on in any order.
pub fn on_all_cores<Job: Sync, Outcome: Send>(
    jobs: &[Job],
    size: impl Fn(&Job) -> usize + Sync,
    work: impl Fn(&Job) -> Outcome + Sync,
    gather: impl FnMut(&Job, Outcome) + Send,
) {
    let bar = ProgressBar::new(jobs.iter().map(|job| size(job) as u64).sum());
    bar.set_style(
        ProgressStyle::with_template("{bar:40} {human_pos} of {human_len} cases, {eta} left")
            .expect("a valid template"),
    );
    let (next, gather) = (AtomicUsize::new(0), Mutex::new(gather));
    let threads = std::thread::available_parallelism().map_or(1, NonZeroUsize::get);
    std::thread::scope(|scope| {
        for _ in 0..threads {
            scope.spawn(|| {
                while let Some(job) = jobs.get(next.fetch_add(1, Ordering::Relaxed)) {
                    let outcome = work(job);
                    gather.lock().expect("no thread panics")(job, outcome);
                    bar.inc(size(job) as u64);
                }
            });
        }
    });
    bar.finish_and_clear();
}

/// Seed and size of each piece of `cases` cases: pieces of a fixed size, so that
/// the cases do not depend on the number of cores.
pub fn pieces(seed: u64, cases: usize, piece: usize) -> impl Iterator<Item = (u64, usize)> {
    (0..cases.div_ceil(piece))
        .map(move |n| (seed.wrapping_add(n as u64), piece.min(cases - n * piece)))
}

/// With a comma at every third digit.
pub fn grouped(n: u64) -> String {
    let digits = n.to_string();
    let mut out = String::new();
    for (i, digit) in digits.chars().enumerate() {
        if i > 0 && (digits.len() - i) % 3 == 0 {
            out.push(',');
        }
        out.push(digit);
    }
    out
}

/// The rate per million cases.
pub fn per_million(wrong: u64, cases: u64) -> String {
    let rate = (wrong as f64 * 1e6 / cases as f64).round() as u64;
    if rate == 0 && wrong > 0 { "<1".into() } else { grouped(rate) }
}
