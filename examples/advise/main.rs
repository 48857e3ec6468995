//! Recommends a number type for a scene. It lists the types that hold the scene, the number of
//! verdicts that rounding to each changes, and the cost of a query in each, and recommends the
//! cheapest type that is good enough. Queries are overlaps, sweeps or contacts.
//!
//! ```text
//! cargo advise
//! cargo advise cow.obj --cell 0.01 --tolerance 0.0002 --target m0
//! cargo advise --ask sweep --way 0,-2,0
//! cargo advise --ask contact --target m0
//! cargo advise --help
//! ```

mod advice;
#[allow(dead_code, reason = "shared with other examples")]
#[path = "../shared/cli.rs"]
mod cli;
mod columns;
mod costs;
mod effect;
#[path = "../tools/voxelize/gltf.rs"]
mod gltf;
mod kind;
#[path = "../tools/voxelize/mesh.rs"]
mod mesh;
mod options;
mod paste;
#[path = "../tools/voxelize/ply.rs"]
mod ply;
mod prediction;
mod question;
mod race;
mod report;
mod scene;
mod stage;
mod survey;
#[cfg(test)]
mod tests;
mod verdict;

use std::error::Error;
use std::io::Write;
use std::path::Path;
use std::process::ExitCode;

use costs::Costs;
use mesh::Mesh;
use options::{Options, Up};
use question::Question;
use scene::Scene;
use survey::{Plan, Survey};

fn main() -> ExitCode {
    match run(&cli::read()) {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("error: {error}");
            ExitCode::FAILURE
        }
    }
}

fn run(options: &Options) -> Result<(), Box<dyn Error>> {
    say(&consult(options)?)
}

fn consult(options: &Options) -> Result<String, Box<dyn Error>> {
    let tables = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../docs");
    let question = Question::new(options.ask, options.way)?;
    let costs = Costs::read(&tables, options.target, question)?;
    // In the coordinates of the file.
    let mesh = Mesh::load(options.mesh.as_slice(), Some(Up::Y))?;
    let scene = Scene::new(question, mesh.triangles, options.cell, options.tolerance)?;
    let sample = options.sample.get() as usize;
    let plan = Plan { target: options.target, sample, full: options.full, costs: &costs };
    let survey = Survey::of(&scene, &plan);
    Ok(report::write(&mesh.name, options, &scene, &survey, &costs))
}

/// Prints. A closed pipe is no error.
fn say(text: &str) -> Result<(), Box<dyn Error>> {
    match std::io::stdout().write_all(text.as_bytes()) {
        Err(e) if e.kind() != std::io::ErrorKind::BrokenPipe => Err(e.into()),
        _ => Ok(()),
    }
}
