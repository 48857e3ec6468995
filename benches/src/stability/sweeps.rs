//! Boxes that move past triangles ever closer to grazing.

use septum_kit::sweeps::SweepCase;
use septum_kit::{BoxNumbers, Case, Rng, Sample};

use super::boxes::{Point, across, along, plus, point};

/// A box that moves by about its size, at an angle to a wall with this sine. In half of the cases
/// it would reach the plane.
pub(super) fn graze<S: Sample>(rng: &mut Rng, sine: f64) -> Option<SweepCase<S>> {
    let length = |v: Point| v.iter().map(|x| x * x).sum::<f64>().sqrt();
    let (a, b) = (point(rng, 1.5), point(rng, 1.5));
    let c = plus(along(a, b, rng.real(0.0, 1.0)), across(rng, a, b));
    let (e, f) = ([0, 1, 2].map(|i| b[i] - a[i]), [0, 1, 2].map(|i| c[i] - a[i]));
    let normal = [(1, 2), (2, 0), (0, 1)].map(|(j, k)| e[j] * f[k] - e[k] * f[j]);
    let normal = normal.map(|x| x / length(normal).max(1e-9));
    let (p, q) = (rng.real(-1.0, 1.0), rng.real(-1.0, 1.0));
    let within: Point = [0, 1, 2].map(|i| p * e[i] + q * f[i]);
    let flat = (1.0 - sine * sine).sqrt() / length(within).max(1e-9);
    let way: Point = [0, 1, 2].map(|i| flat * within[i] - sine * normal[i]);
    // The extent of the box toward the wall, and the point where it meets the plane.
    let half = rng.triple(|rng| rng.real(0.1, 0.5));
    let reach: f64 = (0..3).map(|i| half[i] * normal[i].abs()).sum();
    let (u, v) = (rng.real(0.0, 1.0), rng.real(0.0, 1.0));
    let target = along(a, along(b, c, u), v);
    let when = rng.real(0.0, 2.0);
    let center = [0, 1, 2].map(|i| target[i] + reach * normal[i] - when * way[i]);
    let near = |p: Point| p.map(S::nearest);
    let case =
        Case { vertices: [a, b, c].map(near), aabb: BoxNumbers::Center(near(center), near(half)) };
    // The box moves from the second place to the first.
    Some(SweepCase { case, way: [near(way), [S::ZERO; 3]] })
}
