//! The tables of times in the documents, from the points of the chart.
//!
//! Each table stands below a comment that identifies it. The document chooses the rows, and their
//! order, by names; only the figures are updated.

use std::error::Error;
use std::path::Path;

use crate::drawing::grouped;

use super::point::Point;

/// The comment above a table by scalar. Other tables name their pictures in the comment.
const BY_SCALAR: &str = "exact by scalar";
const BY_PEER: &str = "exact beside peers";

/// A query: its name in a table, its picture, the exact test, the form of its boxes.
type Query = (&'static str, &'static str, &'static str, &'static str);

const QUERIES: [Query; 16] = [
    ("triangle, a mesh's voxels", "mesh-voxels", "exact, prepared", "on the way"),
    ("rays down a tree", "ray-tree", "exact first_hit", ""),
    ("the same, any hit", "ray-tree", "exact is_hit", ""),
    ("triangle/box, random", "triangle-box", "exact", "centre"),
    ("triangle/box, voxels", "triangle-box-voxel", "exact", "centre"),
    ("ray/triangle, `hit`", "ray-triangle", "exact hit", ""),
    ("ray/triangle, `is_hit`", "ray-triangle", "exact is_hit", ""),
    ("one ray, many triangles", "ray-triangle-many", "exact hit", ""),
    ("the same, both prepared", "ray-triangle-many", "exact hit, prepared", "both prepared"),
    ("the same, eight at once", "ray-triangle-many", "exact", "8 at once"),
    ("ray/box", "ray-box", "exact", "corners"),
    ("ray/box, ray prepared", "ray-box", "exact, ray prepared", "corners"),
    ("two oriented boxes", "box-box", "exact", ""),
    ("ray/oriented box", "ray-oriented-box", "exact", ""),
    ("sweep, when", "sweep", "exact, when", ""),
    ("contact of oriented boxes", "contact", "exact, with points", ""),
];
/// The queries of the shorter table.
const SHORT: [usize; 6] = [0, 1, 3, 5, 8, 11];

/// Updates the figures in a file.
pub(super) fn refresh(path: &Path, points: &[Point]) -> Result<(), Box<dyn Error>> {
    let at = |error| format!("{}: {error}", path.display());
    let text = std::fs::read_to_string(path).map_err(at)?;
    let mut kind = None;
    let lines = text.lines().map(|line| {
        if let Some(rest) = line.strip_prefix("<!-- chart: ") {
            kind = Some(rest.trim_end_matches(" -->").to_owned());
        } else if !line.is_empty() && !line.starts_with('|') {
            kind = None;
        }
        match &kind {
            Some(kind) if line.starts_with('|') => row(line, kind, points),
            _ => line.to_owned(),
        }
    });
    let new: String = lines.map(|line| line + "\n").collect();
    std::fs::write(path, new).map_err(at)?;
    Ok(())
}

/// A row with updated figures; unchanged if there are none.
fn row(line: &str, kind: &str, points: &[Point]) -> String {
    let mut cells: Vec<String> =
        line.trim_matches('|').split('|').map(|cell| cell.trim().to_owned()).collect();
    let names: Vec<String> = cells.iter().map(|c| c.replace(['*', '`'], "")).collect();
    let found = match kind {
        BY_SCALAR => by_scalar(&mut cells, &names, points),
        BY_PEER => by_peer(&mut cells, points),
        pictures => by_method(&mut cells, &names, pictures, points),
    };
    if found.is_some() { format!("| {} |", cells.join(" | ")) } else { line.to_owned() }
}

fn by_method(cells: &mut [String], names: &[String], kind: &str, points: &[Point]) -> Option<()> {
    let (pictures, form) = match kind.split_once(", ") {
        Some((picture, form)) => (picture, Some(form)),
        None => (kind, None),
    };
    let pictures: Vec<&str> = pictures.split(' ').collect();
    let first = cells.len().checked_sub(pictures.len() + 1)?;
    let form = form.or_else(|| names.get(2).filter(|_| first > 2).map(String::as_str));
    for (column, picture) in pictures.iter().enumerate() {
        let point = points.iter().find(|p| {
            (p.picture.as_str(), &p.test, &p.scalar) == (*picture, &names[0], &names[1])
                && form.is_none_or(|form| {
                    p.form.contains(form) && form.is_empty() == p.form.is_empty()
                })
        })?;
        put(&mut cells[first + column], format!("{:.2}", point.time));
        if column == 0 {
            put(cells.last_mut()?, grouped(point.worst));
        }
    }
    Some(())
}

/// Writes a figure, in bold if the cell was bold.
fn put(cell: &mut String, figure: String) {
    *cell = if cell.starts_with("**") { format!("**{figure}**") } else { figure };
}

fn by_scalar(cells: &mut [String], names: &[String], points: &[Point]) -> Option<()> {
    for (cell, query) in cells[1..].iter_mut().zip(SHORT) {
        *cell = match names[0].starts_with("fastest peer") {
            true => format!("{:.2}", peer(&QUERIES[query], points)?.time),
            false => format!("{:.2}", exact(&QUERIES[query], &names[0], points)?),
        };
    }
    Some(())
}

fn by_peer(cells: &mut [String], points: &[Point]) -> Option<()> {
    let query = QUERIES.iter().find(|(name, ..)| *name == cells[0])?;
    let peer = peer(query, points)?;
    let name = peer.test.trim_start_matches("yardstick: ");
    cells[1] = format!("{name} {:.2}", peer.time);
    for (cell, scalar) in cells[2..].iter_mut().zip(["f32", "f64", "I16F16, 18 bits"]) {
        let time = exact(query, scalar, points)?;
        let slower = if time > peer.time { ", **slower**" } else { "" };
        *cell = format!("{time:.2}{slower}");
    }
    Some(())
}

fn exact(&(_, picture, test, form): &Query, scalar: &str, points: &[Point]) -> Option<f64> {
    let is_it = |p: &&Point| {
        p.picture == picture
            && p.test == test
            && p.scalar.starts_with(scalar)
            && p.form.contains(form)
            && form.is_empty() == p.form.is_empty()
    };
    points.iter().find(is_it).map(|p| p.time)
}

fn peer<'a>(&(_, picture, test, _): &Query, points: &'a [Point]) -> Option<&'a Point> {
    // Down a tree, any hit is another question than the first.
    let is_any = (picture, test) == ("ray-tree", "exact is_hit");
    let is_it =
        |p: &&Point| p.picture == picture && p.peer && p.test.ends_with("any hit") == is_any;
    let peers = points.iter().filter(is_it);
    peers.min_by(|a, b| a.time.total_cmp(&b.time))
}
