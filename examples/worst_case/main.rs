//! The most instructions that a query takes on a small core, over all inputs.
//!
//! ```text
//! cargo run --release --example worst_case --target thumbv6m-none-eabi
//! .ci/worst-case --all      # all cores, held against docs/worst-case.csv
//! .ci/worst-case --write    # all cores, written there
//! ```
//!
//! In fixed point of up to 32 bits no loop's length and no operation's time depends on the numbers,
//! so the time of a query depends only on its branches, and these depend on signs. So the shapes
//! meet in every way: in the interior, along edges and at vertices, off by one unit, at the ends of
//! the range, with rays whose range ends at the hit. Each way to draw them is a path, with a line
//! for the most instructions:
//!
//! - `random`: near each other, at random
//! - `contact`: on a grid of five numbers
//! - `off by one`: the same, with each coordinate moved by one unit or not
//! - `ends`: numbers from the ends of the range, and about zero
//! - `far`: at random over the whole range of the type
//!
//! Reach is `near` for shapes checked to be near the origin (`septum::near`), and `any` for all
//! shapes. Floats, 64 bits, sweeps and contacts end in exact sums, whose time does depend on the
//! numbers: their lines show the most that was found, which is not a bound.
#![cfg_attr(target_os = "none", no_std, no_main)]

mod cases;
#[path = "../boards/clock.rs"]
mod clock;
mod draw;
#[path = "../boards/firmware.rs"]
mod firmware;
#[path = "../measure/meter.rs"]
mod meter;
mod queries;
#[path = "../measure/stack.rs"]
mod stack;

use fixed::types::{I4F4, I8F8, I16F16, I32F32};

use crate::clock::Clock;
use crate::firmware::{program, say};
use crate::meter::Meter;

/// The core that this is built for.
const CORE: &str = if cfg!(target_arch = "riscv32") {
    "RV32IMC"
} else if cfg!(target_abi = "eabihf") {
    "Cortex-M4F"
} else {
    "Cortex-M0"
};

/// Measures everything, a line for each path.
fn run() -> bool {
    let Some(meter) = Clock::new().map(Meter::new) else { return false };
    // A host is not to compile what it does not measure.
    if cfg!(not(target_os = "none")) || !meter.counts() {
        say!("a host counts no instructions: run this for a board, with --target");
        return true;
    }
    say!("core,query,scalar,reach,path,instructions,stack");
    queries::near(&meter);
    if const { option_env!("WITHOUT_SMALL_SCALARS").is_none() } {
        queries::any::<I4F4>(&meter);
        queries::any::<I8F8>(&meter);
    }
    queries::any::<I16F16>(&meter);
    queries::any::<I32F32>(&meter);
    queries::any::<f32>(&meter);
    queries::longer(&meter);
    true
}

program!(run);
