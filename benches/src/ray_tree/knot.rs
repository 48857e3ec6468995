//! A mesh of any size, and rays toward it.

use septum_kit::Rng;

/// A point of the mesh before its conversion to a scalar.
pub type Point = [f32; 3];

/// A closed tube along a torus knot; each step along it has 100 triangles.
pub fn knot(steps: u32) -> (Vec<Point>, Vec<[u32; 3]>) {
    const AROUND: u32 = 50;
    let center = |s: f64| {
        let (r, h) = (2.0 + (3.0 * s).cos(), (3.0 * s).sin());
        [r * (2.0 * s).cos(), r * (2.0 * s).sin(), h]
    };
    let unit = |v: [f64; 3]| {
        let length = v.iter().map(|x| x * x).sum::<f64>().sqrt();
        v.map(|x| x / length)
    };
    let cross = |a: [f64; 3], b: [f64; 3]| {
        [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
    };
    let mut vertices = Vec::new();
    for i in 0..steps {
        let s = f64::from(i) / f64::from(steps) * std::f64::consts::TAU;
        let (c, ahead) = (center(s), center(s + 1e-5));
        let along = unit([0, 1, 2].map(|k| ahead[k] - c[k]));
        let side = unit(cross(along, [0.0, 0.0, 1.0]));
        let up = cross(along, side);
        for j in 0..AROUND {
            let a = f64::from(j) / f64::from(AROUND) * std::f64::consts::TAU;
            let p = |k: usize| c[k] + 0.4 * (side[k] * a.cos() + up[k] * a.sin());
            vertices.push([0, 1, 2].map(|k| p(k) as f32));
        }
    }
    let at = |i: u32, j: u32| (i % steps) * AROUND + j % AROUND;
    let cell = |i, j| {
        let [a, b, c, d] = [at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)];
        [[a, c, b], [a, d, c]]
    };
    let faces = (0..steps).flat_map(|i| (0..AROUND).flat_map(move |j| cell(i, j))).collect();
    (vertices, faces)
}

/// The target of a ray.
#[derive(Clone, Copy, PartialEq, Eq)]
pub enum Aim {
    /// At any point of the box around the knot.
    Anywhere,
    /// At a vertex, which six triangles share.
    Vertex,
}

/// Rays as their origins, twice as far out as the knot, and the points that they pass through.
pub fn rays(points: &[Point], aim: Aim, count: usize, rng: &mut Rng) -> Vec<[Point; 2]> {
    let anywhere =
        |rng: &mut Rng, reach: f64| [3.4, 3.4, 1.4].map(|x| (rng.real(-x, x) * reach) as f32);
    let ray = |_| {
        let origin = anywhere(rng, 2.0);
        let target = match aim {
            Aim::Anywhere => anywhere(rng, 1.0),
            Aim::Vertex => points[rng.below(points.len())],
        };
        [origin, target]
    };
    (0..count).map(ray).collect()
}
