//! The workloads: boxes, each with boxes to test.

use fastrand::Rng;
use septum::Obb;

use crate::geometry::{Point, random_point};
use crate::pairs::Pairs;

/// A box by its centre, axes and half-extents.
#[derive(Clone, Copy)]
pub struct Turned {
    pub center: Point,
    pub axes: [Point; 3],
    pub half: Point,
}

/// Boxes, each with the boxes that it is tested against.
pub type Scene = Pairs<Turned, Turned>;

const PAIRS: usize = 50_000;

/// Pairs; half of them overlap.
pub fn half() -> Scene {
    pairs(&mut Rng::with_seed(41), 0.5, std::f64::consts::TAU)
}

/// The same, and one in ten overlaps.
pub fn tenth() -> Scene {
    pairs(&mut Rng::with_seed(42), 0.1, std::f64::consts::TAU)
}

/// Boxes rotated by a ten-millionth at most.
pub fn nearly_parallel() -> Scene {
    pairs(&mut Rng::with_seed(43), 0.5, 1e-7)
}

/// Axis-parallel boxes, face on face: contact.
pub fn stacked() -> Scene {
    let mut rng = Rng::with_seed(44);
    let mut scene = Scene::default();
    for _ in 0..PAIRS {
        let mut whole = || [0; 3].map(|_| f64::from(rng.i8(1..=16)) / 32.0);
        let (half, other, center) = (whole(), whole(), whole());
        let lower = Turned { center, axes: turned([0.0; 3]), half };
        let mut upper = Turned { half: other, ..lower };
        upper.center[2] += half[2] + other[2];
        scene.push(lower, [upper]);
    }
    scene
}

/// The coordinate axes rotated by these angles.
pub(crate) fn turned(angles: [f64; 3]) -> [Point; 3] {
    let mut frame = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
    for (angle, (i, j)) in angles.into_iter().zip([(0, 1), (1, 2), (2, 0)]) {
        let (sin, cos) = angle.sin_cos();
        for row in &mut frame {
            (row[i], row[j]) = (cos * row[i] - sin * row[j], sin * row[i] + cos * row[j]);
        }
    }
    frame
}

impl Turned {
    /// A box in [−1, 1]³, rotated about each axis by at most `angle`.
    pub fn random(rng: &mut Rng, angle: f64) -> Self {
        Self {
            center: random_point(rng).map(|x| x / 2.0),
            axes: turned([0; 3].map(|_| rng.f64() * angle)),
            half: [0; 3].map(|_| 0.05 + rng.f64() * 0.6),
        }
    }
}

fn pairs(rng: &mut Rng, rate: f64, angle: f64) -> Scene {
    let shape = |b: &Turned| Obb::new(b.center, b.axes, b.half).expect("a frame");
    let mut scene = Scene::default();
    for _ in 0..PAIRS {
        let wanted = rng.f64() < rate;
        loop {
            let (b, c) = (Turned::random(rng, angle), Turned::random(rng, angle));
            if shape(&b).overlaps(&shape(&c)) == wanted {
                scene.push(b, [c]);
                break;
            }
        }
    }
    scene
}
