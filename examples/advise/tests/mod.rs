//! The example's predictions are right, refused types fail, and recommended types succeed.

mod command;
mod predictions;
mod printing;
mod questions;
mod refusals;
mod tables;
mod types;

use std::fs;
use std::path::{Path, PathBuf};

use clap::Parser;
use septum_tools::mesh::{Mesh, Triangles, Up};

use crate::advice::{Row, recommend};
use crate::costs::Costs;
use crate::options::Options;
use crate::question::Question;
use crate::scene::Scene;
use crate::survey::{Plan, Survey};

/// A folder for one test, empty at its start.
fn folder(test: &str) -> PathBuf {
    let path = std::env::temp_dir().join("septum-advise").join(test);
    let _ = fs::remove_dir_all(&path);
    fs::create_dir_all(&path).unwrap();
    path
}

fn teapot() -> Triangles {
    let mesh = Mesh::load(&[], Some(Up::Y)).unwrap();
    assert_eq!(mesh.name, "teapot");
    mesh.triangles
}

fn scaled(by: f64) -> Triangles {
    teapot().into_iter().map(|t| t.map(|p| p.map(|x| x * by))).collect()
}

/// A run of the advisor, with its input and its text.
struct Advice {
    options: Options,
    scene: Scene,
    survey: Survey,
    text: String,
}

impl Advice {
    /// On these triangles, with tables of costs from a folder.
    fn with_tables(triangles: Triangles, arguments: &str, tables: &Path) -> Self {
        let words = ["advise"].into_iter().chain(arguments.split_whitespace());
        let options = Options::try_parse_from(words).unwrap();
        let question = Question::new(options.ask, options.way).unwrap();
        let scene = Scene::new(question, triangles, options.cell, options.tolerance).unwrap();
        let costs = Costs::read(tables, options.target, question).unwrap();
        let sample = options.sample.get() as usize;
        let (target, full) = (options.target, options.full);
        let survey = Survey::of(&scene, &Plan { target, sample, full, costs: &costs });
        // Joins broken lines.
        let text = crate::report::write("mesh", &options, &scene, &survey, &costs);
        let text = text.replace("\n    ", " ");
        Self { options, scene, survey, text }
    }

    /// For a small core, so that the result does not depend on a clock, and without tables.
    fn on(triangles: Triangles, arguments: &str) -> Self {
        let arguments = format!("--target m0 {arguments}");
        Self::with_tables(triangles, &arguments, Path::new("no such folder"))
    }

    fn recommended(&self) -> Option<&Row> {
        recommend(&self.survey.rows, &self.scene, self.options.bits)
    }

    /// The text that follows these words, up to a space.
    fn figure_after(&self, words: &str) -> f64 {
        let (_, rest) = self.text.split_once(words).unwrap_or_else(|| panic!("{}", self.text));
        rest.split([' ', ',', '\n']).next().unwrap().parse().unwrap()
    }
}
