//! The result as a table for people, and as CSV.

use std::error::Error;
use std::path::Path;

use comfy_table::{CellAlignment, Table, presets};

use crate::candidate::Candidate;
use crate::race::Timing;

const HEADER: [&str; 12] = [
    "scene",
    "test",
    "scalar",
    "form",
    "speed",
    "time",
    "median",
    "least",
    "greatest",
    "ns",
    "overlaps",
    "wrong −/+",
];

/// Everything that was measured, in order.
#[derive(Default)]
pub struct Report {
    rows: Vec<[String; HEADER.len()]>,
}

impl Report {
    pub fn add(&mut self, scene: &str, candidate: &Candidate, timing: &Timing) {
        let ratio = |r: f64| if r < 0.1 { format!("{r:.4}") } else { format!("{r:.2}") };
        let [least, median, greatest] = timing.spread.map(ratio);
        self.rows.push([
            scene.into(),
            candidate.who.clone(),
            candidate.scalar.into(),
            candidate.form.into(),
            ratio(timing.ratio),
            format!("{:.3}", 1.0 / timing.ratio),
            median,
            least,
            greatest,
            format!("{:.1}", timing.best * 1e9 / candidate.pairs as f64),
            candidate.overlaps.to_string(),
            format!("{}/{}", candidate.false_disjoint, candidate.false_overlap),
        ]);
    }

    /// The rows of one scene.
    pub fn table(&self, scene: &str) -> Table {
        let mut table = Table::new();
        table.load_preset(presets::UTF8_BORDERS_ONLY).set_header(&HEADER[1..]);
        for row in self.rows.iter().filter(|row| row[0] == scene) {
            table.add_row(&row[1..]);
        }
        for column in table.column_iter_mut().skip(3) {
            column.set_cell_alignment(CellAlignment::Right);
        }
        table
    }

    pub fn write_csv(&self, path: &Path) -> Result<(), Box<dyn Error>> {
        let mut writer = csv::Writer::from_path(path)?;
        writer.write_record(HEADER)?;
        for row in &self.rows {
            writer.write_record(row)?;
        }
        Ok(writer.flush()?)
    }
}
