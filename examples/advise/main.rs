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
mod columns;
mod costs;
mod effect;
mod kind;
mod options;
mod paste;
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
use std::path::Path;
use std::process::ExitCode;

use costs::Costs;
use options::Options;
use question::Question;
use scene::Scene;
use septum_tools::cli;
use septum_tools::mesh::{Mesh, Up};
use survey::{Plan, Survey};

fn main() -> ExitCode {
    cli::run(run)
}

fn run(options: &Options) -> Result<(), Box<dyn Error>> {
    cli::say(&consult(options)?)
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
