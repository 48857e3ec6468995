//! A progress bar for long work.

use std::sync::OnceLock;
use std::sync::atomic::{AtomicU64, Ordering};
use std::time::{Duration, Instant};

use indicatif::{ProgressBar, ProgressStyle};

/// Work shorter than this shows no bar.
const PATIENCE: Duration = Duration::from_secs(1);

/// Counts work done, from any thread, and shows a bar once a second has passed.
pub(crate) struct Progress {
    label: &'static str,
    total: u64,
    done: AtomicU64,
    start: Instant,
    bar: OnceLock<ProgressBar>,
}

impl Progress {
    /// Starts the clock on work of unknown length. The label shows at once.
    pub(crate) fn of_unknown_length(label: &'static str) -> Self {
        let progress = Self::new(label, 0);
        let bar = ProgressBar::new_spinner().with_message(label);
        bar.enable_steady_tick(PATIENCE);
        progress.bar.get_or_init(|| bar);
        progress
    }

    /// Starts the clock on `total` units of work.
    pub(crate) fn new(label: &'static str, total: u64) -> Self {
        let (done, start, bar) = (AtomicU64::new(0), Instant::now(), OnceLock::new());
        Self { label, total, done, start, bar }
    }

    /// Counts `units` more as done.
    pub(crate) fn add(&self, units: u64) {
        let done = self.done.fetch_add(units, Ordering::Relaxed) + units;
        if self.start.elapsed() >= PATIENCE {
            self.bar.get_or_init(|| self.draw()).set_position(done);
        }
    }

    /// Takes the bar away, if there is one, and returns the time that the work took.
    pub(crate) fn finish(self) -> Duration {
        if let Some(bar) = self.bar.get() {
            bar.finish_and_clear();
        }
        self.start.elapsed()
    }

    fn draw(&self) -> ProgressBar {
        let bar = ProgressBar::new(self.total).with_message(self.label);
        let bar = bar.with_elapsed(self.start.elapsed());
        match ProgressStyle::with_template("{msg} {bar:40} {percent:>3} %, {elapsed}") {
            Ok(style) => bar.with_style(style),
            Err(_) => bar,
        }
    }
}
