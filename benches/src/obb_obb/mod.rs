//! Oriented box against oriented box; the yardstick is parry3d, in `f32`.

mod gottschalk;
mod scenes;

use nalgebra::{Matrix3, Rotation3, UnitQuaternion};
use parry3d::math::{Pose, Rotation};
use parry3d::query::details::intersection_test_cuboid_cuboid;
use parry3d::shape::Cuboid;
use septum::{Obb, Scalar};

use crate::candidate::{Candidate, Course, Promise};
use crate::native;
use crate::peer_shapes::parry_vector;
use crate::session::{Group, Session};
use crate::unit::{F32, F64, I8F8_15, I16F16_18, Unit};

use gottschalk::Vectors;
pub(crate) use scenes::{Scene, Turned, half, turned};

pub(crate) fn obb<S: Scalar>(unit: &Unit<S>, turned: &Turned) -> Obb<S> {
    let axes = turned.axes.map(|u| u.map(|x| (unit.near)(x)));
    Obb::new(unit.point(turned.center), axes, unit.point(turned.half)).expect("a frame")
}

pub(crate) fn wide<S: Scalar>(unit: &Unit<S>, obb: &Obb<S>) -> Obb<f64> {
    let wide = |p: septum::Vec3<S>| p.to_array().map(unit.value);
    Obb::from_skewed_axes(wide(obb.center()), obb.axes().map(wide), wide(obb.half_extents()))
        .expect("it was a box before")
}

/// The scene in a scalar; the truth is the exact test in `f64`.
fn course<S: Scalar>(scene: &Scene, unit: &Unit<S>) -> Course<Obb<S>, Obb<S>> {
    let pairs = scene.map(|b| obb(unit, b), |b| obb(unit, b));
    let truth = pairs.map(|b| wide(unit, b), |b| wide(unit, b)).answers(|b, c| b.overlaps(c));
    Course::new((unit.name, ""), pairs, truth)
}

#[inline(never)]
fn exact<S: Scalar>(b: &Obb<S>, c: &Obb<S>) -> bool {
    b.overlaps(c)
}

#[inline(never)]
fn conservative<S: Scalar>(b: &Obb<S>, c: &Obb<S>) -> bool {
    b.may_overlap(c)
}

/// Our methods in one scalar.
pub(crate) fn ours<S: Scalar>(course: &Course<Obb<S>, Obb<S>>) -> Vec<Candidate> {
    vec![
        course.candidate("exact", Promise::Exact, exact),
        course.candidate("conservative", Promise::NeverMisses, conservative),
    ]
}

fn group<S: Scalar>(unit: Unit<S>) -> Group<Scene> {
    (unit.name, Box::new(move |scene: &Scene| ours(&course(scene, &unit))))
}

pub(crate) fn groups() -> Vec<Group<Scene>> {
    let in_vectors = |scene: &Scene| {
        let course = course(scene, &F32);
        let mut all = vec![in_vectors(&course)];
        all.extend(native::boxes(&course));
        all
    };
    let in_vectors: Group<Scene> = ("f32 15 axes Jolt", Box::new(in_vectors));
    vec![group(F32), in_vectors, group(F64), group(I8F8_15), group(I16F16_18)]
}

/// A box in the peer's form.
pub struct Placed {
    pub pose: Pose,
    pub cuboid: Cuboid,
}

#[inline(never)]
fn parry(b: &Placed, c: &Placed) -> bool {
    intersection_test_cuboid_cuboid(&b.pose.inv_mul(&c.pose), &b.cuboid, &c.cuboid)
}

#[must_use]
pub fn placed(obb: &Obb<f32>) -> Placed {
    let columns = obb.axes().map(|u| nalgebra::Vector3::new(u.x, u.y, u.z));
    let matrix = Rotation3::from_matrix_unchecked(Matrix3::from_columns(&columns));
    let turn = UnitQuaternion::from_rotation_matrix(&matrix);
    let q = Rotation::from_xyzw(turn.i, turn.j, turn.k, turn.w);
    let pose = Pose::from_parts(parry_vector(obb.center()), q);
    Placed { pose, cuboid: Cuboid::new(parry_vector(obb.half_extents())) }
}

/// The peer, in `f32`.
pub(crate) fn peer(course: &Course<Obb<f32>, Obb<f32>>, who: &str) -> Candidate {
    let parry3d = course.prepared("", |pairs| pairs.map(placed, placed));
    parry3d.candidate(who, Promise::Nothing, parry)
}

/// The 15 axes as published, in vectors of `f32`.
pub(crate) fn in_vectors(course: &Course<Obb<f32>, Obb<f32>>) -> Candidate {
    let vectors = course.prepared("", |pairs| pairs.map(Vectors::new, Vectors::new));
    vectors.candidate("15 axes, four wide", Promise::Nothing, gottschalk::overlap)
}

pub(crate) fn yardstick(scene: &Scene) -> Candidate {
    peer(&course(scene, &F32), "yardstick: parry3d")
}

pub fn run(session: &mut Session) {
    let all = groups();
    let mut race = |name: &str, scene: fn() -> Scene| session.measure(name, scene, yardstick, &all);
    race("box/box: turned, 50 % overlap", half);
    race("box/box: turned, 10 % overlap", scenes::tenth);
    // The cost of doubt.
    race("box/box: nearly parallel", scenes::nearly_parallel);
    race("box/box: stacked", scenes::stacked);
}
