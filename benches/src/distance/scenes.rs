//! Spheres and capsules near triangles.

use septum_kit::Rng;
use septum_kit::spheres::{CapsuleCase, Other, SphereCase};

/// A triangle, and a point in the cube of twice its size: most spheres are apart from it.
pub fn anywhere(rng: &mut Rng) -> SphereCase<f32> {
    let mut point = |size: f64| rng.triple(|rng| rng.real(-size, size) as f32);
    let (center, triangle) = (point(2.0), [(); 3].map(|()| point(1.0)));
    SphereCase { center, radius: rng.real(0.1, 0.9) as f32, other: Other::Triangle(triangle) }
}

/// The same with a capsule.
pub fn capsule_anywhere(rng: &mut Rng) -> CapsuleCase<f32> {
    let SphereCase { center, radius, other } = anywhere(rng);
    let end = rng.triple(|rng| rng.real(-0.5, 0.5) as f32);
    CapsuleCase { ends: [center, [0, 1, 2].map(|i| center[i] + end[i])], radius, other }
}
