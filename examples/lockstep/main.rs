//! Lockstep: two peers run the same world from the same inputs. They send each other
//! inputs and hashes, never the world.
//!
//! Boxes fall, turn, stack and rest on a terrain of triangles, using septum's broad phase, contacts
//! and sweeps. All numbers are I16F16, or `f32` by an option; the players turn by the sines and
//! cosines of the crate `cordic`. Each peer knows its own input at once, and the remote input five
//! ticks later. Until then it predicts the remote input. If the prediction was wrong, it rolls back
//! and runs those ticks again. A sync test does so in each tick, and compares. The hash of each tick
//! is the same in both peers, on every machine. If one bit of one input is changed, the hashes differ
//! from that tick on. Last, a capsule walks stairs and a teapot: a character controller.
//!
//! ```text
//! cargo run --release --example lockstep
//! cargo run --release --example lockstep -- --crowd     # 200 boxes, and what a frame takes
//! cargo run --release --example lockstep -- --floats
//! cargo run --release --example lockstep --target thumbv6m-none-eabi
//! ```
#![cfg_attr(any(target_os = "none", target_family = "wasm"), no_std, no_main)]

mod body;
mod game;
mod matches;
mod number;
#[cfg(not(any(target_os = "none", target_family = "wasm", target_endian = "big", septum_bare)))]
mod options;
#[path = "../boards/program.rs"]
mod program;
mod saves;
mod session;
mod solver;
#[rustfmt::skip]
#[allow(dead_code, reason = "its tree is for others")]
#[path = "../assets/teapot.rs"]
mod teapot;
mod terrain;
mod vector;
mod walker;
mod walks;

use fixed::types::I16F16;

use number::Number;
use program::{Line, program};
use terrain::{Ground, with_ground};

/// The hash of the last tick, the same on every machine.
const LAST: u64 = 0x08b5_bc7b_579c_4bf2;
const LAST_IN_F32: u64 = 0x41f4_055f_5b33_618e;

/// The frames that the sync test goes back, unless an option says otherwise.
const BACK: usize = 2;

/// The lines about a world in one type of numbers.
const LINES: usize = 3;

fn line_in<T: Number>(k: usize, name: &str, last: u64, back: usize) -> Line {
    let on = |ground: &Ground<'_, T>| match k {
        0 => matches::checksums(ground, name, last),
        1 => matches::peers(ground, back),
        _ => matches::one_bit(ground),
    };
    with_ground(on).unwrap_or_default()
}

/// Lines in all: also the hashes in `f32`, and two walks.
const ALL: usize = LINES + 3;

/// In I16F16; then the hashes in `f32`, and the walks of a capsule.
fn fixed_point(k: usize, back: usize) -> Line {
    if k < LINES {
        line_in::<I16F16>(k, "I16F16", LAST, back)
    } else if k == LINES {
        line_in::<f32>(0, "f32", LAST_IN_F32, back)
    } else {
        walks::line(k - LINES - 1)
    }
}

/// Other machines have no options.
#[cfg(any(target_os = "none", target_family = "wasm", target_endian = "big", septum_bare))]
mod options {
    use super::{ALL, BACK, Line, fixed_point};

    pub(crate) fn lines() -> usize {
        ALL
    }

    pub(crate) fn line(k: usize) -> Line {
        fixed_point(k, BACK)
    }
}

program!(options::lines(), options::line);
