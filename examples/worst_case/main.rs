//! The most instructions that a query takes on a small core, whatever it is asked.
//!
//! ```text
//! cargo run --release --example worst_case --target thumbv6m-none-eabi
//! .ci/worst-case            # all cores, held against docs/worst-case.csv
//! .ci/worst-case --write    # all cores, written there
//! ```
//!
//! In fixed point of up to 32 bits no loop's length depends on the numbers, and neither does the
//! time of an operation: how long a query takes depends on which way its branches go, and those
//! ask for signs. So shapes are drawn that meet in every way: in the interior, along edges and
//! at vertices, off by one unit, at the ends of the range, with rays whose range ends at the hit.
//! Each way to draw them is a path, and has a line with the most that it took:
//!
//! - `random`: near each other, at random
//! - `contact`: on a grid of five numbers
//! - `off by one`: the same, each coordinate moved by one unit or not
//! - `ends`: numbers from the ends of the range, and about zero
//! - `far`: at random over the whole range of the type
//!
//! Reach is `near` for shapes that were promised to be so (`septum::near`), and `any` for all
//! others. Floats and 64 bits end in exact sums, whose time does depend on the numbers: there a
//! line says what was found, and no more. So it does of sweeps and contacts, which end in exact
//! sums in every scalar.
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
const CORE: &str = if cfg!(target_abi = "eabihf") { "Cortex-M4F" } else { "Cortex-M0" };

/// Measures everything, a line for each path.
fn run() -> bool {
    let Some(meter) = Clock::new().map(Meter::new) else { return false };
    if !meter.counts() {
        say!("a host counts no instructions: run this for a board, with --target");
        return true;
    }
    say!("core,query,scalar,reach,path,instructions,stack");
    queries::near(&meter);
    queries::any::<I4F4>(&meter);
    queries::any::<I8F8>(&meter);
    queries::any::<I16F16>(&meter);
    queries::any::<I32F32>(&meter);
    queries::any::<f32>(&meter);
    queries::longer(&meter);
    true
}

program!(run);
