//! How fast the triangle/box test is, in every mode and scalar, beside its
//! peers: ratios to the test as published in 2001, in `f32`. Higher is faster.

mod candidate;
mod data;
mod peers;
mod race;
mod report;
mod scene;

use std::error::Error;
use std::path::PathBuf;
use std::process::ExitCode;

use clap::Parser;
use fixed::types::{I8F8, I16F16, I32F32};
use indicatif::{ProgressBar, ProgressStyle};
use septum::Scalar;

use crate::candidate::{Candidate, F32, ours, yardstick};
use crate::data::{Form, Unit};
use crate::report::Report;
use crate::scene::Scene;

/// Times septum's triangle/box test beside its peers.
///
/// Candidates take turns in one process. A ratio says how many times as fast as
/// the as-published test in f32 one is: by the best times of all rounds, and as
/// the median, least and greatest of the rounds. Before the clock starts, every
/// answer is compared with the exact one.
#[derive(Parser)]
#[command(version)]
struct Options {
    /// Rounds per group of candidates
    #[arg(long, default_value_t = 100, value_parser = clap::value_parser!(u32).range(1..))]
    rounds: u32,
    /// A tenth of the rounds
    #[arg(long)]
    quick: bool,
    /// Only scalars and peers whose name contains this, as f32, I16F16 or parry3d
    #[arg(long, value_name = "NAME")]
    only: Option<String>,
    /// Write all figures to this file too
    #[arg(long, value_name = "FILE")]
    csv: Option<PathBuf>,
}

const F64: Unit<f64> = Unit { name: "f64", scale: 1.0, near: |x| x, value: |x| x };
const I8F8_15: Unit<I8F8> =
    Unit { name: "I8F8, 15 bits", scale: 32.0, near: I8F8::strict_from_num, value: I8F8::to_num };
const I16F16_18: Unit<I16F16> = Unit {
    name: "I16F16, 18 bits",
    scale: 1.0,
    near: I16F16::strict_from_num,
    value: I16F16::to_num,
};
/// The scenes of contact reach to 16 rather than to 2.
const I16F16_22: Unit<I16F16> = Unit { name: "I16F16, 22 bits", ..I16F16_18 };
const I16F16_26: Unit<I16F16> = Unit { name: "I16F16, 26 bits", scale: 256.0, ..I16F16_18 };
const I32F32_34: Unit<I32F32> = Unit {
    name: "I32F32, 34 bits",
    scale: 1.0,
    near: I32F32::strict_from_num,
    value: I32F32::to_num,
};

/// Beyond the range of the first stage.
const I16F16_FULL: Unit<I16F16> = Unit { name: "I16F16, 32 bits", scale: 1024.0, ..I16F16_18 };

/// Makes a group of candidates for a scene.
type Group = (&'static str, Box<dyn Fn(&Scene) -> Vec<Candidate>>);

fn group<S: Scalar>(unit: Unit<S>, form: Form) -> Group {
    (unit.name, Box::new(move |scene| ours(scene, &unit, form)))
}

fn main() -> Result<ExitCode, Box<dyn Error>> {
    let options = Options::parse();
    let mut report = Report::default();
    let mut honest = true;

    println!("Ratio to the as-published test in f32: higher is faster.");
    println!("wrong −/+: overlaps missed / overlaps that are none.\n");
    let by_form = |form| {
        [
            group(F32, form),
            group(F64, form),
            group(I8F8_15, form),
            group(I16F16_18, form),
            group(I16F16_26, form),
            group(I32F32_34, form),
        ]
    };
    let mut all: Vec<Group> = Form::ALL.into_iter().flat_map(by_form).collect();
    all.push(("f32 parry3d box3d-rust", Box::new(peers::peers)));
    honest &= options.measure("Voorhies", scene::voorhies(), &all, &mut report);
    honest &= options.measure("Voxel", scene::voxel(), &all, &mut report);

    println!("The worst case, contact: shapes that touch, where rounding must be outdone.\n");
    let floats = |form| [group(F32, form), group(F64, form)];
    let fixed = |form| [group(I16F16_22, form), group(I16F16_FULL, form)];
    let floats: Vec<Group> = Form::ALL.into_iter().flat_map(floats).collect();
    honest &= options.measure("Spread", scene::spread(), &floats, &mut report);
    let mut contact = floats;
    contact.extend(Form::ALL.into_iter().flat_map(fixed));
    honest &= options.measure("Grid", scene::grid(), &contact, &mut report);
    honest &= options.measure("Walls", scene::walls(), &contact, &mut report);

    if let Some(path) = &options.csv {
        report.write_csv(path).map_err(|e| format!("{}: {e}", path.display()))?;
    }
    if !honest {
        eprintln!("A test broke its promise: see the last column.");
        return Ok(ExitCode::FAILURE);
    }
    Ok(ExitCode::SUCCESS)
}

impl Options {
    /// Times the groups on one scene and prints their table. `false` if a test
    /// gave an answer that it promises not to give.
    fn measure(&self, name: &str, scene: Scene, groups: &[Group], report: &mut Report) -> bool {
        let wanted = |(group, _): &&Group| self.only.as_ref().is_none_or(|o| group.contains(o));
        let groups: Vec<_> = groups.iter().filter(wanted).collect();
        let rounds = if self.quick { self.rounds.div_ceil(10) } else { self.rounds } as usize;
        let bar = ProgressBar::new((rounds * groups.len()) as u64);
        let style = ProgressStyle::with_template("{prefix:9} {wide_bar} {msg} {eta}");
        bar.set_style(style.expect("the template is valid"));
        bar.set_prefix(name.to_owned());

        let mut honest = true;
        let mut first = true;
        for (group, make) in groups {
            bar.set_message(*group);
            // Each group brings its own data and drops it before the next.
            let mut candidates = vec![yardstick(&scene)];
            candidates.extend(make(&scene));
            let timings = race::race(&candidates, rounds, &bar);
            for (candidate, timing) in candidates.iter().zip(&timings).skip(usize::from(!first)) {
                honest &= candidate.kept_its_word();
                report.add(name, scene.pairs(), candidate, timing);
            }
            first = false;
        }
        bar.finish_and_clear();
        println!("{name}, {} pairs\n{}\n", scene.pairs(), report.table(name));
        honest
    }
}
