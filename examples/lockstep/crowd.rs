//! Many boxes, and the time of a frame with a rollback.

use std::collections::VecDeque;
use std::fmt::Write;
use std::time::{Duration, Instant};

use crate::program::Line;
use crate::terrain::with_ground;
use crate::world::{POINTS, World};
use crate::{LINES, input};

const BODIES: usize = 200;
const TICKS: usize = 600;
/// The number of ticks that each frame rolls back.
const BACK: usize = 8;

type Crowd = World<BODIES>;

pub(crate) fn is_asked_for() -> bool {
    std::env::args().nth(1).is_some_and(|word| word == "crowd")
}

/// Each frame replays the last ticks from an earlier world, and then runs one more.
pub(crate) fn line(k: usize) -> Line {
    let mut text = heapless::String::new();
    if k + 1 < LINES {
        let what = ["200 boxes for ten seconds, each frame goes back", "and runs 8 ticks again …"];
        let _ = write!(text, "{}", what[k]);
        return (text, true);
    }
    let played = with_ground(|ground| {
        let step = |crowd: &mut Crowd, tick: usize| {
            crowd.step::<{ POINTS * BODIES }>(ground, [input(0, tick), input(1, tick)]);
        };
        let (mut straight, mut before) = (Crowd::new(), VecDeque::new());
        let (mut total, mut most, mut are_same) = (Duration::ZERO, Duration::ZERO, true);
        for tick in 0..TICKS {
            before.push_back(straight);
            if before.len() > BACK + 1 {
                before.pop_front();
            }
            step(&mut straight, tick);
            // The better of two runs: the worst frame should be due to the game, not to the
            // machine.
            let taken = [(); 2].map(|()| {
                let start = Instant::now();
                let mut again = before[0];
                for old in tick + 1 - before.len()..=tick {
                    step(&mut again, old);
                }
                are_same &= again.hash() == straight.hash();
                start.elapsed()
            });
            let taken = taken[0].min(taken[1]);
            (total, most) = (total + taken, most.max(taken));
        }
        let milliseconds = |time: Duration| time.as_secs_f64() * 1e3;
        let _ = write!(
            text,
            "{:.1} ms a frame, {:.1} at most, of 16.7; {} rest; {}",
            milliseconds(total) / TICKS as f64,
            milliseconds(most),
            straight.resting(),
            if are_same { "all hashes equal" } else { "DESYNC" },
        );
        let _ =
            write!(text, "{}", if straight.is_whole() { ", none fell through" } else { ", LOST" });
        are_same && straight.is_whole()
    });
    (text, played.unwrap_or(false))
}
