//! Small cores: the same picture with instructions on the horizontal axis, from a committed table.

use std::error::Error;
use std::path::Path;

use serde::Deserialize;

use crate::drawing::grouped;

use super::frame::{Dot, Frame, Row};
use super::point::Point;
use super::style::look;

/// A line of the table: one path through one test on one core.
#[derive(Deserialize)]
struct Cost {
    core: String,
    query: String,
    scalar: String,
    mode: String,
    instructions: f64,
}

impl Cost {
    /// The fields that identify a mark; all paths share one mark.
    fn key(&self) -> [&str; 4] {
        [&self.core, &self.query, &self.scalar, &self.mode]
    }
}

/// Draws a picture for each query in the table, if there is a table.
pub(super) fn draw(table: &Path, points: &[Point], out: &Path) -> Result<(), Box<dyn Error>> {
    if !table.exists() {
        println!("{}: not there, so no picture of small cores", table.display());
        return Ok(());
    }
    let failed = |e: csv::Error| format!("{}: {e}", table.display());
    let mut reader = csv::Reader::from_path(table).map_err(failed)?;
    let costs: Vec<Cost> = reader.deserialize().collect::<Result<_, _>>().map_err(failed)?;
    for (query, picture, title) in [
        ("triangle/box", "triangle-box", "Triangle and box on small cores"),
        ("ray/triangle", "ray-triangle", "Ray and triangle on small cores"),
        ("ray/box", "ray-box", "Ray and box on small cores"),
    ] {
        let rows = rows(&costs, query, picture, points);
        if rows.is_empty() {
            continue;
        }
        let frame = Frame {
            title: title.into(),
            subtitle: "Instructions for one query, counted.".into(),
            rows,
            axis: "instructions; the bar reaches from the shortest path measured to the longest"
                .into(),
            tick: grouped,
            base: 2.0,
            caption: format!(
                "Farther left is cheaper, lower is more often right; marks stand at the longest \
                 path. In the band marked 0 not one answer was wrong; height within the band has no \
                 meaning. Instructions are counted, not cycles: {} and the command that made it. \
                 Wrong answers are those of chart.csv, the same on every machine.",
                table.display()
            ),
            bars: false,
        };
        frame.draw(&out.join(format!("target-{picture}")))?;
    }
    Ok(())
}

fn rows(costs: &[Cost], query: &str, picture: &str, points: &[Point]) -> Vec<Row> {
    let mut rows: Vec<Row> = Vec::new();
    // `hit_once` costs what `hit` costs, within a fiftieth.
    let is_wanted = |cost: &&Cost| cost.query.starts_with(query) && !cost.query.ends_with("once");
    let wanted: Vec<&Cost> = costs.iter().filter(is_wanted).collect();
    let mut done: Vec<[&str; 4]> = Vec::new();
    let mut left_out: Vec<&str> = Vec::new();
    for cost in &wanted {
        let key = cost.key();
        if done.contains(&key) {
            continue;
        }
        done.push(key);
        let Some(point) = twin(points, picture, cost) else {
            if !left_out.contains(&cost.scalar.as_str()) {
                left_out.push(&cost.scalar);
            }
            continue;
        };
        let same = wanted.iter().filter(|c| c.key() == key);
        let paths: Vec<f64> = same.map(|c| c.instructions).collect();
        let low = paths.iter().copied().fold(f64::INFINITY, f64::min);
        let high = paths.iter().copied().fold(0.0, f64::max);
        let dot = Dot {
            family: look(&point.test),
            label: match cost.query.strip_prefix(query) {
                // `is_hit` returns one bit, the other methods a hit.
                Some(" hits") => format!("exact is_hit, {}", cost.scalar),
                Some(which) if cost.mode == "exact" => format!("exact{which}, {}", cost.scalar),
                _ => format!("{}, {}", cost.mode, cost.scalar),
            },
            cost: [low, high, high],
            worst: point.worst,
            mean: point.mean,
        };
        match rows.iter_mut().find(|row| row.heading == cost.core) {
            Some(row) => row.dots.push(dot),
            None => rows.push(Row {
                heading: cost.core.clone(),
                dots: vec![dot],
                height: 170.0,
                line: None,
            }),
        }
    }
    if !left_out.is_empty() {
        println!("{query} on small cores: not on the host, so not drawn: {}", left_out.join(", "));
    }
    rows
}

/// The same test on the host, under its name there.
fn twin<'a>(points: &'a [Point], picture: &str, cost: &Cost) -> Option<&'a Point> {
    let test = match (cost.query.as_str(), cost.mode.as_str()) {
        ("ray/triangle hit", "exact") => "exact hit",
        ("ray/triangle hits", "exact") => "exact is_hit",
        ("ray/triangle hit", "as published") => "Möller–Trumbore",
        ("ray/box", "as published") => "as published (SAT)",
        ("ray/box", "slabs") => "slabs, rounded",
        ("ray/box", "slopes") => "slopes, rounded",
        (_, mode) => mode,
    };
    let same = |p: &&Point| {
        p.picture == picture && p.test == test && p.scalar.split(',').next() == Some(&cost.scalar)
    };
    points.iter().find(same)
}
