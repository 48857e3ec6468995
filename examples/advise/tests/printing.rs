//! The numbers in the lines to paste read back as the same bits, in every type.

use super::{Triangles, scaled, teapot};
use crate::kind::{Candidates, Kind};
use crate::paste;
use crate::question::Question;
use crate::scene::Scene;

/// The numbers of the vertices `v(x, y, z)`, as they stand. The function itself has
/// none.
fn numbers(lines: &str) -> Vec<&str> {
    let vertices = lines.lines().filter_map(|l| l.trim().strip_prefix("v(")?.strip_suffix("),"));
    vertices.flat_map(|vertex| vertex.split(", ")).collect()
}

/// The bits that the number in Rust's source has, in this type.
fn bits(kind: Kind, number: &str) -> u64 {
    match kind {
        Kind::Fixed { bits: ..=8, .. } => number.parse::<i8>().unwrap() as u64,
        Kind::Fixed { bits: ..=16, .. } => number.parse::<i16>().unwrap() as u64,
        Kind::Fixed { bits: ..=32, .. } => number.parse::<i32>().unwrap() as u64,
        Kind::Fixed { .. } => number.parse::<i64>().unwrap() as u64,
        Kind::F32 => number.parse::<f32>().unwrap().to_bits().into(),
        Kind::F64 => number.parse::<f64>().unwrap().to_bits(),
    }
}

#[test]
fn pasted_numbers_read_back() {
    let moved: Triangles =
        teapot().into_iter().map(|t| t.map(|p| p.map(|x| (x + 0.3) / 7.1))).collect();
    for (triangles, cell) in
        [(teapot(), 0.5), (moved, 0.013), (scaled(1e-9), 1e-10), (scaled(123_456.7), 9999.9)]
    {
        let scene = Scene::new(Question::Overlap, triangles, Some(cell), None).unwrap();
        let points = scene.points(scene.query(0));
        let kinds = Candidates::of(&scene).held;
        assert!(kinds.len() >= 7, "{kinds:?}");
        for kind in kinds {
            let lines = paste::lines(kind, &scene);
            let expected = points.as_flattened().iter().map(|&x| match kind {
                Kind::Fixed { bits, frac } => Kind::raw(x, bits, frac).unwrap() as i64 as u64,
                Kind::F32 => (x as f32).to_bits().into(),
                Kind::F64 => x.to_bits(),
            });
            let read = numbers(&lines).into_iter().map(|number| bits(kind, number));
            assert_eq!(read.collect::<Vec<_>>(), expected.collect::<Vec<_>>(), "{lines}");
        }
    }
}
