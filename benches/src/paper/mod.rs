//! The experiment of the paper's section 3: 100,000 random triangles in a cube of side 4 against
//! the unit cube in its middle, a hundred times over. The table shows the speed of each test
//! relative to the polygon/cube test of Green and Hatch, and compares that test with the exact one
//! for polygons of more vertices.

use std::error::Error;
use std::fmt::Write;
use std::path::PathBuf;

use clap::Args;
use indicatif::{ProgressBar, ProgressStyle};

use septum::Scalar;

use crate::candidate::Candidate;
use crate::polygon_aabb as polygons;
use crate::race::{Timing, race};
use crate::triangle_aabb::scenes::voorhies;
use crate::triangle_aabb::{course, ours, peers};
use crate::unit::{F32, F64, Form, I16F16_18, Unit};

/// Repeats the experiment of the paper of 2001.
#[derive(Args)]
pub struct Options {
    /// How many times over
    #[arg(long, default_value_t = 100, value_parser = clap::value_parser!(u32).range(4..))]
    rounds: u32,
    /// Where the table goes
    #[arg(long, value_name = "FILE", default_value = "docs/experiments/paper.md")]
    out: PathBuf,
}

/// Times, prints and writes the table.
pub fn run(options: &Options) -> Result<(), Box<dyn Error>> {
    let rounds = options.rounds as usize;
    let scene = voorhies();
    let as_polygons = scene.map(|t| t.to_vec(), |cell| *cell);
    let [exact, published] = polygon_tests(&as_polygons, &F32);
    let mut candidates = vec![
        published.named("polygon/cube as published (Green, Hatch)"),
        exact.named("polygon/box, exact"),
    ];
    candidates.extend(ours(&course(&scene, &F32, Form::Center)));
    candidates.extend(ours(&course(&scene, &F64, Form::Center)));
    candidates.extend(ours(&course(&scene, &I16F16_18, Form::Center)));
    // The paper compares tests that decide, as they are and as published.
    candidates.retain(|c| !["conservative", "rounded"].contains(&&*c.who));
    candidates.extend(peers(&scene));

    // There are half as many polygons.
    let few = rounds / 2;
    let by_count = polygons::VERTICES.count();
    let bar = ProgressBar::new((rounds + 3 * few * by_count) as u64);
    let style = ProgressStyle::with_template("{wide_bar} {pos} of {len} rounds, {eta}");
    bar.set_style(style.expect("the template is valid"));
    let timings = race(&candidates, rounds, &bar);
    let rows: String = polygons::VERTICES.map(|n| polygon_row(n, few, &bar)).collect();
    bar.finish_and_clear();
    let text = table(&candidates, &timings) + POLYGONS + &rows;
    print!("{text}");
    if let Some(folder) = options.out.parent() {
        std::fs::create_dir_all(folder)?;
    }
    std::fs::write(&options.out, text).map_err(|e| format!("{}: {e}", options.out.display()))?;
    Ok(())
}

const POLYGONS: &str = "
## Polygons

Convex polygons inscribed in random ellipses against the unit cube. *Speed* of the exact test is \
relative to the test of Green and Hatch in the same scalar; *wrong* counts the errors of that test.

| vertices | meet | speed, f32 | f64 | I16F16, 18 bits | wrong, f32 | I16F16 |
| --- | --- | --- | --- | --- | --- | --- |
";

/// Our test and the published one.
fn polygon_tests<S: Scalar>(scene: &polygons::Scene, unit: &Unit<S>) -> [Candidate; 2] {
    let course = polygons::course(scene, unit, Form::Center);
    [polygons::exact_on(&course), polygons::as_published_on(&course)]
}

/// A line of the table of polygons.
fn polygon_row(vertices: usize, rounds: usize, bar: &ProgressBar) -> String {
    let scene = polygons::of_vertices(vertices);
    let all = [
        polygon_tests(&scene, &F32),
        polygon_tests(&scene, &F64),
        polygon_tests(&scene, &I16F16_18),
    ];
    let [single, double, fixed] = &all;
    let ratio = |[exact, published]: &[Candidate; 2]| {
        race(&[published, exact], rounds, bar)[1].quartiles[1]
    };
    let wrong = |[_, published]: &[Candidate; 2]| {
        format!("{} / {}", published.false_disjoint, published.false_overlap)
    };
    format!(
        "| {vertices} | {:.0} % | {:.2} | {:.2} | {:.2} | {} | {} |\n",
        single[0].overlaps as f64 * 100.0 / single[0].pairs as f64,
        ratio(single),
        ratio(double),
        ratio(fixed),
        wrong(single),
        wrong(fixed),
    )
}

/// The processor's name, if the system reports it.
fn machine() -> String {
    let text = std::fs::read_to_string("/proc/cpuinfo").unwrap_or_default();
    let name = text.lines().find_map(|line| line.strip_prefix("model name")?.split_once(": "));
    name.map_or("a machine without a name".into(), |(_, name)| name.replace("(R)", ""))
}

fn table(candidates: &[Candidate], timings: &[Timing]) -> String {
    let share = candidates[0].overlaps as f64 * 100.0 / candidates[0].pairs as f64;
    let mut text = format!(
        "# The paper's experiment\n\nWritten by `cargo paper`: section 3 of the paper of 2001, with {} \
         random triangles in a cube of side 4 against the unit cube in its middle; {share:.0} % meet it. \
         *Speed* is relative to the polygon/cube test of Green and Hatch (*Graphics Gems V*, 1995), \
         `septum::published::green_hatch`: medians of rounds in one process, in turns. The machine: {}.\n\n\
         | test | scalar | speed | wrong: disjoint / overlap |\n| --- | --- | --- | --- |\n\
         | the paper, on a Sun | `f32` | 2.3 | |\n| the paper, on a PC | `f32` | 3.8 | |\n",
        crate::drawing::grouped(candidates[0].pairs as f64),
        machine(),
    );
    for (c, timing) in candidates.iter().zip(timings) {
        let [_, median, _] = timing.quartiles;
        writeln!(
            text,
            "| {} | {} | {median:.2} | {} / {} |",
            c.who, c.scalar, c.false_disjoint, c.false_overlap
        )
        .expect("a string takes all");
    }
    text
}
