//! Stability: how often each method is wrong as a scene slides into the regime where it
//! fails, and how long it takes where axes are parallel but for a tilt.

mod boxes;
mod contacts;
mod distances;
mod lines;
mod picture;
mod rays;
mod regimes;
mod sweeps;
mod times;

use std::error::Error;
use std::path::PathBuf;

use clap::Args;

use crate::accuracy::{Exam, Tally, examine};

use regimes::Regime;

/// Draws how often each method is wrong as a scene slides into the regime where it fails: slivers,
/// small triangles, great distances and scales, small angles, contact, grazing motions, and slight
/// overlaps.
#[derive(Args)]
pub struct Options {
    /// Cases at each step
    #[arg(long, default_value_t = 20_000, value_parser = clap::value_parser!(u32).range(1..))]
    cases: u32,
    /// Where the pictures go, and stability.csv
    #[arg(long, value_name = "FOLDER", default_value = "docs/experiments/stability")]
    out: PathBuf,
    /// Only the picture of this name
    #[arg(long, value_name = "NAME")]
    only: Option<String>,
}

/// The position of an exam: a panel of a picture, and a step on its horizontal axis.
#[derive(Clone, Copy)]
struct Step {
    picture: &'static str,
    panel: &'static str,
    at: f64,
}

/// Counts on all cores, writes the table, and draws.
pub fn run(options: &Options) -> Result<(), Box<dyn Error>> {
    let wanted = |r: &Regime| options.only.as_ref().is_none_or(|name| r.stem == name);
    let all = regimes::all().into_iter().chain(distances::all());
    let mut regimes: Vec<Regime> = all.filter(wanted).collect();
    let exams: Vec<Exam<Step>> = regimes.iter_mut().flat_map(|r| r.exams.split_off(0)).collect();
    let tallies = examine(&exams, options.cases as usize);
    let steps: Vec<Step> = exams.iter().map(|exam| exam.label).collect();
    std::fs::create_dir_all(&options.out)?;
    if options.only.is_none() {
        write(options, &steps, &tallies)?;
    }
    let mut wrong = Vec::new();
    for regime in &regimes {
        picture::draw(regime, &steps, &tallies, options)?;
    }
    for (step, tally) in steps.iter().zip(&tallies) {
        for t in tally.iter().filter(|t| is_exact(t) && t.per_million() > 0.0) {
            wrong.push(format!("{}, {} at {}, {}", t.who, t.scalar, step.at, step.picture));
        }
    }
    if options.only.as_ref().is_none_or(|name| name == "tilt") {
        times::draw(options)?;
    }
    if wrong.is_empty() { Ok(()) } else { Err(format!("not exact: {}", wrong.join("; ")).into()) }
}

fn is_exact(tally: &Tally) -> bool {
    tally.who.starts_with("exact")
}

fn write(options: &Options, steps: &[Step], tallies: &[Vec<Tally>]) -> Result<(), Box<dyn Error>> {
    let path = options.out.join("stability.csv");
    let mut writer =
        csv::Writer::from_path(&path).map_err(|e| format!("{}: {e}", path.display()))?;
    writer.write_record([
        "picture",
        "panel",
        "at",
        "test",
        "scalar",
        "form",
        "cases",
        "false_disjoint",
        "false_overlap",
    ])?;
    for (step, tallies) in steps.iter().zip(tallies) {
        for t in tallies {
            writer.write_record([
                step.picture,
                step.panel,
                &step.at.to_string(),
                &t.who,
                t.scalar,
                t.form,
                &t.cases.to_string(),
                &t.false_disjoint.to_string(),
                &t.false_overlap.to_string(),
            ])?;
        }
    }
    Ok(writer.flush()?)
}
