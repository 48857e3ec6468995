//! The workloads: rays, each with triangles to test.

use fastrand::Rng;

use crate::geometry::{Line, Point, blend, random_point, random_triangle};
use crate::pairs::Pairs;

/// Rays, each with the triangles that it is tested against.
pub type Scene = Pairs<Line, [Point; 3]>;

const PAIRS: usize = 100_000;
/// The number of triangles for each ray in scenes with many.
const MANY: usize = 1_000;

/// Each ray against a triangle of its own; half of them hit.
pub fn half_hit() -> Scene {
    pairs(&mut Rng::with_seed(11), 0.5)
}

/// The same, and one in ten hits.
pub fn tenth_hit() -> Scene {
    pairs(&mut Rng::with_seed(12), 0.1)
}

/// Each ray against a thousand triangles; half of them are hit.
pub fn many_half_hit() -> Scene {
    many(&mut Rng::with_seed(13), 0.5)
}

/// The same, and one in ten is hit.
pub fn many_tenth_hit() -> Scene {
    many(&mut Rng::with_seed(14), 0.1)
}

/// Rays toward points of an edge, as near as rounding allows: every pair is in doubt.
pub fn edges() -> Scene {
    let mut rng = Rng::with_seed(15);
    let mut aim = |triangle: &[Point; 3], rng: &mut Rng| {
        let u = rng.f64();
        let mut weights = [u, 1.0 - u, 0.0];
        rng.shuffle(&mut weights);
        Line::towards(random_point(rng), blend(triangle, weights))
    };
    aimed(&mut rng, random_triangle, &mut aim)
}

/// Rays through points of the integer grid {−2…2}³ at triangles on it: contacts
/// of every kind, exactly.
pub fn grid() -> Scene {
    let point = |rng: &mut Rng| [0; 3].map(|_| f64::from(rng.i8(-2..=2)));
    let triangle = |rng: &mut Rng| [0; 3].map(|_| point(rng));
    let aim = |_: &[Point; 3], rng: &mut Rng| loop {
        let (origin, target) = (point(rng), point(rng));
        if origin != target {
            return Line::towards(origin, target);
        }
    };
    aimed(&mut Rng::with_seed(16), triangle, aim)
}

/// Rays at an angle of about 1 in 10,000 to the plane of the triangle; about half of them cross it
/// inside.
pub fn near_parallel() -> Scene {
    let aim = |triangle: &[Point; 3], rng: &mut Rng| {
        let mut in_plane = || loop {
            let (u, v) = (rng.f64() * 1.4 - 0.2, rng.f64() * 1.4 - 0.2);
            let point = blend(triangle, [1.0 - u - v, u, v]);
            if point.iter().all(|x| x.abs() <= 2.0) {
                return point;
            }
        };
        let (origin, target) = (in_plane(), in_plane());
        let lifted = |x: f64| x + 2e-4 * (rng.f64() - 0.5);
        Line::towards(origin.map(lifted), target)
    };
    aimed(&mut Rng::with_seed(17), random_triangle, aim)
}

fn pairs(rng: &mut Rng, rate: f64) -> Scene {
    let mut scene = Scene::default();
    for _ in 0..PAIRS {
        let wanted = rng.f64() < rate;
        loop {
            let (line, triangle) = (random_line(rng), random_triangle(rng));
            if crosses(&line, &triangle) == wanted {
                scene.push(line, [triangle]);
                break;
            }
        }
    }
    scene
}

fn many(rng: &mut Rng, rate: f64) -> Scene {
    let mut scene = Scene::default();
    for _ in 0..PAIRS / MANY {
        let line = random_line(rng);
        let triangle = || {
            let wanted = rng.f64() < rate;
            loop {
                let triangle = random_triangle(rng);
                if crosses(&line, &triangle) == wanted {
                    return triangle;
                }
            }
        };
        scene.push(line, std::iter::repeat_with(triangle).take(MANY));
    }
    scene
}

fn aimed(
    rng: &mut Rng,
    triangle: impl Fn(&mut Rng) -> [Point; 3],
    mut aim: impl FnMut(&[Point; 3], &mut Rng) -> Line,
) -> Scene {
    let mut scene = Scene::default();
    for _ in 0..PAIRS {
        let triangle = triangle(rng);
        scene.push(aim(&triangle, rng), [triangle]);
    }
    scene
}

fn random_line(rng: &mut Rng) -> Line {
    Line::towards(random_point(rng), random_point(rng))
}

/// Whether ray and triangle cross, accurately enough to mix hits and misses.
fn crosses(line: &Line, triangle: &[Point; 3]) -> bool {
    let ray = septum::Ray::new(line.origin, line.direction);
    let [a, b, c] = *triangle;
    let triangle = septum::Triangle::new(a, b, c);
    ray.is_ok_and(|ray| triangle.is_ok_and(|triangle| ray.is_hit(&triangle)))
}
