//! Lockstep: two peers run the same world from the same inputs, and never send it.
//!
//! Boxes fall and slide on a terrain of triangles, all in I16F16. Each peer knows
//! its own input at once and the other's five ticks later; until then it guesses,
//! and where it guessed wrong it goes back and runs those ticks again. The hash of
//! each tick is the same in both, on every machine. One bit changed in one input is
//! noticed at that very tick.
//!
//! ```text
//! cargo run --release --example lockstep
//! cargo run --release --example lockstep --target thumbv6m-none-eabi
//! ```
#![cfg_attr(any(target_os = "none", target_family = "wasm"), no_std, no_main)]

mod peer;
#[path = "../boards/program.rs"]
mod program;
mod terrain;
mod world;

use core::fmt::Write;

use peer::Peer;
use program::{Line, program};
use world::World;

/// How long it runs.
const TICKS: usize = 120;
/// Where the input is changed that must not be.
const BAD_TICK: usize = 57;
/// The hash of the last tick, the same on every machine.
const LAST: u64 = 0x8e33_66e5_807f_768f;

const LINES: usize = 3;

type Hashes = [u64; TICKS];

/// What a player's hand does: the same in each run, and the four directions as four
/// bits.
fn input(player: usize, tick: usize) -> u8 {
    // A hand holds still for seven ticks.
    let mixed = (tick as u64 / 7 * 2 + player as u64 + 1).wrapping_mul(0x9e37_79b9_7f4a_7c15);
    (mixed >> 60) as u8
}

/// Nobody guesses.
fn straight() -> Hashes {
    let (mut world, mut hashes) = (World::new(), [0; TICKS]);
    for (tick, hash) in hashes.iter_mut().enumerate() {
        world.step([input(0, tick), input(1, tick)]);
        *hash = world.hash();
    }
    hashes
}

/// What a peer makes of it, which gets the other's inputs late, and with these bits
/// of one of them changed on the way. Also how many ticks it ran again.
fn late(own: usize, changed: u8) -> (Hashes, usize) {
    let mut peer = Peer::new(own);
    let mut hashes = [0; TICKS];
    for tick in 0..TICKS + peer::DELAY {
        if let Some(arrived) = tick.checked_sub(peer::DELAY) {
            let bits = if arrived == BAD_TICK { changed } else { 0 };
            hashes[arrived] = peer.confirm(input(1 - own, arrived) ^ bits);
        }
        // The last ticks are waited for, not played.
        if tick < TICKS {
            peer.play(input(own, tick));
        }
    }
    (hashes, peer.replayed())
}

fn line(k: usize) -> Line {
    let mut text = heapless::String::new();
    let hashes = straight();
    // There is room for all of it.
    let is_right = match k {
        0 => {
            let _ = write!(text, "hash at tick 30, 60, 90, 120:");
            for tick in [29, 59, 89, 119] {
                let _ = write!(text, " {:08x}", hashes[tick] >> 32);
            }
            hashes[TICKS - 1] == LAST
        }
        1 => {
            let ((first, again), (second, more)) = (late(0, 0), late(1, 0));
            let agree = first == hashes && second == hashes;
            let _ = write!(text, "rolled back: {again} and {more} ticks run again, ");
            let _ = write!(text, "{}", if agree { "all hashes equal" } else { "DESYNC" });
            agree
        }
        _ => {
            // What the peers send each other beside their inputs: the hashes.
            let ((ours, _), (theirs, _)) = (late(0, 1), late(1, 0));
            let desync = (0..TICKS).find(|&tick| ours[tick] != theirs[tick]);
            let _ = write!(text, "one bit changed at tick {BAD_TICK}: ");
            let _ = match desync {
                Some(tick) => write!(text, "desync noticed at tick {tick}"),
                None => write!(text, "NOT noticed"),
            };
            desync == Some(BAD_TICK)
        }
    };
    (text, is_right)
}

program!(LINES, line);
