//! Many boxes, and the time of a frame with a rollback.

use std::fmt::Write;
use std::time::{Duration, Instant};

use crate::game::{Game, POINTS};
use crate::matches::input;
use crate::number::Number;
use crate::program::Line;
use crate::saves::Saves;
use crate::session::SyncTest;
use crate::terrain::{Ground, with_ground};

const BODIES: usize = 200;
const TICKS: usize = 600;

/// A sync test in which each frame goes `back` ticks.
pub(crate) fn line<T: Number>(back: usize) -> Line {
    eprintln!("200 boxes for ten seconds; each frame goes back and runs {back} ticks again …");
    with_ground(|ground: &Ground<'_, T>| {
        let mut text = heapless::String::new();
        let mut game = Game::<T, BODIES, { POINTS * BODIES }>::new(ground);
        let (mut saves, mut test) = (Saves::new(), SyncTest::new(back));
        let (mut total, mut most, mut differs) = (Duration::ZERO, Duration::ZERO, None);
        for tick in 0..TICKS {
            let requests = test.advance_frame([input(0, tick), input(1, tick)]);
            // The better of two runs: the worst frame should be due to the game, not to the
            // machine.
            let mut copies = (game.clone(), saves.clone());
            let taken =
                [(&mut copies.0, &mut copies.1), (&mut game, &mut saves)].map(|(game, saves)| {
                    let start = Instant::now();
                    differs = differs.or(saves.fulfil(game, &requests));
                    start.elapsed()
                });
            let taken = taken[0].min(taken[1]);
            (total, most) = (total + taken, most.max(taken));
        }
        let milliseconds = |time: Duration| time.as_secs_f64() * 1e3;
        let end = game.save();
        let _ = write!(
            text,
            "{:.1} ms a frame, {:.1} at most, of 16.7; {} rest; ",
            milliseconds(total) / TICKS as f64,
            milliseconds(most),
            end.resting(),
        );
        let _ = match differs {
            None => write!(text, "all hashes equal"),
            Some(tick) => write!(text, "DESYNC at tick {tick}"),
        };
        let _ = write!(text, "{}", if end.is_whole() { ", none fell through" } else { ", LOST" });
        (text, differs.is_none() && end.is_whole())
    })
    .unwrap_or_default()
}
