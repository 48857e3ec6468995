//! The tables.

use std::fmt::Write;

use super::measure::{Instance, Mode, Tally, Wrong};
use septum_kit::Set;
use septum_kit::jobs::{grouped, per_million};

/// One set in one scalar.
pub(crate) struct Row<'a> {
    scalar: &'a Instance,
    set: Set,
    pub(crate) tally: Tally,
}

impl<'a> Row<'a> {
    pub(crate) fn new(scalar: &'a Instance, set: Set) -> Self {
        Self { scalar, set, tally: Tally::default() }
    }

    /// Why the scalar cannot hold the set, if it cannot.
    pub(crate) fn misfit(&self) -> Option<&'static str> {
        (self.scalar.misfit)(self.set)
    }

    pub(crate) fn measure(&self, seed: u64, count: usize) -> Tally {
        (self.scalar.measure)(self.set, seed, count)
    }

    fn per_million(&self, wrong: u64) -> String {
        per_million(wrong, self.tally.cases)
    }
}

/// Prints a table for each scalar.
pub(crate) fn print(rows: &[Row<'_>]) {
    println!("Wrong answers per million cases: false disjoint / false overlap.");
    for table in rows.chunk_by(|a, b| a.scalar.name == b.scalar.name) {
        println!();
        print!("{:<12}{:>8}{:>9}", table[0].scalar.name, "cases", "overlap");
        for mode in Mode::ALL {
            print!("{:>19}", mode.name());
        }
        println!();
        for row in table {
            println!("{}", line(row));
        }
    }
}

fn line(row: &Row<'_>) -> String {
    let letter = char::from(b'a' + row.set as u8);
    let mut line = format!("{letter} {:<10}", row.set.name());
    if let Some(reason) = row.misfit() {
        line += &format!("{:>8}   not held: {} {reason}", "–", row.scalar.name);
        return line;
    }
    let Tally { cases, overlaps, wrong } = row.tally;
    let percent = overlaps as f64 * 100.0 / cases as f64;
    write!(line, "{:>8}{:>7.1} %", grouped(cases), percent).expect("a string takes all");
    for Wrong { false_disjoint, false_overlap } in wrong {
        let (disjoint, overlap) = (row.per_million(false_disjoint), row.per_million(false_overlap));
        write!(line, "{disjoint:>9} / {overlap:<7}").expect("a string takes all");
    }
    line.truncate(line.trim_end().len());
    line
}

/// The counts, one line for each scalar, set and mode.
pub(crate) fn csv(rows: &[Row<'_>]) -> String {
    let mut text = String::from("scalar,set,mode,cases,overlaps,false_disjoint,false_overlap\n");
    for row in rows.iter().filter(|row| row.misfit().is_none()) {
        let Tally { cases, overlaps, wrong } = row.tally;
        for (mode, Wrong { false_disjoint, false_overlap }) in Mode::ALL.into_iter().zip(wrong) {
            let (scalar, set, mode) = (&row.scalar.name, row.set.name(), mode.name());
            text += &format!(
                "{scalar},{set},{mode},{cases},{overlaps},{false_disjoint},{false_overlap}\n"
            );
        }
    }
    text
}

/// A sentence for each promise that the counts break.
pub(crate) fn broken_promises(rows: &[Row<'_>]) -> Vec<String> {
    let mut broken = Vec::new();
    for row in rows {
        for (mode, wrong) in Mode::ALL.into_iter().zip(row.tally.wrong) {
            let count = match mode {
                Mode::Exact => wrong.false_disjoint + wrong.false_overlap,
                Mode::Conservative => wrong.false_disjoint,
                Mode::Rounded | Mode::Published => 0,
            };
            if count > 0 {
                let (mode, set, name) = (mode.name(), row.set.name(), &row.scalar.name);
                broken.push(format!("{mode} mode was wrong {count} times on {set}, {name}"));
            }
        }
    }
    broken
}
