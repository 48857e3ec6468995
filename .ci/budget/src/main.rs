//! What programs of one query take, held against a table of what they may take.
//!
//! ```text
//! septum-budget <table.csv> <target> source|prebuilt <elf>…
//! ```
//!
//! Prints a line for each program, and fails where anything exceeds. `source` or `prebuilt`
//! says where `core` comes from.

mod firmware;
mod table;

use std::error::Error;
use std::path::Path;
use std::process::ExitCode;

use firmware::{Firmware, Kind};
use table::Budget;

fn main() -> Result<ExitCode, Box<dyn Error>> {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let [table, target, core, elves @ ..] = &arguments[..] else {
        return Err("septum-budget <table.csv> <target> source|prebuilt <elf>…".into());
    };
    let core = Core::read(core)?;
    let budgets = table::read(Path::new(table), target)?;
    let firmware = |name: &str| {
        let elf =
            elves.iter().map(Path::new).find(|elf| elf.file_stem().is_some_and(|s| s == name));
        Firmware::read(elf.ok_or(format!("no program {name}"))?)
    };

    let mut within = true;
    // If nothing is found here, the search is broken.
    let canary = firmware("canary")?;
    for kind in Kind::ALL {
        if canary.links(kind).is_empty() {
            println!("canary: links a {kind}, but it is not found");
            within = false;
        }
    }
    let empty = firmware("empty")?;
    println!(
        "{target}\n  {:<15} {:<16}{:<16}{:<16}stack nearby",
        "program", "own", "run-time", "stack"
    );
    for budget in &budgets {
        within &= holds(budget, &firmware(&budget.program)?, &empty, core);
    }
    Ok(if within { ExitCode::SUCCESS } else { ExitCode::FAILURE })
}

/// What is called for shapes so far apart, or so wide, that a word does not hold what
/// has to be computed about them.
const FAR: &str = "::in_any_words::<i64";

/// Where the language's own functions come from: soft floats, wide division, copies.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Core {
    /// Compiled with the program, for size: the table was made so.
    Source,
    /// Rustup's: compiled beforehand, for speed, with loops unrolled. On a Cortex-M0 those
    /// of one program take 2,724 bytes in place of 1,574. They say nothing of this crate.
    /// Which of them a program needs is held all the same, by what it may link.
    Prebuilt,
}

impl Core {
    fn read(word: &str) -> Result<Self, String> {
        match word {
            "source" => Ok(Self::Source),
            "prebuilt" => Ok(Self::Prebuilt),
            _ => Err(format!("core is source or prebuilt, not {word}")),
        }
    }

    /// What a budget for the crate's own bytes allows. With rustup comes any release of the
    /// compiler; they differ in what they inline and spill. A twentieth is allowed.
    fn allows(self, budget: u64) -> u64 {
        match self {
            Self::Source => budget,
            Self::Prebuilt => budget + budget / 20,
        }
    }
}

/// Prints what a program takes, and whether that is within its budget.
fn holds(budget: &Budget, firmware: &Firmware, empty: &Firmware, core: Core) -> bool {
    let mut complaints = Vec::new();
    let mut cell = |what: &str, taken: Result<u64, String>, limit: Option<u64>| {
        match (&taken, limit) {
            (Err(why), _) => complaints.push(why.clone()),
            (Ok(bytes), Some(limit)) if *bytes > limit => {
                complaints.push(format!("{what} exceeds its budget"));
            }
            (Ok(_), _) => {}
        }
        let taken = taken.map_or("?".into(), |bytes| bytes.to_string());
        let limit = limit.map_or("not held".into(), |limit| format!("of {limit}"));
        print!("{:<16}", format!("{taken} {limit}"));
    };
    print!("  {:<16}", budget.program);
    let own = firmware.own_text() - empty.own_text();
    cell("own", Ok(own), Some(core.allows(budget.own)));
    let run_time = (core == Core::Source).then_some(budget.run_time);
    cell("run-time", Ok(firmware.run_time_text()), run_time);
    cell("stack", firmware.stack(None), Some(core.allows(budget.stack)));
    if let Some(limit) = budget.stack_nearby {
        cell("stack nearby", firmware.stack(Some(FAR)), Some(core.allows(limit)));
    }
    println!();
    for kind in Kind::ALL.into_iter().filter(|kind| !budget.may_link.contains(kind)) {
        for name in firmware.links(kind) {
            complaints.push(format!("links a {kind}, {name}"));
        }
    }
    for complaint in &complaints {
        println!("    EXCEEDED: {complaint}");
    }
    complaints.is_empty()
}
