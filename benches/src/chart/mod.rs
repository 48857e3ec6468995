//! The speed–accuracy chart: a point for every method in every scalar, with time on the horizontal
//! axis and wrong answers on the vertical.

mod frame;
mod legend;
mod measure;
mod picture;
mod point;
mod style;
mod tables;
mod target;

use std::error::Error;
use std::path::PathBuf;

use clap::Args;

use picture::{OVERVIEWS, PICTURES};

/// Charts speed against accuracy: time per query relative to the test as published,
/// wrong answers per million on the worst set and on the mean of all sets.
#[derive(Args)]
pub struct Options {
    /// Rounds per group of candidates
    #[arg(long, default_value_t = 25, value_parser = clap::value_parser!(u32).range(4..))]
    rounds: u32,
    /// Cases in each set
    #[arg(long, default_value_t = 100_000, value_parser = clap::value_parser!(u32).range(1..))]
    cases: u32,
    /// Where the pictures go, and chart.csv
    #[arg(long, value_name = "FOLDER", default_value = "docs/chart")]
    out: PathBuf,
    /// Instructions on small cores, drawn too if there is such a table
    #[arg(long, value_name = "FILE", default_value = "docs/target.csv")]
    target: PathBuf,
    /// Documents whose tables of times are updated
    #[arg(long, value_name = "FILE", default_values = ["docs/speed.md", "README.md"])]
    tables: Vec<PathBuf>,
    /// Measure spheres, capsules and closest points alone; other figures are those of chart.csv
    #[arg(long, conflicts_with = "redraw")]
    distances: bool,
    /// Draw from chart.csv without measuring
    #[arg(long)]
    redraw: bool,
}

/// Measures, writes the table, draws, and brings the documents up to date.
pub fn run(options: &Options) -> Result<(), Box<dyn Error>> {
    let table = options.out.join("chart.csv");
    let points = if options.redraw {
        point::read(&table)?
    } else {
        let (rounds, cases) = (options.rounds as usize, options.cases as usize);
        let near = measure::distances(rounds, cases);
        let mut points = match options.distances {
            true => point::read(&table)?,
            false => measure::points(rounds, cases),
        };
        points.retain(|point| near.iter().all(|new| new.picture != point.picture));
        points.extend(near);
        point::write(&table, &points)?;
        points
    };
    for overview in &OVERVIEWS {
        overview.draw(&points, &options.out)?;
    }
    for picture in &PICTURES {
        picture.draw(&points, &options.out)?;
        println!("{}", picture.verdict(&points));
    }
    for path in &options.tables {
        tables::refresh(path, &points)?;
    }
    let claims = points.iter().filter(|p| p.claims_to_be_exact() && p.worst > 0.0);
    let broken: Vec<String> = claims.map(|p| format!("{} in {}", p.test, p.scalar)).collect();
    if !broken.is_empty() {
        return Err(format!("not exact: {}", broken.join(", ")).into());
    }
    target::draw(&options.target, &points, &options.out)
}
