//! How far questions climb: as far as ever.
//!
//! A bound that is too wide gives no wrong answer, and no hash of answers shows it: it
//! sends questions to dearer arithmetic. How many go there is a matter of bits, and the
//! same on every machine. Who changes a bound or a ladder measures its price, and then
//! writes down the new numbers.

extern crate std;

use core::cell::Cell;

use fixed::types::{I4F4, I8F8, I16F16, I32F32};

use super::integer::REGISTERS_ARE_WIDE;
use super::ladder::FEW_RUNGS;
use super::tally::Step;

#[path = "../../examples/determinism/draw.rs"]
mod draw;
#[path = "../../examples/determinism/stream.rs"]
mod stream;

std::thread_local! {
    static STEPS: Cell<[u32; 4]> = const { Cell::new([0; 4]) };
}

pub(super) fn add(step: Step) {
    let mut steps = STEPS.get();
    steps[step as usize] += 1;
    STEPS.set(steps);
}

/// Past the first rung for numbers, a rung, a rung for narrow registers; at the end.
fn steps<S: draw::Draw>() -> [u32; 4] {
    STEPS.set([0; 4]);
    stream::hash::<S>(stream::CASES / 4);
    STEPS.get()
}

/// Where registers are wide, and where they are narrow.
fn check<S: draw::Draw>(wide: [u32; 4], narrow: [u32; 4]) {
    // Short ladders have other steps.
    if !FEW_RUNGS {
        assert_eq!(steps::<S>(), if REGISTERS_ARE_WIDE { wide } else { narrow });
    }
}

#[test]
fn f32_climbs_as_far_as_it_did() {
    check::<f32>([688, 13185, 0, 3407], [0, 14776, 0, 3407]);
}
#[test]
fn f64_climbs_as_far_as_it_did() {
    check::<f64>([1023, 13524, 0, 6445], [1023, 13524, 0, 6445]);
}
#[test]
fn i4f4_climbs_as_far_as_it_did() {
    check::<I4F4>([215, 0, 0, 0], [0, 0, 15776, 0]);
}
#[test]
fn i8f8_climbs_as_far_as_it_did() {
    check::<I8F8>([201, 0, 0, 0], [0, 0, 15753, 0]);
}
#[test]
fn i16f16_climbs_as_far_as_it_did() {
    check::<I16F16>([236, 10158, 0, 84], [0, 5356, 32102, 5356]);
}
#[test]
fn i32f32_climbs_as_far_as_it_did() {
    check::<I32F32>([0, 5776, 0, 5776], [0, 5436, 15663, 5436]);
}
