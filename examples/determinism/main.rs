//! Hashes of the answers to a fixed stream of questions, one for each scalar: the
//! same on every machine that there is, or it says which is not.
//!
//! ```text
//! cargo run --release --example determinism
//! cargo run --release --example determinism --target thumbv6m-none-eabi
//! ```
//!
//! `.ci/hashes` runs it on all machines and prints them side by side.
#![cfg_attr(any(target_os = "none", target_family = "wasm"), no_std, no_main)]

mod draw;
mod golden;
#[path = "../boards/program.rs"]
mod program;
mod stream;

use core::fmt::Write;

use golden::GOLDEN;
use program::{Line, program};

/// How many lines the program prints.
const LINES: usize = GOLDEN.len();

/// Line `k`, and whether the hash is what it should be.
fn line(k: usize) -> Line {
    let golden = &GOLDEN[k];
    let hash = (golden.compute)();
    let is_right = hash == golden.expected;
    let verdict = if is_right { "as everywhere" } else { "NOT as everywhere" };
    let mut text = heapless::String::new();
    // There is room for it.
    let _ = write!(text, "{:6} {hash:016x} {verdict}", golden.name);
    (text, is_right)
}

program!(LINES, line);
