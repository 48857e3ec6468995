//! The workloads: convex polygons, and the unit cube.

use std::f64::consts::TAU;

use fastrand::Rng;

use super::Scene;
use crate::geometry::{Cell, random_triangle};

const PAIRS: usize = 50_000;

/// Polygons against the unit cube around the origin. Their `count` vertices lie on the ellipse
/// through the vertices of a random triangle in [−2, 2]³, with the triangle's centroid as centre.
/// Three vertices are the triangle's own.
pub fn of_vertices(count: usize) -> Scene {
    let mut rng = Rng::with_seed(41);
    let polygon = |rng: &mut Rng| {
        let [a, b, c] = random_triangle(rng);
        if count == 3 {
            return vec![a, b, c];
        }
        let middle: [f64; 3] = std::array::from_fn(|i| (a[i] + b[i] + c[i]) / 3.0);
        let mut turns: Vec<_> = (0..count).map(|_| TAU * rng.f64()).collect();
        turns.sort_by(f64::total_cmp);
        let at = |turn: &f64| {
            let (sin, cos) = turn.sin_cos();
            let v = |i: usize| (b[i] - c[i]) / 3_f64.sqrt();
            std::array::from_fn(|i| middle[i] + cos * (a[i] - middle[i]) + sin * v(i))
        };
        turns.iter().map(at).collect()
    };
    let polygons = (0..PAIRS).map(|_| polygon(&mut rng)).collect();
    Scene::all_against(polygons, vec![Cell { center: [0.0; 3], half: [0.5; 3] }])
}
