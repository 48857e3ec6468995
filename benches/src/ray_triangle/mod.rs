//! Ray against triangle; the yardstick is Möller–Trumbore as in C, in `f32`.

mod lanes;
mod naive;
mod ours;
mod peers;
mod rounded;
mod scenes;

use fixed::types::I16F16;
use septum::Scalar;

use crate::session::{Group, Session};
use crate::unit::{F32, F64, I8F8_15, I16F16_18, I16F16_26, I32F32_34, Unit};

use naive::yardstick;
use scenes::Scene;

/// All methods in one scalar.
fn group<S: Scalar>(unit: Unit<S>) -> Group<Scene> {
    let all = move |scene: &Scene| {
        let mut candidates = ours::ours(scene, &unit);
        candidates.extend(rounded::rounded(scene, &unit));
        candidates
    };
    (unit.name, Box::new(all))
}

/// The same, and what a user would have typed in.
fn with_naive(unit: Unit<I16F16>) -> Group<Scene> {
    let (name, ours) = group(unit);
    let all = move |scene: &Scene| {
        let mut candidates = ours(scene);
        candidates.push(naive::wrapping(scene, &unit));
        candidates
    };
    (name, Box::new(all))
}

fn lanes<S: Scalar>(unit: Unit<S>) -> Group<Scene> {
    (unit.name, Box::new(move |scene| lanes::lanes(scene, &unit)))
}

fn peers() -> Group<Scene> {
    let all = |scene: &Scene| {
        let mut candidates = peers::peers(scene);
        candidates.push(rounded::distance_only(scene));
        candidates
    };
    ("f32 parry3d obvhs bvh", Box::new(all))
}

pub fn run(session: &mut Session) {
    let mut all = vec![
        group(F32),
        peers(),
        group(F64),
        group(I8F8_15),
        with_naive(I16F16_18),
        with_naive(I16F16_26),
        group(I32F32_34),
    ];
    let mut race = |name: &str, scene, all: &[_]| session.measure(name, scene, yardstick, all);
    race("ray/triangle: pairs, 50 % hits", scenes::half_hit, &all);
    race("ray/triangle: pairs, 10 % hits", scenes::tenth_hit, &all);
    // What doubt costs.
    race("ray/triangle: aimed at edges", scenes::edges, &all);
    race("ray/triangle: integer grid", scenes::grid, &all);
    race("ray/triangle: nearly parallel", scenes::near_parallel, &all);
    all.extend([lanes(F32), lanes(F64), lanes(I16F16_18)]);
    race("ray/triangle: one against 1,000, 50 % hits", scenes::many_half_hit, &all);
    race("ray/triangle: one against 1,000, 10 % hits", scenes::many_tenth_hit, &all);
}
