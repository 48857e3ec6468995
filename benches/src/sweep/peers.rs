//! The peers' shape casts.

use box3d_rust::distance::{ShapeCastPairInput, make_proxy, shape_cast};
use box3d_rust::math_functions as box3d;
use parry3d::math::{Pose, Vector};
use parry3d::query::{ShapeCastOptions, cast_shapes};
use parry3d::shape::{Cuboid, Triangle as ParryTriangle};

use super::Shot;

fn vector(p: [f32; 3]) -> Vector {
    Vector::new(p[0], p[1], p[2])
}

/// parry3d's time, if it hits.
#[inline(never)]
pub fn parry(shot: &Shot) -> Option<f32> {
    let [a, b, c] = shot.triangle.map(vector);
    let cuboid = Cuboid::new(vector(shot.half));
    let pose = Pose::from_translation(vector(shot.center));
    let options = ShapeCastOptions::with_max_time_of_impact(1.0);
    let triangle = ParryTriangle::new(a, b, c);
    let (still, zero) = (Pose::IDENTITY, vector([0.0; 3]));
    cast_shapes(&pose, vector(shot.way), &cuboid, &still, zero, &triangle, options)
        .expect("it has a cast for these")
        .map(|hit| hit.time_of_impact)
}

/// box3d-rust's time. It stops a linear slop of 5 mm earlier.
#[inline(never)]
pub fn box3d_cast(shot: &Shot) -> Option<f32> {
    let point = |[x, y, z]: [f32; 3]| box3d::Vec3 { x, y, z };
    let corners: [_; 8] = std::array::from_fn(|k| {
        point(std::array::from_fn(|i| {
            shot.center[i] + if k >> i & 1 == 0 { -shot.half[i] } else { shot.half[i] }
        }))
    });
    let output = shape_cast(&ShapeCastPairInput {
        proxy_a: make_proxy(&shot.triangle.map(point), 0.0),
        proxy_b: make_proxy(&corners, 0.0),
        transform: box3d::TRANSFORM_IDENTITY,
        translation_b: point(shot.way),
        max_fraction: 1.0,
        can_encroach: true,
    });
    output.hit.then_some(output.fraction)
}
