//! Small cores: the same picture with instructions across, from a committed table.

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
    path: String,
    instructions: f64,
}

/// Draws a picture for each query in the table; none where there is no table.
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
    let wanted: Vec<&Cost> = costs.iter().filter(|cost| cost.query == query).collect();
    let mut done: Vec<[&str; 3]> = Vec::new();
    for cost in &wanted {
        let key = [cost.core.as_str(), cost.scalar.as_str(), cost.mode.as_str()];
        if done.contains(&key) {
            continue;
        }
        done.push(key);
        let Some(point) = twin(points, picture, cost) else {
            eprintln!("{query}, {}, {}: no such test on the host", cost.mode, cost.scalar);
            continue;
        };
        let same = wanted.iter().filter(|c| [&c.core[..], &c.scalar, &c.mode] == key);
        let paths: Vec<f64> = same.map(|c| c.instructions).collect();
        let low = paths.iter().copied().fold(f64::INFINITY, f64::min);
        let high = paths.iter().copied().fold(0.0, f64::max);
        let dot = Dot {
            family: look(&point.test),
            label: format!("{}, {}", cost.mode, cost.scalar),
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
    // What paths there are is for the table to say.
    debug_assert!(wanted.iter().all(|cost| !cost.path.is_empty()));
    rows
}

/// The same test on the host: by the name there, or by the method's name in code.
fn twin<'a>(points: &'a [Point], picture: &str, cost: &Cost) -> Option<&'a Point> {
    let test = match (picture, cost.mode.as_str()) {
        ("ray-triangle", "hit" | "exact") => "exact hit",
        ("ray-triangle", "hits") => "exact hits",
        ("ray-triangle", "hit_once" | "once") => "exact hit_once",
        (_, "overlaps") => "exact",
        (_, "may_overlap") => "conservative",
        (_, "overlaps_rounded") => "rounded",
        ("ray-box", "overlaps_as_published" | "as published") => "as published (SAT)",
        (_, "overlaps_as_published") => "as published",
        (_, "hit_moller_trumbore" | "moller_trumbore") => "Möller–Trumbore",
        (_, "hit_stored_normal" | "stored_normal") => "stored normal",
        (_, "watertight" | "Woop") => "watertight (Woop)",
        (_, mode) => mode,
    };
    let same = |p: &&Point| {
        p.picture == picture && p.test == test && p.scalar.split(',').next() == Some(&cost.scalar)
    };
    points.iter().find(same)
}
