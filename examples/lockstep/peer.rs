//! A peer: it predicts the remote input, and rolls back if the prediction was wrong.

use crate::terrain::Ground;
use crate::{Game, step};

/// The delay of an input between the peers, in ticks.
pub(crate) const DELAY: usize = 5;

/// A tick with inputs that are not all confirmed.
struct Tick {
    /// The world before the tick. A rollback starts here.
    before: Game,
    own: u8,
    /// The predicted remote input.
    other: u8,
}

/// One of the two players.
pub(crate) struct Peer<'a> {
    player: usize,
    ground: &'a Ground<'a>,
    /// The world after all ticks, some with predicted inputs.
    shown: Game,
    /// The unconfirmed ticks, oldest first.
    open: heapless::Deque<Tick, { DELAY + 1 }>,
    last_known: u8,
    replayed: usize,
}

impl<'a> Peer<'a> {
    pub(crate) fn new(player: usize, ground: &'a Ground<'a>) -> Self {
        let open = heapless::Deque::new();
        Self { player, ground, shown: Game::new(), open, last_known: 0, replayed: 0 }
    }

    /// Runs one tick. It predicts that the remote input has not changed.
    pub(crate) fn play(&mut self, own: u8) {
        let tick = Tick { before: self.shown, own, other: self.last_known };
        let inputs = self.inputs(&tick);
        step(&mut self.shown, self.ground, inputs);
        // There is room: each new tick confirms one.
        let _ = self.open.push_back(tick);
    }

    /// Takes the remote input for the oldest unconfirmed tick. Returns the hash of the world after
    /// that tick, which is replayed if the prediction was wrong.
    pub(crate) fn confirm(&mut self, other: u8) -> u64 {
        let guess = self.open.front().map(|tick| tick.other);
        self.last_known = other;
        if guess != Some(other) {
            self.roll_back();
        }
        self.open.pop_front();
        self.open.front().map_or(&self.shown, |next| &next.before).hash()
    }

    /// Restores the world before the oldest unconfirmed tick, and replays all later ticks.
    fn roll_back(&mut self) {
        let Some(oldest) = self.open.front() else { return };
        self.shown = oldest.before;
        for _ in 0..self.open.len() {
            let Some(tick) = self.open.pop_front() else { return };
            self.play(tick.own);
            self.replayed += 1;
        }
    }

    /// The number of replayed ticks.
    pub(crate) fn replayed(&self) -> usize {
        self.replayed
    }

    fn inputs(&self, tick: &Tick) -> [u8; 2] {
        if self.player == 0 { [tick.own, tick.other] } else { [tick.other, tick.own] }
    }
}
