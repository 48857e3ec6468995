//! Shapes before their conversion to a scalar.

use fastrand::Rng;

pub type Point = [f64; 3];

/// A box by its centre and half-extents.
#[derive(Clone, Copy)]
pub struct Cell {
    pub center: Point,
    pub half: Point,
}

/// A ray.
#[derive(Clone, Copy)]
pub struct Line {
    pub origin: Point,
    pub direction: Point,
}

impl Line {
    /// The ray that reaches `target` at t = 2, so that no coordinate of the direction exceeds the
    /// points' coordinates.
    pub fn towards(origin: Point, target: Point) -> Self {
        Self { origin, direction: std::array::from_fn(|i| (target[i] - origin[i]) / 2.0) }
    }
}

/// A point of the cube [−2, 2]³.
pub fn random_point(rng: &mut Rng) -> Point {
    [0; 3].map(|_| rng.f64() * 4.0 - 2.0)
}

/// A triangle in the same cube.
pub fn random_triangle(rng: &mut Rng) -> [Point; 3] {
    [0; 3].map(|_| random_point(rng))
}

/// The point w·a + u·b + v·c.
pub fn blend([a, b, c]: &[Point; 3], [w, u, v]: [f64; 3]) -> Point {
    std::array::from_fn(|i| w * a[i] + u * b[i] + v * c[i])
}
