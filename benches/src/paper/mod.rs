//! The experiment of the paper's section 3: 100,000 random triangles in a cube of side 4
//! against the unit cube in its middle, a hundred times over, and how many times as fast
//! each test is as the polygon/cube test of Green and Hatch.

mod green_hatch;

use std::error::Error;
use std::fmt::Write;
use std::path::PathBuf;

use clap::Args;
use indicatif::{ProgressBar, ProgressStyle};

use crate::candidate::{Candidate, Promise};
use crate::race::{Timing, race};
use crate::triangle_aabb::scenes::voorhies;
use crate::triangle_aabb::{course, ours, peers};
use crate::unit::{F32, F64, Form, I16F16_18};

/// Repeats the experiment of the paper of 2001.
#[derive(Args)]
pub struct Options {
    /// How many times over
    #[arg(long, default_value_t = 100, value_parser = clap::value_parser!(u32).range(4..))]
    rounds: u32,
    /// Where the table goes
    #[arg(long, value_name = "FILE", default_value = "docs/paper.md")]
    out: PathBuf,
}

/// Times, prints and writes the table.
pub fn run(options: &Options) -> Result<(), Box<dyn Error>> {
    let rounds = options.rounds as usize;
    let scene = voorhies();
    let plain = course(&scene, &F32, Form::Center);
    let triangles = plain.prepared("", |p| p.map(|t| t.vertices().map(|v| v.to_array()), |_| ()));
    let mut candidates =
        vec![triangles.candidate("polygon/cube (Green, Hatch)", Promise::Nothing, polygon)];
    candidates.extend(ours(&plain));
    candidates.extend(ours(&course(&scene, &F64, Form::Center)));
    candidates.extend(ours(&course(&scene, &I16F16_18, Form::Center)));
    candidates.extend(peers(&scene));

    let bar = ProgressBar::new(rounds as u64);
    let style = ProgressStyle::with_template("{wide_bar} {pos} of {len} rounds, {eta}");
    bar.set_style(style.expect("the template is valid"));
    let timings = race(&candidates, rounds, &bar);
    bar.finish_and_clear();
    let text = table(&candidates, &timings);
    print!("{text}");
    if let Some(folder) = options.out.parent() {
        std::fs::create_dir_all(folder)?;
    }
    std::fs::write(&options.out, text).map_err(|e| format!("{}: {e}", options.out.display()))?;
    Ok(())
}

#[inline(never)]
fn polygon(t: &[[f32; 3]; 3], (): &()) -> bool {
    green_hatch::meets_unit_cube(t)
}

fn table(candidates: &[Candidate], timings: &[Timing]) -> String {
    let share = candidates[0].overlaps as f64 * 100.0 / candidates[0].pairs as f64;
    let mut text = format!(
        "# The paper's experiment\n\nWritten by `cargo paper`: {} random triangles in a cube of \
         side 4 against the unit cube in its middle, {share:.0} % of which meet it, as in section 3 \
         of the paper of 2001. How many times as fast each test is as the polygon/cube test of \
         Green and Hatch (*Graphics Gems V*, 1995), in our own code: medians of rounds in one \
         process, in turns; in brackets the middle half of the rounds. The paper had 2.3 on a Sun \
         and 3.8 on a PC, with compilers and processors of its day.\n\n\
         | test | scalar | speed | wrong: disjoint / overlap |\n| --- | --- | --- | --- |\n\
         | the paper, on a Sun | `f32` | 2.3 | |\n| the paper, on a PC | `f32` | 3.8 | |\n",
        crate::drawing::grouped(candidates[0].pairs as f64)
    );
    for (c, timing) in candidates.iter().zip(timings) {
        let [low, median, high] = timing.quartiles;
        writeln!(
            text,
            "| {} | {} | {median:.2} ({low:.2}–{high:.2}) | {} / {} |",
            c.who, c.scalar, c.false_disjoint, c.false_overlap
        )
        .expect("a string takes all");
    }
    text
}
