//! The tool as an oriented box, and its poses along a move, in fixed point throughout.

use fixed::types::I16F16;
use septum::Obb;

use super::gcode::{Move, Position};

/// Half-extents of the box: a cutter of 6 mm, 40 mm long, and a clearance of 2 mm.
///
/// From one pose to the next the tip moves by up to √3 mm, and the tool turns by up to 1° about two
/// axes, which moves its far end by another 1.1 mm. Every point of the tool stays within half of
/// that from a pose, and the clearance is larger, so the motion between poses is covered.
pub(crate) const HALF: [I16F16; 3] = [I16F16::lit("5"), I16F16::lit("5"), I16F16::lit("22")];

/// The position of the tool before a program.
pub(crate) const HOME: Position =
    Position { tip: [I16F16::ZERO, I16F16::ZERO, I16F16::lit("120")], tilt: [I16F16::ZERO; 2] };

/// The poses along a move, from its beginning to its end: one for each millimetre and degree.
pub(crate) fn poses(line: Move) -> impl Iterator<Item = Position> {
    let numbers = |p: Position| {
        let ([x, y, z], [a, b]) = (p.tip, p.tilt);
        [x, y, z, a, b].map(|x| i64::from(x.to_bits()))
    };
    let (from, to) = (numbers(line.from), numbers(line.to));
    let farthest = from.iter().zip(to).map(|(from, to)| from.abs_diff(to)).max().unwrap_or(0);
    let steps = farthest.div_ceil(1 << I16F16::FRAC_NBITS) as i64;
    (0..=steps).map(move |step| {
        let [x, y, z, a, b] = [0, 1, 2, 3, 4].map(|i| {
            // A number between two 32-bit numbers fits in 32 bits.
            let way = (to[i] - from[i]) * step;
            I16F16::from_bits((from[i] + way.checked_div(steps).unwrap_or(0)) as i32)
        });
        Position { tip: [x, y, z], tilt: [a, b] }
    })
}

/// The box of a tool: its lower end surrounds the tip, and its long axis is tilted about x and then
/// about y. `None` if a number is out of the type's range.
pub(crate) fn obb(at: Position) -> Option<Obb<I16F16>> {
    let [a, b] = at.tilt.map(|degrees| degrees / 360);
    let upright = Obb::from_turns([I16F16::ZERO; 3], [a, b, I16F16::ZERO], HALF).ok()?;
    // From the tip to the centre, without the clearance below.
    let up = HALF[2] - I16F16::lit("2");
    let [tip, axis] = [at.tip, upright.axes()[2].to_array()];
    let mut center = tip;
    for (to, along) in center.iter_mut().zip(axis) {
        *to = to.checked_add(along * up)?;
    }
    Obb::new(center, *upright.axes(), HALF).ok()
}
