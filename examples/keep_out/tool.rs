//! The tool and its path, in fixed point throughout.

use fixed::types::I16F16;
use septum::{Obb, Vec3};

/// The number of steps along the path.
pub(crate) const STEPS: u32 = 32;

/// Half-extents of the tool along its own axes. It is a drill.
const HALF: [I16F16; 3] = [I16F16::lit("0.125"), I16F16::lit("1.5"), I16F16::lit("0.125")];

const START: [I16F16; 3] = [I16F16::lit("-7"), I16F16::lit("7"), I16F16::lit("3")];
const END: [I16F16; 3] = [I16F16::lit("5"), I16F16::lit("1.5"), I16F16::lit("-1")];

/// The tool at a step. It moves from start to end, and turns by 45 degrees on the
/// way.
pub(crate) fn at(step: u32) -> Option<Obb<I16F16>> {
    let one = I16F16::ONE;
    let way = I16F16::from_num(step) / I16F16::from_num(STEPS);
    let mut center = START;
    for (at, end) in center.iter_mut().zip(END) {
        *at += (end - *at) * way;
    }
    // A rotation about z without trigonometry. The tangent of half the angle is h.
    let h = way * I16F16::lit("0.41421");
    let (cos, sin) = ((one - h * h) / (one + h * h), (h + h) / (one + h * h));
    let zero = I16F16::ZERO;
    let axes = [[cos, sin, zero], [-sin, cos, zero], [zero, zero, one]];
    Obb::new(center, axes.map(Vec3::from), HALF).ok()
}
