//! A tool that must keep out of a mesh: is it outside, in contact, or wholly inside?
//!
//! The mesh lies in flash as a table of I16F16, with a tree over each part. The tool is an
//! oriented box that moves and turns. Every verdict is exact, and the same on every machine.
//!
//! No contact is not yet outside. The check therefore also asks what is inside, and
//! only a closed mesh has an inside. The bundled teapot is open: its body,
//! handle, spout and lid each end in a hole. `quantise --close` fills the holes,
//! and checks that no edge is left open.
//!
//! ```text
//! cargo run --release --example keep_out --target thumbv6m-none-eabi
//! cargo run --release --example keep_out
//! ```
//!
//! This made the table:
//!
//! ```text
//! cargo run --release --example quantise -- --close > examples/keep_out/teapot.rs
//! ```
#![cfg_attr(target_os = "none", no_std, no_main)]

mod check;
#[path = "../boards/clock.rs"]
mod clock;
#[path = "../boards/firmware.rs"]
mod firmware;
#[rustfmt::skip]
mod teapot;
mod tool;

use check::{Place, Zone};
use clock::Clock;
use fixed::types::I16F16;
use septum::Vec3;
use teapot::{FACES, PARTS};

use crate::firmware::{program, say};

/// The raw bits of a vector. They read back as they are; decimal digits need not.
fn bits(v: Vec3<I16F16>) -> [i32; 3] {
    v.to_array().map(I16F16::to_bits)
}

/// Moves the tool along its path, from outside the mesh to its inside.
fn run() -> bool {
    let Some(clock) = Clock::new() else { return false };
    let (zone, count) = clock.count(Zone::new);
    let Some(zone) = zone else { return false };
    say!("keep-out mesh: {} triangles, {} closed parts", FACES.len(), PARTS.len());
    if let Some(count) = count {
        say!("its table is sound: {} instructions to see", count);
    }
    let (mut first, mut was_inside, mut instructions) = (None, false, Some(0));
    for step in 0..tool::STEPS {
        let Some(tool) = tool::at(step) else { return false };
        let (place, count) = clock.count(|| zone.place(&tool));
        instructions = instructions.zip(count).map(|(sum, count)| sum + count);
        match place {
            Place::Outside => say!("step {}: outside", step),
            Place::Touches(faces) => {
                if first.is_none() {
                    say!("first contact at step {} of {}, in raw bits:", step, tool::STEPS);
                    let axes = tool.axes().map(bits);
                    let (center, half) = (bits(tool.center()), bits(tool.half_extents()));
                    say!("center {:?} axes {:?} half-extents {:?}", center, axes, half);
                    first = Some(step);
                }
                let (named, others) = (faces.kept(), faces.missed());
                say!("step {}: touches {:?} and {} more", step, named, others);
            }
            Place::Inside(part) => {
                say!("step {}: wholly inside part {}", step, part);
                was_inside = true;
            }
        }
    }
    if let Some(each) = instructions.and_then(|n: u64| n.checked_div(u64::from(tool::STEPS))) {
        say!("{} checks, {} instructions each on average", tool::STEPS, each);
    }
    first.is_some() && was_inside
}

program!(run);
