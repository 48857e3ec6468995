//! The cost of a query on a small core: instructions, and depth of the stack, for every scalar and
//! mode.
//!
//! ```text
//! cargo run --release --example measure --target thumbv6m-none-eabi
//! cargo run --release --example measure --target thumbv7em-none-eabihf
//! bash .ci/target-table > docs/target.csv     # all boards
//! ```
//!
//! Instructions are the average over the cases of a path, without the call. The board's timer
//! counts them, with equal time for each; they are not cycles. The stack is the greatest depth over
//! all cases, measured by painting the stack and finding the end of the paint. Paths:
//!
//! - `voorhies`: triangles with vertices in [−2, 2]³ against the unit cube around the origin, or a
//!   rotated one: the experiment of 2001
//! - `full`: the pairs among these that overlap, so that all 13 axes are tested
//! - `grid`: vertices and boxes on a grid of integers, contacts of every kind
//! - `whole range`: `full`, as wide as the numbers of the scalar
//! - `made`: a box from axes
//! - `hit`, `miss`: rays through triangles and boxes, and past them
//! - `teapot`: a mesh of 1,044 triangles, by its tree and one by one
//!
//! The mode `near` is of shapes checked to be near the origin (`septum::near`).
//!
//! A host counts no instructions. `benches/` measures times there.
#![cfg_attr(target_os = "none", no_std, no_main)]

#[path = "../boards/clock.rs"]
mod clock;
#[path = "../boards/firmware.rs"]
mod firmware;
mod mesh;
mod meter;
mod moving;
mod queries;
mod stack;
mod workload;

use fixed::types::{I4F4, I8F8, I16F16, I32F32};

use crate::clock::Clock;
use crate::firmware::{program, say};
use crate::meter::Meter;

/// The core that this is built for.
const CORE: &str = if cfg!(not(target_os = "none")) {
    "host"
} else if cfg!(target_arch = "riscv32") {
    "RV32IMC"
} else if cfg!(target_abi = "eabihf") {
    "Cortex-M4F"
} else if cfg!(target_has_atomic = "32") {
    "Cortex-M3"
} else {
    "Cortex-M0"
};

/// Measures everything, a line for each.
fn run() -> bool {
    let Some(meter) = Clock::new().map(Meter::new) else { return false };
    // A host in a build for development is not to compile what it does not measure.
    if cfg!(all(debug_assertions, not(target_os = "none"))) || !meter.counts() {
        say!("a host counts no instructions: run this for a board, with --target");
        return true;
    }
    say!("core,query,scalar,mode,path,instructions,stack");
    queries::all::<f32>(&meter);
    queries::all::<f64>(&meter);
    queries::all::<I4F4>(&meter);
    queries::all::<I8F8>(&meter);
    queries::all::<I16F16>(&meter);
    queries::all::<I32F32>(&meter);
    queries::distances::<I16F16>(&meter);
    queries::near(&meter);
    queries::orders::<f32>(&meter);
    queries::orders::<I16F16>(&meter);
    mesh::all(&meter)
}

program!(run);
