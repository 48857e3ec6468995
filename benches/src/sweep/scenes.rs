//! Shots.

use septum_kit::Rng;

use super::Shot;

/// Triangles about the origin, a unit cube near it, and a way of about its size.
pub fn voorhies(rng: &mut Rng) -> Shot {
    let mut point = |most: f64| rng.triple(|rng| rng.real(-most, most) as f32);
    let (triangle, center, way) = ([point(2.0), point(2.0), point(2.0)], point(1.0), point(1.0));
    Shot { center, half: [0.5; 3], way, triangle }
}

/// A typical scene: small triangles around the path of a body.
pub fn scene(rng: &mut Rng) -> Shot {
    let way = rng.triple(|rng| rng.real(-1.0, 1.0) as f32);
    let t = rng.real(0.0, 1.0);
    let middle = [0, 1, 2].map(|i: usize| t * f64::from(way[i]) + rng.real(-0.7, 0.7));
    let triangle =
        [(); 3].map(|()| [0, 1, 2].map(|i: usize| (middle[i] + rng.real(-0.2, 0.2)) as f32));
    Shot { center: [0.0; 3], half: [0.5; 3], way, triangle }
}

/// From one side of a wall, a single triangle, to the other, at any angle and speed.
pub fn wall(rng: &mut Rng) -> Shot {
    let normal = rng.triple(|rng| rng.real(-1.0, 1.0));
    let size = 0.001 + rng.real(0.0, 1.0).powi(4);
    let far = 2_f64.powf(rng.real(-3.0, 10.0));
    // Two directions along the wall.
    let u = rng.triple(|rng| rng.real(-1.0, 1.0));
    let cross = |a: [f64; 3], b: [f64; 3]| {
        [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
    };
    let (p, q) = (cross(normal, u), cross(normal, cross(normal, u)));
    let at = |a: f64, b: f64, c: f64| [0, 1, 2].map(|i: usize| a * p[i] + b * q[i] + c * normal[i]);
    let wide = 4096.0;
    let triangle = [at(-wide, -wide, 0.0), at(wide, -wide, 0.0), at(0.0, wide, 0.0)];
    let length = |v: [f64; 3]| v.iter().map(|x| x * x).sum::<f64>().sqrt().max(1e-3);
    // Far enough to be entirely on one side.
    let off = (far + 2.0 * size) / length(normal);
    let slant = |rng: &mut Rng| rng.real(-0.5, 0.5) * far;
    let start = at(slant(rng), slant(rng), off);
    let end = at(slant(rng), slant(rng), -off);
    Shot {
        center: start.map(|x| x as f32),
        half: [size as f32; 3],
        way: [0, 1, 2].map(|i: usize| (end[i] - start[i]) as f32),
        triangle: triangle.map(|v| v.map(|x| x as f32)),
    }
}
