//! Rays down a tree over a mesh of 90,000 triangles; the yardstick is parry3d's.

mod candidates;
mod knot;
mod scenes;
mod trees;

use septum::Scalar;

use crate::session::{Group, Session};
use crate::unit::{F32, F64, I8F8_15, I16F16_18, I16F16_26, I32F32_34, Unit};

pub(crate) use candidates::{course, ours, peers, yardstick, yardstick_on};
pub use knot::{Aim, Point, knot, rays};
pub(crate) use scenes::{Scene, random, scene};
pub use trees::{Obvhs, builds, parry_mesh, tree};

fn group<S: Scalar>(unit: Unit<S>) -> Group<Scene> {
    (unit.name, Box::new(move |scene| ours(&course(scene, &unit))))
}

/// All candidates.
pub(crate) fn groups() -> Vec<Group<Scene>> {
    vec![
        group(F32),
        group(F64),
        group(I8F8_15),
        group(I16F16_18),
        group(I16F16_26),
        group(I32F32_34),
        ("f32 obvhs embree tinybvh", Box::new(|scene| peers(&course(scene, &F32)))),
    ]
}

pub fn run(session: &mut Session) {
    let all = groups();
    let mut race = |rays: &str, scene: fn() -> Scene| {
        let title = format!("ray/tree: knot of 90,000 triangles, first hit, {rays}");
        session.measure(&title, scene, yardstick, &all);
    };
    race("random rays", random);
    race("rays at vertices", scenes::at_vertices);
}
