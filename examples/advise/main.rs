//! Says which number type a scene needs: which hold it, what rounding to each costs in
//! verdicts, what a query costs in each, and which is the cheapest that is good enough.
//!
//! ```text
//! cargo run --release --example advise
//! cargo run --release --example advise -- cow.obj --cell 0.01 --tolerance 0.0002 --target m0
//! cargo run --release --example advise -- --help
//! ```

mod advice;
mod costs;
mod effect;
mod kind;
#[path = "../voxelize/mesh.rs"]
mod mesh;
mod options;
mod paste;
mod prediction;
mod race;
mod report;
#[allow(dead_code, reason = "shared with the tests")]
#[path = "../../tests/support/rng.rs"]
mod rng;
mod rung;
mod scene;
#[allow(dead_code, reason = "shared with other examples")]
#[path = "../shared/mod.rs"]
mod shared;
mod survey;
mod verdict;

use std::error::Error;
use std::io::Write;
use std::path::Path;
use std::process::ExitCode;

use clap::Parser;
use costs::Costs;
use mesh::Mesh;
use options::{Options, Up};
use scene::Scene;
use survey::{Plan, Survey};

fn main() -> ExitCode {
    match run(&Options::parse()) {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("error: {error}");
            ExitCode::FAILURE
        }
    }
}

fn run(options: &Options) -> Result<(), Box<dyn Error>> {
    let tables = Path::new(env!("CARGO_MANIFEST_DIR")).join("docs");
    let costs = Costs::read(&tables, options.target)?;
    // In the coordinates of the file.
    let mesh = Mesh::load(options.mesh.as_deref(), Some(Up::Y))?;
    let scene = Scene::new(mesh.triangles, options.cell, options.tolerance)?;
    let sample = options.sample.get() as usize;
    let plan = Plan { target: options.target, sample, full: options.full, costs: &costs };
    let survey = Survey::of(&scene, &plan);
    say(&report::write(&mesh.name, options, &scene, &survey, &costs))
}

/// Prints; that nobody listens any more is no error.
fn say(text: &str) -> Result<(), Box<dyn Error>> {
    match std::io::stdout().write_all(text.as_bytes()) {
        Err(e) if e.kind() != std::io::ErrorKind::BrokenPipe => Err(e.into()),
        _ => Ok(()),
    }
}
