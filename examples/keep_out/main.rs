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
//! Without a file it checks the two bundled programs. The table was made by:
//!
//! ```text
//! cargo run --release --example quantise -- examples/keep_out/clamps.obj --whole \
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
mod tool;

use check::{Place, Zone};
use clamps::FACES;
use clock::Clock;
use gcode::{Fault, Move, Position, Program};

use crate::firmware::{program, say};

/// The bundled programs, and their expected results.
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
    say!("clamps: {} triangles", FACES.len());
    if let Some(count) = count {
        say!("their table is sound: {} instructions to see", count);
    }
    let mut taken = Taken::default();
    let is_done = each_program(|name, text| match check(&zone, &clock, &mut taken, name, text) {
        Ok(()) => true,
        Err(Fault { line, at, what }) => {
            say!("{}: line {}: {}: {}", name, line, at, what);
            false
        }
    });
    if taken.sum > 0 {
        let each = taken.sum / taken.checks;
        let Taken { checks, most, late, .. } = taken;
        say!("{} checks, {} instructions each, {} at most", checks, each, most);
        say!("checks of more than 16000 instructions: {}", late);
    }
    is_done
}

/// Checks the bundled programs, or the given file.
fn each_program(mut check: impl FnMut(&str, &str) -> bool) -> bool {
    #[cfg(not(target_os = "none"))]
    if let Some(path) = std::env::args().nth(1) {
        return match std::fs::read_to_string(&path) {
            Ok(text) => check(&path, &text),
            Err(error) => {
                say!("{}: {}", path, error);
                false
            }
        };
    }
    let mut is_done = true;
    for (name, text) in BUNDLED {
        is_done &= check(name, text);
    }
    is_done
}

/// Checks the moves of a program, and prints where contact begins and ends.
fn check(
    zone: &Zone,
    clock: &Clock,
    taken: &mut Taken,
    name: &str,
    text: &str,
) -> Result<(), Fault> {
    let (mut moves, mut poses, mut place) = (0_u32, 0_u32, Place::Outside);
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
        }
    }
    let end = match place {
        Place::Outside => "outside",
        Place::Touches(_) => "in contact",
        Place::Inside => "inside a clamp",
    };
    say!("{}: {} moves, {} poses; it ends {}", name, moves, poses, end);
    Ok(())
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
