//! Ray against box; the yardstick is parry3d. Rays are prepared before the clock
//! starts, ours and the peers' alike.

mod lanes;
mod ours;
mod peers;
pub(crate) mod scenes;

use septum::Scalar;

use crate::session::{Group, Session};
use crate::unit::{F32, F64, Form, I8F8_15, I16F16_18, I16F16_26, I32F32_34, Unit};

pub(crate) use lanes::lanes;
pub(crate) use ours::{course, ours, segments, yardstick as as_published};
pub(crate) use peers::{parry_cast, peers, yardstick};
use scenes::Scene;

fn group<S: Scalar>(unit: Unit<S>, form: Form) -> Group<Scene> {
    (
        unit.name,
        Box::new(move |scene| ours(&course(scene, &unit, form), &segments(scene, &unit, form))),
    )
}

fn lanes_in<S: Scalar>(unit: Unit<S>) -> Group<Scene> {
    (unit.name, Box::new(move |scene| lanes(&course(scene, &unit, Form::Corners))))
}

/// All candidates.
pub(crate) fn groups() -> Vec<Group<Scene>> {
    vec![
        group(F32, Form::Corners),
        group(F32, Form::Center),
        ("f32 parry3d obvhs bvh", Box::new(|scene| peers(&course(scene, &F32, Form::Corners)))),
        group(F64, Form::Corners),
        group(I8F8_15, Form::Corners),
        group(I16F16_18, Form::Corners),
        group(I16F16_26, Form::Corners),
        group(I32F32_34, Form::Corners),
        lanes_in(F32),
        lanes_in(F64),
        lanes_in(I16F16_18),
    ]
}

pub fn run(session: &mut Session) {
    let all = groups();
    session.measure("ray/box: 50 % hits", scenes::half_hit, yardstick, &all);
    session.measure("ray/box: 10 % hits", scenes::tenth_hit, yardstick, &all);
    session.measure("ray/box: grid, in contact", scenes::grid, yardstick, &all);
}
