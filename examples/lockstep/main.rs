//! Lockstep: two peers run the same world from the same inputs. They send each other
//! inputs and hashes, never the world.
//!
//! Boxes fall and slide on a terrain of triangles, all in I16F16. Each peer knows its
//! own input at once, and the other's five ticks later. Until then it predicts that
//! input. If the prediction was wrong, it rolls back and runs those ticks again. The
//! hash of each tick is the same in both peers, on every machine. If one bit of one
//! input is changed, the hashes differ from that tick on.
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

/// How many ticks the world runs.
const TICKS: usize = 120;
/// The tick whose input is corrupted on the way.
const BAD_TICK: usize = 57;
/// The hash of the last tick, the same on every machine.
const LAST: u64 = 0x8e33_66e5_807f_768f;

const LINES: usize = 3;

type Hashes = [u64; TICKS];

/// A player's input, the same in each run. Four bits are the four directions.
fn input(player: usize, tick: usize) -> u8 {
    // An input stays for seven ticks.
    let mixed = (tick as u64 / 7 * 2 + player as u64 + 1).wrapping_mul(0x9e37_79b9_7f4a_7c15);
    (mixed >> 60) as u8
}

/// The hashes of a run in which every input is known at once.
fn straight() -> Hashes {
    let (mut world, mut hashes) = (World::new(), [0; TICKS]);
    for (tick, hash) in hashes.iter_mut().enumerate() {
        world.step([input(0, tick), input(1, tick)]);
        *hash = world.hash();
    }
    hashes
}

/// The hashes of a peer that gets the other's inputs late. The bits `changed` of one
/// of these inputs are flipped on the way. Also how many ticks it ran again.
fn late(own: usize, changed: u8) -> (Hashes, usize) {
    let mut peer = Peer::new(own);
    let mut hashes = [0; TICKS];
    for tick in 0..TICKS + peer::DELAY {
        if let Some(arrived) = tick.checked_sub(peer::DELAY) {
            let bits = if arrived == BAD_TICK { changed } else { 0 };
            hashes[arrived] = peer.confirm(input(1 - own, arrived) ^ bits);
        }
        // After the last tick the peer only waits for inputs.
        if tick < TICKS {
            peer.play(input(own, tick));
        }
    }
    (hashes, peer.replayed())
}

fn line(k: usize) -> Line {
    let mut text = heapless::String::new();
    let hashes = straight();
    // A line has room for all of this text.
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
            // The peers compare hashes.
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
