//! Points of the chart, and their table.

use std::error::Error;
use std::path::Path;

use serde::{Deserialize, Serialize};

/// One test, in one scalar, on shapes in one form, on one workload.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub(super) struct Point {
    pub(super) picture: String,
    pub(super) test: String,
    pub(super) scalar: String,
    pub(super) form: String,
    pub(super) peer: bool,
    /// Time relative to the yardstick: lower quartile, median, upper quartile of the
    /// rounds.
    pub(super) time_low: f64,
    pub(super) time: f64,
    pub(super) time_high: f64,
    /// Cases of all sets together.
    pub(super) cases: u64,
    pub(super) false_disjoint: u64,
    pub(super) false_overlap: u64,
    /// Wrong answers per million on the set with most of them, and on the mean set.
    pub(super) worst_set: String,
    pub(super) worst: f64,
    pub(super) mean: f64,
}

impl Point {
    pub(super) fn claims_to_be_exact(&self) -> bool {
        !self.peer && (self.test.starts_with("exact") || self.test.starts_with("segment, exact"))
    }
}

pub(super) fn write(path: &Path, points: &[Point]) -> Result<(), Box<dyn Error>> {
    if let Some(folder) = path.parent() {
        std::fs::create_dir_all(folder)?;
    }
    let mut writer = csv::Writer::from_path(path).map_err(|e| named(path, e))?;
    for point in points {
        writer.serialize(point)?;
    }
    Ok(writer.flush()?)
}

pub(super) fn read(path: &Path) -> Result<Vec<Point>, Box<dyn Error>> {
    let mut reader = csv::Reader::from_path(path).map_err(|e| named(path, e))?;
    Ok(reader.deserialize().collect::<Result<_, _>>().map_err(|e| named(path, e))?)
}

fn named(path: &Path, error: csv::Error) -> String {
    format!("{}: {error}", path.display())
}
