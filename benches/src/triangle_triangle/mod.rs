//! Triangle against triangle; the yardstick is the test by 11 axes, in `f32`.

mod candidates;
mod guigue_devillers;
mod scenes;

use septum::Scalar;

use crate::session::{Group, Session};
use crate::unit::{F32, F64, I8F8_15, I16F16_18, I16F16_26, I32F32_34, Unit};

use candidates::course;
pub(crate) use candidates::{by_axes, by_volumes, ours, peers, yardstick};
use guigue_devillers::Real;
pub(crate) use scenes::{Scene, half};

fn group<S: Scalar>(unit: Unit<S>) -> Group<Scene> {
    (unit.name, Box::new(move |scene: &Scene| ours(&course(scene, &unit))))
}

/// In floats, and beside Guigue and Devillers.
fn float_group<S: Scalar + Real>(unit: Unit<S>) -> Group<Scene> {
    let all = move |scene: &Scene| {
        let course = course(scene, &unit);
        ours(&course).into_iter().chain([by_volumes(&course)]).collect()
    };
    (unit.name, Box::new(all))
}

pub(crate) fn groups() -> Vec<Group<Scene>> {
    vec![
        float_group(F32),
        ("f32 parry3d", Box::new(|scene: &Scene| peers(&course(scene, &F32))) as _),
        float_group(F64),
        group(I8F8_15),
        group(I16F16_18),
        group(I16F16_26),
        group(I32F32_34),
    ]
}

pub fn run(session: &mut Session) {
    let all = groups();
    let mut race = |name: &str, scene: fn() -> Scene| session.measure(name, scene, yardstick, &all);
    race("triangle/triangle: two teapots", scenes::teapots);
    race("triangle/triangle: pairs, 50 % overlap", half);
    race("triangle/triangle: pairs, 10 % overlap", scenes::tenth);
    // The cost of doubt.
    race("triangle/triangle: neighbours in the teapot", scenes::neighbours);
    race("triangle/triangle: integer grid", scenes::grid);
    race("triangle/triangle: in one plane", scenes::plane);
}
