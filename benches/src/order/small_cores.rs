//! The groups of axes in every order on small cores: instructions, from the table of the
//! example `measure`.

use std::error::Error;
use std::path::Path;

use serde::Deserialize;

use super::ORDERS;

#[derive(Deserialize)]
struct Line {
    core: String,
    query: String,
    scalar: String,
    mode: String,
    path: String,
    instructions: f64,
}

/// A core, a scalar and a workload, and the instructions of every order.
pub(super) struct Row {
    pub(super) core: String,
    pub(super) scalar: String,
    pub(super) workload: String,
    pub(super) instructions: [f64; ORDERS.len()],
}

pub(super) fn read(table: &Path) -> Result<Vec<Row>, Box<dyn Error>> {
    let at = |e: csv::Error| format!("{}: {e}", table.display());
    let mut rows: Vec<Row> = Vec::new();
    for line in csv::Reader::from_path(table).map_err(at)?.deserialize() {
        let Line { core, query, scalar, mode, path: workload, instructions } = line.map_err(at)?;
        if query != "order of axes" {
            continue;
        }
        let order = ORDERS.iter().position(|(name, _)| *name == mode);
        let order = order.ok_or_else(|| format!("{}: no order {mode}", table.display()))?;
        let is_same =
            |row: &&mut Row| (&row.core, &row.scalar, &row.workload) == (&core, &scalar, &workload);
        match rows.iter_mut().find(is_same) {
            Some(row) => row.instructions[order] = instructions,
            None => {
                let mut row = Row { core, scalar, workload, instructions: [0.0; ORDERS.len()] };
                row.instructions[order] = instructions;
                rows.push(row);
            }
        }
    }
    Ok(rows)
}
