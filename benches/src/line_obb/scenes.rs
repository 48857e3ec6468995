//! The workloads: rays, each with a box to test.

use fastrand::Rng;
use septum::Obb;

use crate::geometry::{Line, random_point};
use crate::obb_obb::Turned;
use crate::pairs::Pairs;
use crate::unit::F64;

/// Rays, and the box that each is tested against.
pub type Scene = Pairs<Line, Turned>;

const PAIRS: usize = 50_000;

/// Pairs; half of them meet.
pub fn half_hit() -> Scene {
    random(&mut Rng::with_seed(51), 0.5)
}

/// The same, and one in ten meets.
pub fn tenth_hit() -> Scene {
    random(&mut Rng::with_seed(52), 0.1)
}

/// Rays in the plane of a face of an axis-parallel box: contact.
pub fn along_faces() -> Scene {
    let mut rng = Rng::with_seed(53);
    let mut scene = Scene::default();
    for _ in 0..PAIRS {
        let mut whole = || [0; 3].map(|_| f64::from(rng.i8(1..=16)) / 32.0);
        let (center, half) = (whole(), whole());
        let (mut origin, mut target) = (whole().map(|x| -2.0 * x), whole());
        let i = rng.usize(..3);
        origin[i] = center[i] + half[i];
        target[i] = origin[i];
        let axes = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
        scene.push(Line::towards(origin, target), [Turned { center, axes, half }]);
    }
    scene
}

fn random(rng: &mut Rng, rate: f64) -> Scene {
    let mut scene = Scene::default();
    for _ in 0..PAIRS {
        let wanted = rng.f64() < rate;
        loop {
            let line = Line::towards(random_point(rng), random_point(rng));
            let b = Turned::random(rng, std::f64::consts::TAU);
            let shape = Obb::new(b.center, b.axes, b.half).expect("a frame");
            let (ray, segment) = (F64.ray(&line), F64.segment(&line));
            // Segment and ray must agree, so that both have the same rate of hits.
            if [ray.overlaps(&shape), segment.overlaps(&shape)] == [wanted; 2] {
                scene.push(line, [b]);
                break;
            }
        }
    }
    scene
}
