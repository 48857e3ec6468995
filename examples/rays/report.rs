//! The tables.

use std::fmt::Write;

use super::leaks::{self, LeakRow};
use super::measure::{SetRow, Tally, Wrong};
use septum_kit::jobs::{grouped, per_million};
use septum_kit::rays::Method;

/// Prints three tables for each scalar: wrong answers, leaks, and errors of t.
pub(crate) fn print(sets: &[SetRow<'_>], leaks: &[LeakRow<'_>]) {
    let by_scalar = |a: &SetRow<'_>, b: &SetRow<'_>| a.scalar.name == b.scalar.name;
    println!("Wrong answers per million cases: false miss / false hit.");
    for table in sets.chunk_by(by_scalar) {
        heading(&table[0].scalar.name, 12, &["cases", "hits"], 19);
        table.iter().for_each(|row| println!("{}", wrong_answers(row)));
    }
    println!("\nRays per million through closed meshes: not seen / seen twice at one wall.");
    for table in leaks.chunk_by(|a, b| a.scalar.name == b.scalar.name) {
        heading(&table[0].scalar.name, 21, &["rays"], 23);
        table.iter().for_each(|row| println!("{}", leaking(row)));
    }
    println!("\nLargest error of t, in units in the last place of t, where t is not zero.");
    for table in sets.chunk_by(by_scalar) {
        heading(&table[0].scalar.name, 12, &["hits"], 15);
        table.iter().for_each(|row| println!("{}", errors(row)));
    }
}

fn heading(name: &str, width: usize, columns: &[&str], method_width: usize) {
    print!("\n{name:<width$}");
    columns.iter().for_each(|column| print!("{column:>9}"));
    Method::ALL.iter().for_each(|method| print!("{:>method_width$}", method.name()));
    println!();
}

fn misfit(name: &str, reason: &str) -> String {
    format!("{:>9}   not held: {name} {reason}", "–")
}

fn wrong_answers(row: &SetRow<'_>) -> String {
    let mut line = format!("{:<12}", row.set.name());
    if let Some(reason) = row.misfit() {
        return line + &misfit(&row.scalar.name, reason);
    }
    let Tally { cases, hits, wrong } = row.tally;
    let percent = hits as f64 * 100.0 / cases as f64;
    write!(line, "{:>9}{percent:>7.1} %", grouped(cases)).expect("a string takes all");
    for Wrong { false_miss, false_hit, .. } in wrong {
        pair(&mut line, false_miss, false_hit, cases, 7);
    }
    line.trim_end().into()
}

fn leaking(row: &LeakRow<'_>) -> String {
    let mut line = format!("{:<11}{:<10}", row.scene.name(), row.aim.name());
    if let Some(reason) = row.misfit() {
        return line + &misfit(&row.scalar.name, reason);
    }
    let leaks::Tally { rays, leaks, doubles } = row.tally;
    write!(line, "{:>9}", grouped(rays)).expect("a string takes all");
    for (leaks, doubles) in leaks.into_iter().zip(doubles) {
        pair(&mut line, leaks, doubles, rays, 9);
    }
    line.trim_end().into()
}

/// Two rates, each with so many columns.
fn pair(line: &mut String, a: u64, b: u64, cases: u64, places: usize) {
    let (a, b) = (per_million(a, cases), per_million(b, cases));
    write!(line, "  {a:>places$} / {b:<places$}").expect("a string takes all");
}

fn errors(row: &SetRow<'_>) -> String {
    let mut line = format!("{:<12}", row.set.name());
    if let Some(reason) = row.misfit() {
        return line + &misfit(&row.scalar.name, reason);
    }
    write!(line, "{:>9}", grouped(row.tally.hits)).expect("a string takes all");
    for Wrong { worst_t, .. } in row.tally.wrong {
        let worst = if worst_t < 1e4 { format!("{worst_t:.2}") } else { format!("{worst_t:.1e}") };
        write!(line, "{worst:>15}").expect("a string takes all");
    }
    line
}

/// The counts, one line for each scalar, set or target, and method.
pub(crate) fn csv(sets: &[SetRow<'_>], leaks: &[LeakRow<'_>]) -> String {
    let mut text = String::from(
        "scalar,set,method,cases,hits,false_miss,false_hit,worst_t_ulp,leaks,doubles\n",
    );
    for row in sets.iter().filter(|row| row.misfit().is_none()) {
        let Tally { cases, hits, wrong } = row.tally;
        for (method, wrong) in Method::ALL.into_iter().zip(wrong) {
            let Wrong { false_miss, false_hit, worst_t } = wrong;
            let (scalar, set, method) = (&row.scalar.name, row.set.name(), method.name());
            text += &format!(
                "{scalar},{set},{method},{cases},{hits},{false_miss},{false_hit},{worst_t},,\n"
            );
        }
    }
    for row in leaks.iter().filter(|row| row.misfit().is_none()) {
        let leaks::Tally { rays, leaks, doubles } = row.tally;
        for (k, method) in Method::ALL.into_iter().enumerate() {
            let (scalar, method) = (&row.scalar.name, method.name());
            let (scene, aim, leaks, doubles) =
                (row.scene.name(), row.aim.name(), leaks[k], doubles[k]);
            text += &format!("{scalar},{scene} {aim},{method},{rays},,,,,{leaks},{doubles}\n");
        }
    }
    text
}

/// A sentence for each promise that the counts break.
pub(crate) fn broken_promises(sets: &[SetRow<'_>], leaks: &[LeakRow<'_>]) -> Vec<String> {
    let is_exact = |method: &Method| matches!(method, Method::Exact | Method::Once);
    let mut broken = Vec::new();
    for row in sets {
        let (set, name) = (row.set.name(), &row.scalar.name);
        let pairs = Method::ALL.into_iter().zip(row.tally.wrong);
        for (method, wrong) in pairs.filter(|(method, _)| is_exact(method)) {
            let (method, count) = (method.name(), wrong.false_miss + wrong.false_hit);
            if count > 0 {
                broken.push(format!("{method} was wrong {count} times on {set}, {name}"));
            }
            // The measured error is itself a rounded quotient.
            if wrong.worst_t > row.scalar.bound * (1.0 + 1e-12) {
                let worst = wrong.worst_t;
                broken.push(format!("{method}: t was {worst} ulp off on {set}, {name}"));
            }
        }
    }
    for row in leaks {
        let (scene, aim, name) = (row.scene.name(), row.aim.name(), &row.scalar.name);
        for (k, method) in Method::ALL.into_iter().enumerate() {
            let doubles = if method == Method::Once { row.tally.doubles[k] } else { 0 };
            let is_float = name.starts_with('f');
            let is_watertight = is_exact(&method) || method == Method::Watertight && is_float;
            let leaks = row.tally.leaks[k];
            if is_watertight && leaks + doubles > 0 {
                let method = method.name();
                broken.push(format!(
                    "{method}: {leaks} leaks and {doubles} double hits, {scene}, {aim}, {name}"
                ));
            }
        }
    }
    broken
}
