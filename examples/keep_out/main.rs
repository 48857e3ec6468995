//! A tool that must keep out of a mesh: does it touch, where first, and what?
//!
//! The mesh lies in flash as a `const` table of I16F16, the tool is an oriented
//! box that moves and turns. Every verdict is exact, and the same here as on a
//! workstation.
//!
//! ```text
//! cargo run --release --example keep_out --target thumbv6m-none-eabi
//! cargo run --release --example keep_out
//! ```
//!
//! The table was made by
//! `cargo run --release --example quantise > examples/keep_out/teapot.rs`.
#![cfg_attr(target_os = "none", no_std, no_main)]

#[path = "../boards/clock.rs"]
mod clock;
#[path = "../boards/firmware.rs"]
mod firmware;
#[rustfmt::skip]
mod teapot;
mod tool;

use clock::Clock;
use fixed::types::I16F16;
use septum::{Aabb, Bounded, Obb, Triangle, Vec3};
use teapot::{FACES, VERTICES};

use crate::firmware::{program, say};

/// How many touched triangles are told by name.
const ROOM: usize = 4;

fn vertex(i: u16) -> Vec3<I16F16> {
    VERTICES[usize::from(i)]
}

/// Which faces of the mesh the tool touches; most are not even near.
fn touched_by(tool: &Obb<I16F16>, around: &Aabb<I16F16>) -> Bounded<u16, ROOM> {
    let is_touched = |&i: &u16| {
        let [a, b, c] = FACES[usize::from(i)];
        Triangle::new(vertex(a), vertex(b), vertex(c))
            .is_ok_and(|t| t.overlaps(around) && t.overlaps(tool))
    };
    (0..FACES.len() as u16).filter(is_touched).collect()
}

/// Moves the tool along its path.
fn run() -> bool {
    let Some(clock) = Clock::new() else { return false };
    say!("keep-out mesh: {} triangles", FACES.len());
    let (mut first, mut queries, mut instructions) = (None, 0, Some(0));
    for step in 0..tool::STEPS {
        let Some(tool) = tool::at(step) else { return false };
        let Some(around) = tool::bounds(&tool) else { return false };
        let (touched, count) = clock.count(|| touched_by(&tool, &around));
        queries += FACES.len() as u64;
        instructions = instructions.zip(count).map(|(sum, count)| sum + count);
        if touched.total() > 0 {
            if first.is_none() {
                say!("first contact at step {} of {}, {:?}", step, tool::STEPS, tool);
                first = Some(step);
            }
            say!("step {}: touches {:?}", step, touched);
        }
    }
    if let Some(per_million) = instructions.and_then(|n| (queries * 1_000_000).checked_div(n)) {
        say!("{} queries, {} per million instructions", queries, per_million);
    }
    first.is_some()
}

program!(run);
