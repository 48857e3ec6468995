//! Hashes of the answers to a fixed stream of questions, one for each query and scalar. They are
//! the same on every machine; a hash that differs is marked.
//!
//! ```text
//! cargo run --release --example determinism
//! cargo run --release --example determinism --target thumbv6m-none-eabi
//! ```
//!
//! `.ci/hashes` runs it on all machines and compares them.
#![cfg_attr(any(target_os = "none", target_family = "wasm"), no_std, no_main)]

mod draw;
mod golden;
#[path = "../boards/program.rs"]
mod program;
mod stream;

use core::fmt::Write;
use core::sync::atomic::{AtomicBool, AtomicU32, Ordering};

use golden::table::SCALARS;
use golden::{Header, Row, is_asked, kept};
use program::{Line, program};
use stream::queries::ROWS;

/// The number of lines that the program prints: a header, the rows, a verdict.
const LINES: usize = ROWS.len() + 2;

/// The hashes, kept because lines are requested one at a time.
static HASHES: [[AtomicU32; SCALARS.len()]; ROWS.len()] =
    [const { [const { AtomicU32::new(0) }; SCALARS.len()] }; ROWS.len()];
static ARE_COMPUTED: AtomicBool = AtomicBool::new(false);

fn row(k: usize) -> Row<'static> {
    if !ARE_COMPUTED.load(Ordering::Relaxed) {
        for (scalar, (_, column)) in SCALARS.iter().enumerate() {
            let Some(column) = column else { continue };
            for (row, hash) in HASHES.iter().zip(column()) {
                row[scalar].store(hash, Ordering::Relaxed);
            }
        }
        ARE_COMPUTED.store(true, Ordering::Relaxed);
    }
    let cells = [0, 1, 2, 3, 4, 5].map(|scalar| HASHES[k][scalar].load(Ordering::Relaxed));
    Row { query: ROWS[k], cells }
}

/// Line `k`, and whether it is right.
fn line(k: usize) -> Line {
    let mut text = heapless::String::new();
    // The line has room for all of this text.
    let is_right = match k.checked_sub(1) {
        None => {
            let _ = write!(text, "{Header}");
            true
        }
        Some(k) if k < ROWS.len() => {
            let row = row(k);
            let _ = write!(text, "{row}");
            row.is_as_everywhere()
        }
        Some(_) => {
            let differing = (0..ROWS.len()).filter(|&k| !row(k).is_as_everywhere()).count();
            let lost = kept().filter(|kept| !ROWS.contains(&kept.query)).count();
            let scalars = (0..SCALARS.len()).filter(|&scalar| is_asked(scalar)).count();
            let _ = write!(text, "{} queries, {scalars} scalars: ", ROWS.len());
            let _ = match (differing, lost) {
                _ if scalars == 0 => write!(text, "NOT asked: --release asks all"),
                (0, 0) => write!(text, "as everywhere"),
                _ => write!(text, "NOT as everywhere: {differing} differ, {lost} are lost"),
            };
            scalars > 0 && (differing, lost) == (0, 0)
        }
    };
    (text, is_right)
}

program!(LINES, line);
