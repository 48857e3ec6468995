//! Lockstep: two peers run the same world from the same inputs. They send each other
//! inputs and hashes, never the world.
//!
//! Boxes fall, turn, stack and rest on a terrain of triangles, using septum's broad phase, contacts and
//! sweeps in `f32`. Each peer knows its own input at once, and the remote input five ticks later. Until
//! then it predicts the remote input. If the prediction was wrong, it rolls back and runs those
//! ticks again. The hash of each tick is the same in both peers, on every machine. If one bit of
//! one input is changed, the hashes differ from that tick on.
//!
//! ```text
//! cargo run --release --example lockstep
//! cargo run --release --example lockstep -- crowd     # 200 boxes, and what a frame takes
//! cargo run --release --example lockstep --target thumbv6m-none-eabi
//! ```
#![cfg_attr(any(target_os = "none", target_family = "wasm"), no_std, no_main)]

mod body;
#[cfg(not(any(target_os = "none", target_family = "wasm")))]
mod crowd;
mod peer;
#[path = "../boards/program.rs"]
mod program;
mod solver;
mod terrain;
mod vector;
mod world;

use core::fmt::Write;

use peer::Peer;
use program::{Line, program};
use terrain::{Ground, with_ground};
use world::{POINTS, World};

/// The number of bodies in the world.
const BODIES: usize = 6;
/// The number of ticks.
const TICKS: usize = 120;
/// The tick whose input is corrupted in transit.
const BAD_TICK: usize = 57;
/// The hash of the last tick, the same on every machine.
const LAST: u64 = 0x0218_4dc0_1c81_5eda;

const LINES: usize = 3;

type Game = World<BODIES>;
type Hashes = [u64; TICKS];

/// A player's input, the same in each run. Four bits are the four directions.
fn input(player: usize, tick: usize) -> u8 {
    // An input stays for seven ticks.
    let mixed = (tick as u64 / 7 * 2 + player as u64 + 1).wrapping_mul(0x9e37_79b9_7f4a_7c15);
    (mixed >> 60) as u8
}

fn step(game: &mut Game, ground: &Ground<'_>, inputs: [u8; 2]) {
    game.step::<{ POINTS * BODIES }>(ground, inputs);
}

/// The hashes of a run with all inputs known at once, and its last world.
fn straight(ground: &Ground<'_>) -> (Hashes, Game) {
    let (mut world, mut hashes) = (Game::new(), [0; TICKS]);
    for (tick, hash) in hashes.iter_mut().enumerate() {
        step(&mut world, ground, [input(0, tick), input(1, tick)]);
        *hash = world.hash();
    }
    (hashes, world)
}

/// The hashes of a peer that receives remote inputs late, and the number of ticks that it replayed.
/// The bits `changed` of one of these inputs are flipped in transit.
fn late(ground: &Ground<'_>, own: usize, changed: u8) -> (Hashes, usize) {
    let mut peer = Peer::new(own, ground);
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

/// A sync test, as rollback libraries have one: after each tick the world of a few ticks before is
/// loaded and advanced again, and must have the same hash. Returns the number of ticks that were run
/// again, or `None` after a difference.
fn sync_test(ground: &Ground<'_>) -> Option<usize> {
    const BACK: usize = 2;
    let (mut world, mut saved) = (Game::new(), [Game::new(); BACK]);
    let mut count = 0;
    for tick in 0..TICKS {
        // The save of `BACK` ticks before makes room for this one.
        let oldest = core::mem::replace(&mut saved[tick % BACK], world);
        step(&mut world, ground, [input(0, tick), input(1, tick)]);
        let Some(first) = tick.checked_sub(BACK) else { continue };
        let mut again = oldest.loaded();
        for old in first..=tick {
            step(&mut again, ground, [input(0, old), input(1, old)]);
            count += 1;
        }
        if again.hash() != world.hash() {
            return None;
        }
    }
    Some(count)
}

fn line(k: usize) -> Line {
    #[cfg(not(any(target_os = "none", target_family = "wasm")))]
    if crowd::is_asked_for() {
        return crowd::line(k);
    }
    with_ground(|ground| line_on(ground, k)).unwrap_or_default()
}

fn line_on(ground: &Ground<'_>, k: usize) -> Line {
    let mut text = heapless::String::new();
    // A line has room for all of this text.
    let is_right = match k {
        0 => {
            let (hashes, end) = straight(ground);
            let _ = write!(text, "hash at tick 30, 60, 90, 120:");
            for tick in [29, 59, 89, 119] {
                let _ = write!(text, " {:08x}", hashes[tick] >> 32);
            }
            hashes[TICKS - 1] == LAST && end.is_whole()
        }
        1 => {
            let (hashes, end) = straight(ground);
            let ((first, again), (second, more)) = (late(ground, 0, 0), late(ground, 1, 0));
            let agree = first == hashes && second == hashes;
            let _ = write!(text, "rolled back: {again} and {more} ticks run again, ");
            let _ = write!(text, "{}", if agree { "all hashes equal" } else { "DESYNC" });
            let _ = write!(text, ", {} of {BODIES} rest", end.resting());
            let synced = sync_test(ground);
            let _ = match synced {
                Some(count) => write!(text, "; sync test: {count} ticks"),
                None => write!(text, "; sync test FAILED"),
            };
            agree && synced.is_some()
        }
        _ => {
            // The peers compare hashes.
            let ((ours, _), (theirs, _)) = (late(ground, 0, 1), late(ground, 1, 0));
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
