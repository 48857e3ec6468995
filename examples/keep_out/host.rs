//! The command line: programs to check, and an exit code for scripts.

use std::fs;

use super::clock::Clock;
use super::{Taken, Zone, try_check};

const HELP: &str = "\
Checks whether a mill's tool keeps out of the clamps, exactly.

Usage: keep_out [PROGRAM]...

  PROGRAM  A file of G-code: G0 and G1 to X, Y, Z in millimetres, tilted by A and B in degrees.
           Without one, the two bundled programs

Prints each pose at which the tool begins to touch a clamp, is inside one, or is outside again.

Exits with 0 if the tool touches no clamp, with 1 if it does, and with 2 if a program cannot be
read. The bundled programs exit with 0 if both touch a clamp, as they must.";

/// What the process exits with.
const FREE: i32 = 0;
const COLLISION: i32 = 1;
const UNREADABLE: i32 = 2;

/// Checks the programs that the command line names; `None` if it names none.
pub(crate) fn run(zone: &Zone, clock: &Clock, taken: &mut Taken) -> Option<i32> {
    let arguments: Vec<_> =
        std::env::args_os().skip(1).map(|a| a.to_string_lossy().into_owned()).collect();
    if arguments.iter().any(|a| a == "--help" || a == "-h") {
        println!("{HELP}");
        return Some(FREE);
    }
    if let Some(option) = arguments.iter().find(|a| a.starts_with('-')) {
        eprintln!("error: {option}: there is no such option; --help explains the program");
        return Some(UNREADABLE);
    }
    let codes = arguments.iter().map(|path| match fs::read_to_string(path) {
        Ok(text) => match try_check(zone, clock, taken, path, &text) {
            Some(true) => COLLISION,
            Some(false) => FREE,
            None => UNREADABLE,
        },
        Err(error) => {
            eprintln!("error: {path}: {error}");
            UNREADABLE
        }
    });
    codes.max()
}
