//! Triangle against box; the yardstick is the test as published in 2001.

mod lanes;
pub(crate) mod mesh;
mod ours;
mod peers;
pub(crate) mod scenes;
mod voxels;

use fixed::types::I16F16;
use septum::Scalar;

use crate::candidate::Candidate;
use crate::session::{Group, Session};
use crate::unit::{F32, F64, Form, I8F8_15, I16F16_18, I16F16_26, I32F32_34, Unit};

pub use mesh::run as run_meshes;
pub(crate) use ours::{course, ours, yardstick};
pub(crate) use peers::peers as peers_on;
use scenes::Scene;

/// The scenes of contact extend to 16 rather than 2.
const I16F16_22: Unit<I16F16> = Unit { name: "I16F16, 22 bits", ..I16F16_18 };
/// Beyond the range of the first stage.
const I16F16_FULL: Unit<I16F16> = Unit { name: "I16F16, 32 bits", scale: 1024.0, ..I16F16_18 };

fn group<S: Scalar>(unit: Unit<S>, form: Form) -> Group<Scene> {
    (unit.name, Box::new(move |scene| ours(&course(scene, &unit, form))))
}

fn lanes_in<S: Scalar>(unit: Unit<S>) -> Group<Scene> {
    let lanes = move |scene: &Scene| {
        lanes::lanes(&course(scene, &unit, Form::Corners), &course(scene, &unit, Form::Center))
    };
    (unit.name, Box::new(lanes))
}

fn lanes_of_triangles_in<S: Scalar>(unit: Unit<S>) -> Group<Scene> {
    let lanes =
        move |scene: &Scene| lanes::lanes_of_triangles(&course(scene, &unit, Form::Corners));
    (unit.name, Box::new(lanes))
}

/// Every peer, in `f32`.
pub(crate) fn peers(scene: &Scene) -> Vec<Candidate> {
    peers_on(&course(scene, &F32, Form::Center), &course(scene, &F32, Form::Corners))
}

/// All candidates on random scenes.
pub(crate) fn groups() -> Vec<Group<Scene>> {
    let by_form = |form| {
        [
            group(F32, form),
            group(F64, form),
            group(I8F8_15, form),
            group(I16F16_18, form),
            group(I16F16_26, form),
            group(I32F32_34, form),
        ]
    };
    let mut all: Vec<_> = Form::ALL.into_iter().flat_map(by_form).collect();
    all.push(("f32 parry3d box3d-rust", Box::new(peers)));
    all
}

pub fn run(session: &mut Session) {
    let all = groups();
    session.measure("triangle/box: Voorhies", scenes::voorhies, yardstick, &all);
    session.measure("triangle/box: Voxel", scenes::voxel, yardstick, &all);

    let lanes = [lanes_in(F32), lanes_in(F64), lanes_in(I16F16_18), lanes_in(I16F16_26)];
    session.measure("triangle/box: Voxel, many boxes", scenes::many_boxes, yardstick, &lanes);
    let lanes =
        [lanes_of_triangles_in(F32), lanes_of_triangles_in(F64), lanes_of_triangles_in(I16F16_18)];
    session.measure("triangle/box: Voorhies, many triangles", scenes::voorhies, yardstick, &lanes);

    // The worst case: contact, which rounding cannot decide.
    let floats = |form| [group(F32, form), group(F64, form)];
    let fixed = |form| [group(I16F16_22, form), group(I16F16_FULL, form)];
    let mut contact: Vec<_> = Form::ALL.into_iter().flat_map(floats).collect();
    session.measure("triangle/box: Spread, in contact", scenes::spread, yardstick, &contact);
    contact.extend(Form::ALL.into_iter().flat_map(fixed));
    session.measure("triangle/box: Grid, in contact", scenes::grid, yardstick, &contact);
    session.measure("triangle/box: Walls, in contact", scenes::walls, yardstick, &contact);
}
