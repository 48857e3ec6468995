//! The cost of a query on a small core, from committed tables.

use std::collections::BTreeMap;
use std::error::Error;
use std::path::{Path, PathBuf};

use crate::kind::Kind;
use crate::options::Target;
use crate::question::Question;
use crate::stage::Stage;

/// A figure of a table.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Figure {
    pub(crate) value: f64,
    /// Whether the figure comes from a similar type.
    pub(crate) is_estimate: bool,
}

/// The cost of a query, by scalar and path.
type ByPath = BTreeMap<(String, String), f64>;

/// Cycles in a microsecond at 48 MHz, as fast as most cores without an FPU run.
const MEGAHERTZ: f64 = 48.0;

/// The tables that are there.
pub(crate) struct Costs {
    question: Question,
    instructions: ByPath,
    /// For Cortex-M0 only.
    cycles: ByPath,
    /// Code size of a program with that query alone, by scalar.
    code: BTreeMap<String, f64>,
    /// The names of the tables that are missing.
    pub(crate) missing: Vec<String>,
}

impl Costs {
    /// Reads the tables in a folder.
    pub(crate) fn read(
        folder: &Path,
        target: Target,
        question: Question,
    ) -> Result<Self, Box<dyn Error>> {
        let [asked, how, _] = question.in_tables();
        let mut costs = Self {
            question,
            instructions: BTreeMap::new(),
            cycles: BTreeMap::new(),
            code: BTreeMap::new(),
            missing: Vec::new(),
        };
        if target == Target::Host {
            return Ok(costs);
        }
        let name = target.name();
        for [core, query, scalar, mode, path, instructions] in costs.rows(
            folder,
            "target.csv",
            ["core", "query", "scalar", "mode", "path", "instructions"],
        )? {
            if core == name && query == asked && mode == how {
                costs.instructions.insert((scalar, path), number(&instructions)?);
            }
        }
        if target == Target::M0 {
            let columns = ["query", "scalar", "mode", "path", "M0"];
            for [query, scalar, mode, path, cycles] in costs.rows(folder, "cycles.csv", columns)? {
                if query == asked && mode == how {
                    costs.cycles.insert((scalar, path), number(&cycles)?);
                }
            }
        }
        for [on, program, text] in costs.rows(folder, "flash.csv", ["target", "program", "text"])? {
            if on == name {
                if let Some(scalar) = program.strip_prefix(&format!("{asked} {how} ")) {
                    costs.code.insert(scalar.into(), number(&text)?);
                }
            }
        }
        Ok(costs)
    }

    /// The columns with these names. A missing file has no rows.
    fn rows<const N: usize>(
        &mut self,
        folder: &Path,
        file: &str,
        columns: [&str; N],
    ) -> Result<Vec<[String; N]>, Box<dyn Error>> {
        let path: PathBuf = folder.join(file);
        let in_file = |e: &dyn std::fmt::Display| format!("{}: {e}", path.display());
        if !path.exists() {
            self.missing.push(format!("docs/{file}"));
            return Ok(Vec::new());
        }
        let mut reader = csv::Reader::from_path(&path).map_err(|e| in_file(&e))?;
        let headers = reader.headers().map_err(|e| in_file(&e))?.clone();
        let mut places = [0; N];
        for (place, column) in places.iter_mut().zip(columns) {
            *place = headers
                .iter()
                .position(|header| header == column)
                .ok_or_else(|| in_file(&format!("has no column {column}")))?;
        }
        let mut rows = Vec::new();
        for record in reader.records() {
            let record = record.map_err(|e| in_file(&e))?;
            rows.push(places.map(|i| record.get(i).unwrap_or_default().to_owned()));
        }
        Ok(rows)
    }

    /// Instructions of a query that tests all axes.
    pub(crate) fn instructions(&self, kind: Kind, shares: &BTreeMap<Stage, f64>) -> Option<Figure> {
        self.average(&self.instructions, kind, shares)
    }

    /// Whether there is a table of cycles for the query.
    pub(crate) fn has_cycles(&self) -> bool {
        !self.cycles.is_empty()
    }

    /// Microseconds of that query at 48 MHz, with memory without wait states. Without a table of
    /// cycles it is an estimate of a cycle for each instruction; real cores take more.
    pub(crate) fn time(&self, kind: Kind, shares: &BTreeMap<Stage, f64>) -> Option<Figure> {
        let (table, is_guess) = match self.cycles.is_empty() {
            true => (&self.instructions, true),
            false => (&self.cycles, false),
        };
        let Figure { value, is_estimate } = self.average(table, kind, shares)?;
        Some(Figure { value: value / MEGAHERTZ, is_estimate: is_estimate || is_guess })
    }

    /// Bytes of code of a program with that query alone.
    pub(crate) fn code(&self, kind: Kind) -> Option<Figure> {
        let scalar = tabled(kind);
        let value = *self.code.get(&scalar)?;
        Some(Figure { value, is_estimate: scalar != kind.name() })
    }

    /// The average over the stages, by their shares of the queries.
    fn average(&self, table: &ByPath, kind: Kind, shares: &BTreeMap<Stage, f64>) -> Option<Figure> {
        let scalar = tabled(kind);
        let [_, _, usual] = self.question.in_tables();
        let mut value = 0.0;
        for (stage, share) in shares {
            // The tables measure the wider stage of 32 bits on shapes as large as the type; for
            // other queries they have only the first stage.
            let far =
                self.question == Question::Overlap && kind.bits() == 32 && *stage == Stage::I64;
            let path = if far { "whole range" } else { usual };
            value += share * table.get(&(scalar.clone(), path.into()))?;
        }
        Some(Figure { value, is_estimate: scalar != kind.name() || shares.len() > 1 })
    }
}

fn number(text: &str) -> Result<f64, String> {
    text.parse().map_err(|_| format!("a table of costs has {text:?} for a number"))
}

/// The type in the tables with the same number of bits.
fn tabled(kind: Kind) -> String {
    match kind {
        Kind::Fixed { bits, .. } => Kind::Fixed { bits, frac: bits / 2 }.name(),
        Kind::F32 | Kind::F64 => kind.name(),
    }
}

impl Target {
    /// Its name in the tables.
    pub(crate) fn name(self) -> &'static str {
        match self {
            Self::Host => "this machine",
            Self::M0 => "Cortex-M0",
            Self::M4f => "Cortex-M4F",
            Self::Rv32 => "RV32IMC",
        }
    }
}
