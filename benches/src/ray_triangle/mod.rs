//! Ray against triangle; the yardstick is Möller–Trumbore as in C, in `f32`.

mod lanes;
mod naive;
mod ours;
mod peers;
mod rounded;
pub(crate) mod scenes;

use fixed::types::I16F16;
use septum::Scalar;

use crate::native;
use crate::session::{Group, Session};
use crate::unit::{F32, F64, I8F8_15, I16F16_18, I16F16_26, I32F32_34, Unit};

pub(crate) use naive::{in_floats, wrapping, yardstick};
pub(crate) use ours::{course, ours};
pub(crate) use peers::{culling, peers};
pub(crate) use rounded::{distance_only, rounded};
use scenes::Scene;

/// All methods in one scalar.
fn group<S: Scalar>(unit: Unit<S>) -> Group<Scene> {
    let all = move |scene: &Scene| {
        let course = course(scene, &unit);
        let mut candidates = ours(&course);
        candidates.extend(rounded(&course));
        candidates
    };
    (unit.name, Box::new(all))
}

/// The same methods, and the naive implementation.
fn with_naive(unit: Unit<I16F16>) -> Group<Scene> {
    let (name, all) = group(unit);
    let with = move |scene: &Scene| {
        let mut candidates = all(scene);
        candidates.push(wrapping(&course(scene, &unit)));
        candidates
    };
    (name, Box::new(with))
}

fn lanes<S: Scalar>(unit: Unit<S>) -> Group<Scene> {
    (unit.name, Box::new(move |scene| lanes::lanes(&course(scene, &unit))))
}

fn with_peers() -> Group<Scene> {
    let all = |scene: &Scene| {
        let plain = course(scene, &F32);
        let mut candidates = peers(&plain, &culling(scene));
        candidates.extend(native::rays(&plain));
        candidates.push(distance_only(&plain));
        candidates
    };
    ("f32 parry3d obvhs bvh Jolt", Box::new(all))
}

/// All candidates that take one triangle at a time.
pub(crate) fn groups() -> Vec<Group<Scene>> {
    vec![
        group(F32),
        with_peers(),
        group(F64),
        group(I8F8_15),
        with_naive(I16F16_18),
        with_naive(I16F16_26),
        group(I32F32_34),
    ]
}

/// The candidates that take eight triangles.
pub(crate) fn groups_of_lanes() -> [Group<Scene>; 3] {
    [lanes(F32), lanes(F64), lanes(I16F16_18)]
}

pub fn run(session: &mut Session) {
    let mut all = groups();
    let mut race =
        |name: &str, scene: fn() -> Scene, all: &[_]| session.measure(name, scene, yardstick, all);
    race("ray/triangle: pairs, 50 % hits", scenes::half_hit, &all);
    race("ray/triangle: pairs, 10 % hits", scenes::tenth_hit, &all);
    // The cost of doubt.
    race("ray/triangle: aimed at edges", scenes::edges, &all);
    race("ray/triangle: integer grid", scenes::grid, &all);
    race("ray/triangle: nearly parallel", scenes::near_parallel, &all);
    all.extend(groups_of_lanes());
    race("ray/triangle: one against 1,000, 50 % hits", scenes::many_half_hit, &all);
    race("ray/triangle: one against 1,000, 10 % hits", scenes::many_tenth_hit, &all);
}
