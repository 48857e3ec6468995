//! What programs of one query take, held against a table of what they may take.
//!
//! ```text
//! septum-budget <table.csv> <target> <elf>…
//! ```
//!
//! Prints a line for each program, and fails where anything exceeds.

mod firmware;
mod table;

use std::error::Error;
use std::path::Path;
use std::process::ExitCode;

use firmware::{Firmware, Kind};
use table::Budget;

fn main() -> Result<ExitCode, Box<dyn Error>> {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let [table, target, elves @ ..] = &arguments[..] else {
        return Err("septum-budget <table.csv> <target> <elf>…".into());
    };
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
    println!("{target}\n  {:<12} {:<16}{:<16}stack nearby", "program", ".text", "stack");
    for budget in &budgets {
        within &= holds(budget, &firmware(&budget.program)?, &empty);
    }
    Ok(if within { ExitCode::SUCCESS } else { ExitCode::FAILURE })
}

/// What is called for shapes so far apart, or so wide, that a word does not hold what
/// has to be computed about them.
const FAR: &str = "::in_any_words::<i64>";

/// Prints what a program takes, and whether that is within its budget.
fn holds(budget: &Budget, firmware: &Firmware, empty: &Firmware) -> bool {
    let mut complaints = Vec::new();
    let mut cell = |what: &str, taken: Result<u64, String>, limit: u64| {
        match &taken {
            Ok(bytes) if *bytes > limit => complaints.push(format!("{what} exceeds its budget")),
            Ok(_) => {}
            Err(why) => complaints.push(why.clone()),
        }
        let taken = taken.map_or("?".into(), |bytes| bytes.to_string());
        print!("{:<16}", format!("{taken} of {limit}"));
    };
    print!("  {:<13}", budget.program);
    cell(".text", Ok(firmware.text - empty.text), budget.text);
    cell("stack", firmware.stack(None), budget.stack);
    if let Some(limit) = budget.stack_nearby {
        cell("stack nearby", firmware.stack(Some(FAR)), limit);
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
