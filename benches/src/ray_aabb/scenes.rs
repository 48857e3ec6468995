//! The workloads: rays, each with boxes to test.

use fastrand::Rng;
use septum::{Aabb, Ray, Segment};

use crate::geometry::{Cell, Line, random_point};
use crate::pairs::Pairs;
use crate::unit::{F64, Form};

/// Rays, each with the boxes that it is tested against.
pub type Scene = Pairs<Line, Cell>;

const PAIRS: usize = 100_000;
/// The number of boxes for each ray, as in a tree.
const MANY: usize = 1_000;

/// Random boxes; the ray meets half of them.
pub fn half_hit() -> Scene {
    random(&mut Rng::with_seed(21), 0.5)
}

/// The same with one in ten.
pub fn tenth_hit() -> Scene {
    random(&mut Rng::with_seed(22), 0.1)
}

/// Rays along the grid lines of unit cubes, and through their corners: zero components of the
/// direction, and contacts of every kind.
pub fn grid() -> Scene {
    let mut rng = Rng::with_seed(23);
    let mut scene = Scene::default();
    for _ in 0..PAIRS / MANY {
        let mut corner = || [0; 3].map(|_| f64::from(rng.i8(-2..=2)));
        let line = loop {
            let (origin, target) = (corner(), corner());
            if origin != target && (0..3).any(|i| origin[i] == target[i]) {
                break Line::towards(origin, target);
            }
        };
        let cell =
            || Cell { center: [0; 3].map(|_| f64::from(rng.u8(0..4)) - 1.5), half: [0.5; 3] };
        scene.push(line, std::iter::repeat_with(cell).take(MANY));
    }
    scene
}

fn random(rng: &mut Rng, rate: f64) -> Scene {
    let mut scene = Scene::default();
    for _ in 0..PAIRS / MANY {
        let line = Line::towards(random_point(rng), random_point(rng));
        let cell = || {
            let wanted = rng.f64() < rate;
            loop {
                let cell = random_cell(rng);
                if meets(&line, &cell) == Some(wanted) {
                    return cell;
                }
            }
        };
        scene.push(line, std::iter::repeat_with(cell).take(MANY));
    }
    scene
}

/// A box in [−2, 2]³.
fn random_cell(rng: &mut Rng) -> Cell {
    let half = [0; 3].map(|_| rng.f64() * 0.75);
    let center = half.map(|h| (rng.f64() * 2.0 - 1.0) * (2.0 - h));
    Cell { center, half }
}

/// Whether ray and box meet; `None` if the segment with t from 0 to 1 disagrees, so that ray and
/// segment have the same rate of hits.
fn meets(line: &Line, cell: &Cell) -> Option<bool> {
    let aabb: Aabb<f64> = F64.aabb(cell, Form::Center);
    let (ray, segment): (Ray<f64>, Segment<f64>) = (F64.ray(line), F64.segment(line));
    let meets = ray.overlaps(&aabb);
    (meets == segment.overlaps(&aabb)).then_some(meets)
}
