//! The matches that are played: by one machine, by two peers, and as a sync test.

use core::fmt::Write;

use crate::game::{Game, POINTS};
use crate::number::Number;
use crate::program::Line;
use crate::saves::Saves;
use crate::session::{Peer, SyncTest};
use crate::terrain::Ground;

/// The number of bodies in the world.
const BODIES: usize = 6;
/// The number of ticks.
const TICKS: usize = 120;
/// The time of an input between the peers, in ticks.
const DELAY: usize = 5;
/// The tick whose input is corrupted in transit.
const BAD_TICK: usize = 57;

/// The checksum after each tick.
type Checksums = [u64; TICKS];

type Small<'a, T> = Game<'a, T, BODIES, { POINTS * BODIES }>;

/// A player's input, the same in each run. Four bits are the four directions.
pub(crate) fn input(player: usize, tick: usize) -> u8 {
    // An input stays for seven ticks.
    let mixed = (tick as u64 / 7 * 2 + player as u64 + 1).wrapping_mul(0x9e37_79b9_7f4a_7c15);
    (mixed >> 60) as u8
}

/// All inputs are known at once. Also returns the game at its end.
fn straight<'a, T: Number>(ground: &'a Ground<'a, T>) -> (Checksums, Small<'a, T>) {
    let (mut game, mut checksums) = (Small::new(ground), [0; TICKS]);
    for (tick, checksum) in checksums.iter_mut().enumerate() {
        game.advance([input(0, tick), input(1, tick)]);
        *checksum = game.save().checksum();
    }
    (checksums, game)
}

/// A peer that receives remote inputs late. Also returns the number of frames that it played again.
/// The bits `changed` of one of these inputs are flipped in transit.
fn late<T: Number>(ground: &Ground<'_, T>, player: usize, changed: u8) -> (Checksums, usize) {
    let (mut game, mut saves) = (Small::new(ground), Saves::new());
    let (mut peer, mut checksums) = (Peer::new(player), [0; TICKS]);
    let mut known = 0;
    for tick in 0..TICKS + DELAY {
        if let Some(sent) = tick.checked_sub(DELAY) {
            let bits = if sent == BAD_TICK { changed } else { 0 };
            peer.add_remote_input(input(1 - player, sent) ^ bits);
        }
        let Some(requests) = peer.advance_frame(input(player, tick)) else { break };
        saves.fulfil(&mut game, &requests);
        while known < peer.confirmed() && known < TICKS {
            checksums[known] = saves.checksum(known + 1).unwrap_or(0);
            known += 1;
        }
    }
    (checksums, peer.replayed())
}

/// Plays all ticks, each with a rollback by `back` frames. Returns the number of frames that were
/// played again, or the first frame that differs.
fn sync_test<T: Number>(ground: &Ground<'_, T>, back: usize) -> Result<usize, usize> {
    let (mut game, mut saves, mut test) = (Small::new(ground), Saves::new(), SyncTest::new(back));
    for tick in 0..TICKS {
        let requests = test.advance_frame([input(0, tick), input(1, tick)]);
        if let Some(frame) = saves.fulfil(&mut game, &requests) {
            return Err(frame);
        }
    }
    Ok(test.replayed())
}

/// The checksums of four ticks. The last one must be `last`.
pub(crate) fn checksums<T: Number>(ground: &Ground<'_, T>, name: &str, last: u64) -> Line {
    let mut text = heapless::String::new();
    let (checksums, game) = straight(ground);
    // A line has room for all of this text.
    let _ = write!(text, "{name}, hash at tick 30, 60, 90, 120:");
    for tick in [29, 59, 89, 119] {
        let _ = write!(text, " {:08x}", checksums[tick] >> 32);
    }
    let is_right = checksums[TICKS - 1] == last;
    if !is_right {
        let _ = write!(text, ", NOT as elsewhere: {:016x}", checksums[TICKS - 1]);
    }
    (text, is_right && game.save().is_whole())
}

/// Two peers agree, and a sync test.
pub(crate) fn peers<T: Number>(ground: &Ground<'_, T>, back: usize) -> Line {
    let mut text = heapless::String::new();
    let (checksums, game) = straight(ground);
    let ((first, again), (second, more)) = (late(ground, 0, 0), late(ground, 1, 0));
    let agree = first == checksums && second == checksums;
    let _ = write!(text, "rolled back: {again} and {more} ticks run again, ");
    let _ = write!(text, "{}", if agree { "all hashes equal" } else { "DESYNC" });
    let _ = write!(text, ", {} of {BODIES} rest", game.save().resting());
    let synced = sync_test(ground, back);
    let _ = match synced {
        Ok(count) => write!(text, "; sync test: {count} ticks"),
        Err(frame) => write!(text, "; sync test: DESYNC at tick {frame}"),
    };
    (text, agree && synced.is_ok())
}

/// The peers compare hashes, and notice a changed bit.
pub(crate) fn one_bit<T: Number>(ground: &Ground<'_, T>) -> Line {
    let mut text = heapless::String::new();
    let ((ours, _), (theirs, _)) = (late(ground, 0, 1), late(ground, 1, 0));
    let desync = (0..TICKS).find(|&tick| ours[tick] != theirs[tick]);
    let _ = write!(text, "one bit changed at tick {BAD_TICK}: ");
    let _ = match desync {
        Some(tick) => write!(text, "desync noticed at tick {tick}"),
        None => write!(text, "NOT noticed"),
    };
    (text, desync == Some(BAD_TICK))
}
