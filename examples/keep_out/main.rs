//! A mill's tool must keep out of the clamps. Does a program move it into one, and where?
//!
//! The input is G-code. The output is each move on which the tool first touches a clamp, with its
//! line number. The tool is an oriented box that moves and tilts; the clamps are closed meshes in
//! flash, in I16F16, with a tree over them. Every verdict is exact, and the same on every machine.
//!
//! A tool without contact may still be entirely inside a clamp; the check detects this too.
//!
//! ```text
//! cargo run --release --example keep_out --target thumbv6m-none-eabi
//! cargo run --release --example keep_out
//! cargo run --release --example keep_out -- PROGRAM.nc
//! ```
//!
//! It exits with 1 if the tool touches a clamp. Without a file it checks the two bundled programs,
//! and succeeds if both touch one. The table was made by:
//!
//! ```text
//! cargo quantise examples/keep_out/clamps.obj --whole \
//!     > examples/keep_out/clamps.rs
//! ```
#![cfg_attr(target_os = "none", no_std, no_main)]

mod check;
#[rustfmt::skip]
mod clamps;
#[path = "../boards/clock.rs"]
mod clock;
#[path = "../boards/firmware.rs"]
mod firmware;
mod gcode;
#[cfg(not(target_os = "none"))]
mod host;
mod tool;

use check::{Place, Zone};
use clamps::FACES;
use clock::Clock;
use gcode::{Fault, Move, Position, Program};

use crate::firmware::{program, say};

/// The bundled programs. In both the tool touches a clamp.
const BUNDLED: [(&str, &str); 2] = [
    ("facing.nc", include_str!("programs/facing.nc")),
    ("plunge.nc", include_str!("programs/plunge.nc")),
];

/// Instructions of the checks, where they are counted.
#[derive(Default)]
struct Taken {
    checks: u64,
    sum: u64,
    most: u64,
    /// The number of checks that took longer than a millisecond at 16 MHz, with one cycle for each
    /// instruction.
    late: u64,
}

fn run() -> bool {
    let Some(clock) = Clock::new() else { return false };
    let (zone, count) = clock.count(Zone::new);
    let Some(zone) = zone else { return false };
    #[cfg(not(target_os = "none"))]
    if let Some(code) = host::run(&zone, &clock, &mut Taken::default()) {
        std::process::exit(code);
    }
    say!("clamps: {} triangles", FACES.len());
    if let Some(count) = count {
        say!("their table is sound: {} instructions to see", count);
    }
    let mut taken = Taken::default();
    let mut is_as_known = true;
    for (name, text) in BUNDLED {
        is_as_known &= try_check(&zone, &clock, &mut taken, name, text) == Some(true);
    }
    if taken.sum > 0 {
        let each = taken.sum / taken.checks;
        let Taken { checks, most, late, .. } = taken;
        say!("{} checks, {} instructions each, {} at most", checks, each, most);
        say!("checks of more than 16000 instructions: {}", late);
    }
    is_as_known
}

/// Whether the tool touches a clamp in a program; `None` after an error, which it prints.
fn try_check(
    zone: &Zone,
    clock: &Clock,
    taken: &mut Taken,
    name: &str,
    text: &str,
) -> Option<bool> {
    match check(zone, clock, taken, name, text) {
        Ok(touches) => Some(touches),
        Err(Fault { line, at, what }) => {
            say!("{}: line {}: {}: {}", name, line, at, what);
            None
        }
    }
}

/// Checks the moves of a program, and prints where contact begins and ends. Returns whether there is
/// contact.
fn check(
    zone: &Zone,
    clock: &Clock,
    taken: &mut Taken,
    name: &str,
    text: &str,
) -> Result<bool, Fault> {
    let (mut moves, mut poses, mut place) = (0_u32, 0_u32, Place::Outside);
    let mut touches = false;
    for line in Program::new(text, tool::HOME) {
        let line @ Move { line: number, .. } = line?;
        moves += 1;
        for (step, at) in tool::poses(line).enumerate() {
            let obb = tool::obb(at);
            let obb = obb.ok_or(Fault { line: number, at: 'G', what: "that is too far" })?;
            let (now, count) = clock.count(|| zone.place(&obb));
            poses += 1;
            if let Some(count) = count {
                taken.checks += 1;
                taken.sum += count;
                taken.most = taken.most.max(count);
                taken.late += u64::from(count > 16_000);
            }
            tell(name, number, step as u32, at, [place, now]);
            place = now;
            touches |= now != Place::Outside;
        }
    }
    let end = match place {
        Place::Outside => "outside",
        Place::Touches(_) => "in contact",
        Place::Inside => "inside a clamp",
    };
    say!("{}: {} moves, {} poses; it ends {}", name, moves, poses, end);
    Ok(touches)
}

/// Prints a change, with the tip in micrometres.
fn tell(name: &str, line: u32, pose: u32, at: Position, [before, now]: [Place; 2]) {
    let tip = at.tip.map(|x| ((i64::from(x.to_bits()) * 1000) >> 16) as i32);
    match (before, now) {
        (Place::Outside | Place::Inside, Place::Touches(face)) => {
            say!("{}: line {}, pose {}: touches face {}, tip {:?}", name, line, pose, face, tip);
        }
        (Place::Outside | Place::Touches(_), Place::Inside) => {
            say!("{}: line {}, pose {}: inside a clamp, tip {:?}", name, line, pose, tip);
        }
        (Place::Touches(_) | Place::Inside, Place::Outside) => {
            say!("{}: line {}, pose {}: outside again, tip {:?}", name, line, pose, tip);
        }
        _ => {}
    }
}

program!(run);
