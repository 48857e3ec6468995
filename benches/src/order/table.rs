//! The tables, in Markdown.

use std::fmt::Write;

use super::nine::{self, Counts};
use super::small_cores::Row;
use super::{ORDERS, Race};

/// The tables, and the conclusions from them.
pub(super) fn text(
    groups: &[Race],
    nine: &[Race],
    counts: &[(&str, Counts)],
    small_cores: &[Row],
) -> String {
    let mut text = String::from(INTRODUCTION);
    races(&mut text, groups, &ORDERS.map(|(name, _)| name));
    text += BEST;
    for race in groups {
        let (name, time) = best(race, &ORDERS.map(|(name, _)| name));
        writeln!(text, "* {}, {}: {name}, {time:.2}", race.workload, race.scalar).expect(FITS);
    }
    text += WHY;
    text += "| workload | pairs | apart | by a face | by the normal | by a cross product |\n";
    text += "| --- | --- | --- | --- | --- | --- |\n";
    for (workload, c) in counts {
        let share = |n: usize| format!("{:.1} %", n as f64 * 100.0 / c.apart.max(1) as f64);
        let [faces, normal, edges] = c.groups.map(share);
        let apart = c.apart as f64 * 100.0 / c.pairs as f64;
        writeln!(
            text,
            "| {workload} | {} | {apart:.1} % | {faces} | {normal} | {edges} |",
            c.pairs
        )
        .expect(FITS);
    }
    text += NINE;
    races(&mut text, nine, &nine::ORDERS.map(|(name, _)| name));
    text += LOOKED_AT;
    header(&mut text, &["workload"], &nine::ORDERS.map(|(name, _)| name));
    for (workload, c) in counts {
        write!(text, "| {workload} |").expect(FITS);
        for sum in c.looked_at {
            write!(text, " {:.2} |", sum as f64 / c.by_edges.max(1) as f64).expect(FITS);
        }
        text += "\n";
    }
    text += SMALL_CORES;
    header(&mut text, &["core", "scalar", "workload"], &ORDERS.map(|(name, _)| name));
    for Row { core, scalar, workload, instructions } in small_cores {
        write!(text, "| {core} | {scalar} | {workload} |").expect(FITS);
        let best = instructions.iter().copied().fold(f64::INFINITY, f64::min);
        for &each in instructions {
            let strong = if each == best { "**" } else { "" };
            write!(text, " {strong}{:.2}{strong} |", each / instructions[0]).expect(FITS);
        }
        text += "\n";
    }
    text += CONCLUSION;
    text
}

const FITS: &str = "a string takes all";

const INTRODUCTION: &str = "\
# The order of the tests

Written by `cargo order`: the test as published in 2001 with its axes in every order. Time
relative to the paper's order, medians of rounds in one process, in turns; in brackets the
middle half of the rounds. Below 1 is faster. The paper's numbers: 1, the three faces of the
box; 2, the normal of the triangle; 3, the nine cross products.

## The three groups

";

const BEST: &str = "\nThe best, and its time:\n\n";

const WHY: &str = "
Which of the groups could have told, of the pairs that are apart:

";

const NINE: &str = "
## The nine cross products

In `f32`, tried after the faces and before the normal. *Edge by edge*: the three axes of the
box with one edge, then with the next, as in the paper's code. *Axis by axis*: the three edges
with one axis of the box. *Diagonals*: no two neighbours share an edge or an axis of the box.

";

const LOOKED_AT: &str = "
How many of the nine are looked at until one tells, on average over the pairs that no face
separates and a cross product does; the same on every machine:

";

const SMALL_CORES: &str = "
## On small cores

The three groups again: instructions relative to the paper's order, from
[target.csv](../target.csv). Pairs of the example `measure`: random triangles, of which half meet the
box, and vertices on a grid of integers.

";

const CONCLUSION: &str = include_str!("conclusion.md");

fn races(text: &mut String, races: &[Race], names: &[&str]) {
    header(text, &["workload", "scalar", "meet"], names);
    for race in races {
        let hits = race.hits * 100.0;
        write!(text, "| {} | {} | {hits:.0} % |", race.workload, race.scalar).expect(FITS);
        let (best, _) = best(race, names);
        for ([slow, median, fast], name) in race.times.iter().zip(names) {
            let [low, high] = [slow.min(*fast), slow.max(*fast)];
            let strong = if *name == best { "**" } else { "" };
            write!(text, " {strong}{median:.2}{strong} ({low:.2}–{high:.2}) |").expect(FITS);
        }
        *text += "\n";
    }
    for scalar in ["f32", "f64", "I16F16"] {
        let same: Vec<&Race> = races.iter().filter(|race| race.scalar == scalar).collect();
        if same.is_empty() {
            continue;
        }
        write!(text, "| all, geometric mean | {scalar} | |").expect(FITS);
        for k in 0..names.len() {
            let sum: f64 = same.iter().map(|race| race.times[k][1].ln()).sum();
            write!(text, " {:.2} |", (sum / same.len() as f64).exp()).expect(FITS);
        }
        *text += "\n";
    }
}

fn header(text: &mut String, first: &[&str], names: &[&str]) {
    let cells: Vec<&str> = first.iter().chain(names).copied().collect();
    writeln!(text, "| {} |", cells.join(" | ")).expect(FITS);
    writeln!(text, "|{}", " --- |".repeat(cells.len())).expect(FITS);
}

/// The fastest order, and its median time.
fn best<'a>(race: &Race, names: &[&'a str]) -> (&'a str, f64) {
    let times = race.times.iter().map(|t| t[1]);
    let named = names.iter().copied().zip(times);
    named.min_by(|a, b| a.1.total_cmp(&b.1)).expect("there are orders")
}
