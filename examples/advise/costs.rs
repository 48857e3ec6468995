//! What a query costs on a small core, from committed tables.

use std::collections::BTreeMap;
use std::error::Error;
use std::path::{Path, PathBuf};

use crate::kind::Kind;
use crate::options::Target;
use crate::rung::Rung;

/// A figure of a table.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Figure {
    pub(crate) value: f64,
    /// Whether it is that of another type.
    pub(crate) is_estimate: bool,
}

/// The tables, as far as they are there.
pub(crate) struct Costs {
    /// By scalar and path, for the exact triangle/box query.
    instructions: BTreeMap<(String, String), f64>,
    /// By scalar, bytes of a program that is that query.
    code: BTreeMap<String, f64>,
    /// What is not there.
    pub(crate) missing: Vec<String>,
}

impl Costs {
    /// From the folder of the tables.
    pub(crate) fn read(folder: &Path, target: Target) -> Result<Self, Box<dyn Error>> {
        let mut costs =
            Self { instructions: BTreeMap::new(), code: BTreeMap::new(), missing: Vec::new() };
        if target == Target::Host {
            return Ok(costs);
        }
        let name = target.name();
        for [core, query, scalar, mode, path, instructions] in costs.rows(
            folder,
            "target.csv",
            ["core", "query", "scalar", "mode", "path", "instructions"],
        )? {
            if core == name && query == "triangle/box" && mode == "exact" {
                costs.instructions.insert((scalar, path), number(&instructions)?);
            }
        }
        for [on, program, text] in costs.rows(folder, "flash.csv", ["target", "program", "text"])? {
            if on == name {
                if let Some(scalar) = program.strip_prefix("triangle/box exact ") {
                    costs.code.insert(scalar.into(), number(&text)?);
                }
            }
        }
        Ok(costs)
    }

    /// The columns by their names; no rows where there is no file.
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

    /// Instructions of a query all of whose 13 axes are tried, for queries that the
    /// rungs have these shares in.
    pub(crate) fn instructions(&self, kind: Kind, shares: &BTreeMap<Rung, f64>) -> Option<Figure> {
        let scalar = tabled(kind);
        let mut value = 0.0;
        for (rung, share) in shares {
            // The wider rung of 32 bits is the path of shapes as large as the type.
            let far = kind.bits() == 32 && *rung == Rung::I64;
            let path = if far { "whole range" } else { "full" };
            value += share * self.instructions.get(&(scalar.clone(), path.into()))?;
        }
        Some(Figure { value, is_estimate: scalar != kind.name() || shares.len() > 1 })
    }

    /// Bytes of code of a program that is the query.
    pub(crate) fn code(&self, kind: Kind) -> Option<Figure> {
        let scalar = tabled(kind);
        let value = *self.code.get(&scalar)?;
        Some(Figure { value, is_estimate: scalar != kind.name() })
    }
}

fn number(text: &str) -> Result<f64, String> {
    text.parse().map_err(|_| format!("a table of costs has {text:?} for a number"))
}

/// The type of the tables that has as many bits.
fn tabled(kind: Kind) -> String {
    match kind {
        Kind::Fixed { bits, .. } => Kind::Fixed { bits, frac: bits / 2 }.name(),
        Kind::F32 | Kind::F64 => kind.name(),
    }
}

impl Target {
    /// As the tables call it.
    pub(crate) fn name(self) -> &'static str {
        match self {
            Self::Host => "this machine",
            Self::M0 => "Cortex-M0",
            Self::M4f => "Cortex-M4F",
        }
    }
}
