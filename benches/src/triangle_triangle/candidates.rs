//! The candidates: ours in any scalar, the yardstick, and the peer.

use std::sync::Once;

use parry3d::math::Pose;
use parry3d::query::details::intersection_test_support_map_support_map;
use parry3d::shape::Triangle as ParryTriangle;
use septum::{Scalar, Triangle};

use crate::candidate::{Candidate, Course, Promise};
use crate::peer_shapes::parry_vector;
use crate::unit::{F32, Unit};

use super::guigue_devillers::{Real, overlap};
use super::scenes::Scene;

/// The scene in a scalar; the truth is the exact test in `f64`.
pub fn course<S: Scalar>(scene: &Scene, unit: &Unit<S>) -> Course<Triangle<S>, Triangle<S>> {
    let pairs = scene.map(|t| unit.triangle(t), |t| unit.triangle(t));
    let wide = pairs.map(|t| unit.wide_triangle(t), |t| unit.wide_triangle(t));
    Course::new((unit.name, ""), pairs, wide.answers(|t, u| t.overlaps(u)))
}

#[inline(never)]
fn exact<S: Scalar>(t: &Triangle<S>, u: &Triangle<S>) -> bool {
    t.overlaps(u)
}

#[inline(never)]
fn conservative<S: Scalar>(t: &Triangle<S>, u: &Triangle<S>) -> bool {
    t.may_overlap(u)
}

/// All our modes in one scalar.
pub fn ours<S: Scalar>(course: &Course<Triangle<S>, Triangle<S>>) -> Vec<Candidate> {
    vec![
        course.candidate("exact", Promise::Exact, exact),
        course.candidate("conservative", Promise::NeverMisses, conservative),
    ]
}

pub fn yardstick(scene: &Scene) -> Candidate {
    by_axes(&course(scene, &F32), "yardstick: 11 axes")
}

pub fn by_axes(course: &Course<Triangle<f32>, Triangle<f32>>, who: &str) -> Candidate {
    course.candidate(who, Promise::Nothing, eleven_axes)
}

/// The separating-axis test of textbooks, in `f32`: both normals, and the cross product of every
/// two edges. It reports coplanar triangles as overlapping.
#[inline(never)]
fn eleven_axes(t: &Triangle<f32>, u: &Triangle<f32>) -> bool {
    let points = |t: &Triangle<f32>| t.vertices().map(|p| p.to_array());
    let (p, q) = (points(t), points(u));
    let from = |a: [f32; 3], b: [f32; 3]| [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
    let edges = |p: &[[f32; 3]; 3]| [from(p[1], p[0]), from(p[2], p[1]), from(p[0], p[2])];
    let cross = |a: [f32; 3], b: [f32; 3]| {
        [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
    };
    let separates = |axis: [f32; 3]| {
        let on = |p: [f32; 3]| axis[0] * p[0] + axis[1] * p[1] + axis[2] * p[2];
        let (a, b) = (p.map(on), q.map(on));
        let low = |x: [f32; 3]| x[0].min(x[1]).min(x[2]);
        let high = |x: [f32; 3]| x[0].max(x[1]).max(x[2]);
        high(a) < low(b) || high(b) < low(a)
    };
    let (e, f) = (edges(&p), edges(&q));
    if separates(cross(e[0], e[1])) || separates(cross(f[0], f[1])) {
        return false;
    }
    !e.iter().any(|&e| f.iter().any(|&f| separates(cross(e, f))))
}

/// The test of Guigue and Devillers, in the scalar of the triangles.
pub fn by_volumes<T: Scalar + Real>(course: &Course<Triangle<T>, Triangle<T>>) -> Candidate {
    let points = |t: &Triangle<T>| t.vertices().map(|p| p.to_array());
    let pairs = course.prepared("", |pairs| pairs.map(points, points));
    pairs.candidate("Guigue-Devillers", Promise::Nothing, overlap)
}

/// Far from the origin it asserts that its bounds are finite, and panics; that counts as no
/// overlap.
#[inline(never)]
fn parry(t: &ParryTriangle, u: &ParryTriangle) -> bool {
    let meet = || intersection_test_support_map_support_map(&Pose::IDENTITY, t, u);
    std::panic::catch_unwind(meet).unwrap_or(false)
}

/// Silences the peer's panics, which are caught; all others are printed.
fn hush_parry() {
    static ONCE: Once = Once::new();
    ONCE.call_once(|| {
        let tell = std::panic::take_hook();
        std::panic::set_hook(Box::new(move |info| {
            if !info.location().is_some_and(|place| place.file().contains("parry3d")) {
                tell(info);
            }
        }));
    });
}

/// The peer, in `f32`.
pub fn peers(course: &Course<Triangle<f32>, Triangle<f32>>) -> Vec<Candidate> {
    hush_parry();
    let triangle = |t: &Triangle<f32>| {
        let [a, b, c] = t.vertices().map(parry_vector);
        ParryTriangle::new(a, b, c)
    };
    let parry3d = course.prepared("", |pairs| pairs.map(triangle, triangle));
    vec![parry3d.candidate("parry3d support maps", Promise::Nothing, parry)]
}
