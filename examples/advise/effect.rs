//! The effect of rounding on a scene.

use std::collections::BTreeSet;

use septum::Triangle;

use crate::kind::Kind;
use crate::question::TURNED;
use crate::scene::Scene;

/// The effect of rounding to one type.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Effect {
    /// The greatest distance by which a vertex, a corner of a box, or the end of its path moved.
    pub(crate) moved: f64,
    /// How many triangles became segments or points.
    pub(crate) degenerate: usize,
    /// Whether a box became flat.
    pub(crate) flat: bool,
    /// The size in bytes of a table with each vertex once, and faces as indices.
    pub(crate) table: u64,
}

impl Effect {
    /// The effect of rounding to `kind`, which can represent the scene.
    pub(crate) fn of(kind: Kind, scene: &Scene) -> Self {
        let nearest = |x: f64| kind.nearest(x).expect("a type that holds the scene");
        let mut effect = Self { moved: 0.0, degenerate: 0, flat: false, table: 0 };
        let mut vertices = BTreeSet::new();
        for triangle in &scene.triangles {
            let rounded = triangle.map(|p| p.map(nearest));
            for (p, q) in triangle.iter().zip(&rounded) {
                effect.moved = effect.moved.max(distance([0, 1, 2].map(|i| p[i] - q[i])));
                vertices.insert(q.map(|x| (x + 0.0).to_bits()));
            }
            let became = is_degenerate(&rounded) && !is_degenerate(triangle);
            effect.degenerate += usize::from(became);
        }
        // The faces of the boxes move independently along each axis.
        let mut worst = [0.0; 3];
        let mut worst_end = [0.0; 3];
        let way = scene.question.way();
        for (axis, (worst, cells)) in worst.iter_mut().zip(&scene.cells).enumerate() {
            let mut last = None;
            for i in cells.start..=cells.end {
                let (from, to) = (scene.face(i), nearest(scene.face(i)));
                *worst = f64::max(*worst, (from - to).abs());
                if i < cells.end {
                    let end = from + way[axis];
                    worst_end[axis] = f64::max(worst_end[axis], (end - nearest(end)).abs());
                }
                effect.flat |= last.replace(to) == Some(to);
            }
        }
        if scene.question.turns() {
            worst = of_turned(kind, scene);
            effect.flat = nearest(scene.cell / 2.0) == 0.0;
        }
        if let Some((places, radius)) = scene.question.round() {
            worst = of_round(kind, scene, places, radius);
            effect.flat = radius > 0.0 && nearest(radius * scene.cell) == 0.0;
        }
        effect.moved = effect.moved.max(distance(worst)).max(distance(worst_end));
        let index = if vertices.len() > 1 << 16 { 4 } else { 2 };
        let coordinates = u64::from(kind.bits() / 8) * vertices.len() as u64;
        effect.table = 3 * (coordinates + index * scene.triangles.len() as u64);
        effect
    }
}

/// The greatest distance by which the boundary of a round shape moves along each axis: the errors of
/// a centre and of the radius.
fn of_round(kind: Kind, scene: &Scene, places: &[f64], radius: f64) -> [f64; 3] {
    let off = |x: f64| (x - kind.nearest(x).expect("a type that holds the scene")).abs();
    [0, 1, 2].map(|axis| {
        let at = |i: i64| places.iter().map(move |part| scene.face(i) + part * scene.cell);
        let centers = scene.cells[axis].clone().flat_map(at).map(off);
        centers.fold(0.0, f64::max) + off(radius * scene.cell)
    })
}

/// The greatest distance by which a corner of a rotated box moves along each axis: the error of its
/// centre, plus the errors of its half-extents along its axes.
fn of_turned(kind: Kind, scene: &Scene) -> [f64; 3] {
    let nearest = |x: f64| kind.nearest(x).expect("a type that holds the scene");
    let off = |x: f64| (x - nearest(x)).abs();
    let half = scene.cell / 2.0;
    [0, 1, 2].map(|axis| {
        let middles = scene.cells[axis].clone().map(|i| off(scene.face(i) + half));
        let along = TURNED.map(|u| (half * u[axis] - nearest(half) * nearest(u[axis])).abs());
        middles.fold(0.0, f64::max) + along.iter().sum::<f64>()
    })
}

fn distance([x, y, z]: [f64; 3]) -> f64 {
    x.hypot(y).hypot(z)
}

/// Exact for every type: `f64` holds all numbers that occur here.
fn is_degenerate(triangle: &[[f64; 3]; 3]) -> bool {
    let [a, b, c] = *triangle;
    Triangle::new(a, b, c).is_ok_and(|t| t.is_degenerate())
}
