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
    println!("{target}\n  {:<14} {:>6} of {:>6} {:>6} of {:>5}", "", ".text", "", "stack", "");
    for budget in &budgets {
        within &= holds(budget, &firmware(&budget.program)?, empty.text);
    }
    Ok(if within { ExitCode::SUCCESS } else { ExitCode::FAILURE })
}

/// Prints what a program takes, and whether that is within its budget.
fn holds(budget: &Budget, firmware: &Firmware, empty: u64) -> bool {
    let text = firmware.text - empty;
    let stack = firmware.stack();
    let mut complaints = Vec::new();
    if text > budget.text {
        complaints.push(".text exceeds its budget".to_string());
    }
    match &stack {
        Ok(bytes) if *bytes > budget.stack => complaints.push("stack exceeds its budget".into()),
        Ok(_) => {}
        Err(why) => complaints.push(why.clone()),
    }
    for kind in Kind::ALL.into_iter().filter(|kind| !budget.may_link.contains(kind)) {
        for name in firmware.links(kind) {
            complaints.push(format!("links a {kind}, {name}"));
        }
    }
    let stack = stack.map_or("?".into(), |bytes| bytes.to_string());
    println!(
        "  {:<14} {text:>6} of {:>6} {stack:>6} of {:>5}",
        budget.program, budget.text, budget.stack
    );
    for complaint in &complaints {
        println!("  {:<14} EXCEEDS: {complaint}", "");
    }
    complaints.is_empty()
}
