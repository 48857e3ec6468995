//! Ray and segment against oriented box; the yardstick is parry3d, in `f32`.

mod scenes;

use parry3d::query::{Ray as ParryRay, RayCast};
use septum::{Obb, Ray, Scalar, Segment};

use crate::candidate::{Candidate, Course, Promise};
use crate::obb_obb::{Placed, obb, placed, wide};
use crate::peer_shapes::parry_ray;
use crate::session::{Group, Session};
use crate::unit::{F32, F64, I8F8_15, I16F16_18, Unit};

pub(crate) use scenes::{Scene, half_hit};

/// The scene in a scalar; the truth is the exact test in `f64`.
fn course<S: Scalar>(scene: &Scene, unit: &Unit<S>) -> Course<Ray<S>, Obb<S>> {
    let pairs = scene.map(|l| unit.ray(l), |b| obb(unit, b));
    let truth = pairs.map(|r| unit.wide_ray(r), |b| wide(unit, b)).answers(|r, b| r.overlaps(b));
    Course::new((unit.name, ""), pairs, truth)
}

fn segments<S: Scalar>(scene: &Scene, unit: &Unit<S>) -> Course<Segment<S>, Obb<S>> {
    let pairs = scene.map(|l| unit.segment(l), |b| obb(unit, b));
    let wide = pairs.map(|s| unit.wide_segment(s), |b| wide(unit, b));
    Course::new((unit.name, ""), pairs, wide.answers(|s, b| s.overlaps(b)))
}

#[inline(never)]
fn exact<S: Scalar>(r: &Ray<S>, b: &Obb<S>) -> bool {
    r.overlaps(b)
}

#[inline(never)]
fn exact_t_range<S: Scalar>(r: &Ray<S>, b: &Obb<S>) -> Option<(S, S)> {
    r.t_range_obb(b)
}

#[inline(never)]
fn conservative<S: Scalar>(r: &Ray<S>, b: &Obb<S>) -> bool {
    r.may_overlap(b)
}

#[inline(never)]
fn segment_exact<S: Scalar>(s: &Segment<S>, b: &Obb<S>) -> bool {
    s.overlaps(b)
}

/// All our methods in one scalar.
pub(crate) fn ours<S: Scalar>(
    rays: &Course<Ray<S>, Obb<S>>,
    segments: &Course<Segment<S>, Obb<S>>,
) -> Vec<Candidate> {
    vec![
        rays.candidate("exact", Promise::Exact, exact),
        rays.candidate("exact t_range", Promise::Exact, exact_t_range),
        rays.candidate("conservative", Promise::NeverMisses, conservative),
        segments.candidate("segment, exact", Promise::Exact, segment_exact),
    ]
}

#[inline(never)]
fn parry(r: &ParryRay, b: &Placed) -> Option<f32> {
    b.cuboid.cast_ray(&b.pose, r, f32::MAX, true)
}

/// The peer, in `f32`.
pub(crate) fn peer(course: &Course<Ray<f32>, Obb<f32>>, who: &str) -> Candidate {
    let parry3d = course.prepared("", |pairs| pairs.map(parry_ray, placed));
    parry3d.candidate(who, Promise::Nothing, parry)
}

pub(crate) fn yardstick(scene: &Scene) -> Candidate {
    peer(&course(scene, &F32), "yardstick: parry3d cast_ray")
}

fn group<S: Scalar>(unit: Unit<S>) -> Group<Scene> {
    (unit.name, Box::new(move |scene: &Scene| ours(&course(scene, &unit), &segments(scene, &unit))))
}

pub(crate) fn groups() -> Vec<Group<Scene>> {
    vec![group(F32), group(F64), group(I8F8_15), group(I16F16_18)]
}

pub fn run(session: &mut Session) {
    let all = groups();
    let mut race = |name: &str, scene: fn() -> Scene| session.measure(name, scene, yardstick, &all);
    race("ray/oriented box: 50 % hits", half_hit);
    race("ray/oriented box: 10 % hits", scenes::tenth_hit);
    // The cost of doubt.
    race("ray/oriented box: along faces", scenes::along_faces);
}
