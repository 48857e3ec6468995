//! The workloads: triangles, each with triangles to test.

use fastrand::Rng;
use septum::Triangle;

use crate::geometry::{Point, random_triangle};
use crate::obj::teapot;
use crate::pairs::Pairs;

/// Triangles, each with the triangles that it is tested against.
pub type Scene = Pairs<[Point; 3], [Point; 3]>;

const PAIRS: usize = 100_000;

/// A teapot and a rotated, shifted copy: the pairs whose bounding boxes meet, as after a tree of
/// boxes.
pub fn teapots() -> Scene {
    let one = placed();
    // Rotated by the angle with sine 3/5, and shifted by two fifths.
    let turned = |[x, y, z]: Point| [0.8 * x - 0.6 * y + 0.4, 0.6 * x + 0.8 * y, z - 0.3];
    let other: Vec<_> = one.iter().map(|t| t.map(turned).map(rounded)).collect();
    candidates(&one, &other, |_, _| true)
}

/// Triangles of a teapot that share a vertex, and others whose bounding boxes meet.
pub fn neighbours() -> Scene {
    let one = placed();
    candidates(&one, &one, |i, k| i < k)
}

/// Pairs; half of them overlap.
pub fn half() -> Scene {
    pairs(&mut Rng::with_seed(31), 0.5)
}

/// The same, and one in ten overlaps.
pub fn tenth() -> Scene {
    pairs(&mut Rng::with_seed(32), 0.1)
}

/// Triangles on the integer grid {−2…2}³: contacts of every kind.
pub fn grid() -> Scene {
    let mut rng = Rng::with_seed(33);
    let mut triangle = || [0; 3].map(|_| [0; 3].map(|_| f64::from(rng.i8(-2..=2))));
    by_pairs(|| [triangle(), triangle()])
}

/// Pairs of triangles in one axis-parallel plane.
pub fn plane() -> Scene {
    let mut rng = Rng::with_seed(34);
    by_pairs(|| {
        let (axis, at) = (rng.usize(..3), rounded([rng.f64(), 0.0, 0.0])[0]);
        [random_triangle(&mut rng), random_triangle(&mut rng)].map(|t| {
            t.map(|p| {
                let mut p = rounded(p);
                p[axis] = at;
                p
            })
        })
    })
}

/// Rounds to 16 fraction bits, as the narrowest scalar of the teapot does.
fn rounded(p: Point) -> Point {
    p.map(|x| (x * 65_536.0).round() / 65_536.0)
}

/// The teapot in the cube [−1.2, 1.2]³.
fn placed() -> Vec<[Point; 3]> {
    let all = teapot();
    let most = all.iter().flatten().flatten().fold(0.0, |most: f64, x| most.max(x.abs()));
    all.iter().map(|t| t.map(|p| rounded(p.map(|x| x * 1.2 / most)))).collect()
}

fn candidates(
    one: &[[Point; 3]],
    other: &[[Point; 3]],
    wanted: impl Fn(usize, usize) -> bool,
) -> Scene {
    let ends = |t: &[Point; 3], i: usize| {
        let [a, b, c] = t.map(|p| p[i]);
        (a.min(b).min(c), a.max(b).max(c))
    };
    let meet = |t: &[Point; 3], u: &[Point; 3]| {
        (0..3).all(|i| {
            let ((a, b), (c, d)) = (ends(t, i), ends(u, i));
            a <= d && c <= b
        })
    };
    let mut scene = Scene::default();
    for (i, t) in one.iter().enumerate() {
        let near = other.iter().enumerate().filter(|&(k, u)| wanted(i, k) && meet(t, u));
        scene.push(*t, near.map(|(_, u)| *u));
    }
    scene
}

fn by_pairs(mut pair: impl FnMut() -> [[Point; 3]; 2]) -> Scene {
    let mut scene = Scene::default();
    for _ in 0..PAIRS {
        let [t, u] = pair();
        scene.push(t, [u]);
    }
    scene
}

fn pairs(rng: &mut Rng, rate: f64) -> Scene {
    by_pairs(|| {
        let wanted = rng.f64() < rate;
        loop {
            let pair = [random_triangle(rng), random_triangle(rng)];
            let [t, u] = pair.map(|[a, b, c]| Triangle::new(a, b, c).expect("finite"));
            if t.overlaps(&u) == wanted {
                return pair;
            }
        }
    })
}
