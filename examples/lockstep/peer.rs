//! A peer: plays ahead on a guess, and goes back where it was wrong.

use crate::world::World;

/// How many ticks an input takes from one peer to the other.
pub(crate) const DELAY: usize = 5;

/// A tick whose inputs are not all known yet.
struct Tick {
    /// The world before it: where to go back to.
    before: World,
    own: u8,
    /// What the other's input is taken for.
    other: u8,
}

/// One of the two players.
pub(crate) struct Peer {
    player: usize,
    /// As it is shown: after all ticks, some of them guessed.
    shown: World,
    /// The ticks not certain yet, the oldest first.
    open: heapless::Deque<Tick, { DELAY + 1 }>,
    last_known: u8,
    replayed: usize,
}

impl Peer {
    pub(crate) fn new(player: usize) -> Self {
        let open = heapless::Deque::new();
        Self { player, shown: World::new(), open, last_known: 0, replayed: 0 }
    }

    /// One tick ahead: the other's hand is where it was last seen.
    pub(crate) fn play(&mut self, own: u8) {
        let tick = Tick { before: self.shown, own, other: self.last_known };
        self.shown.step(self.inputs(&tick));
        // Ticks become certain as fast as others come.
        let _ = self.open.push_back(tick);
    }

    /// The other's input of the oldest open tick has come: the hash of the world
    /// after that tick, run again if it was guessed wrong.
    pub(crate) fn confirm(&mut self, other: u8) -> u64 {
        let guess = self.open.front().map(|tick| tick.other);
        self.last_known = other;
        if guess != Some(other) {
            self.roll_back();
        }
        self.open.pop_front();
        self.open.front().map_or(&self.shown, |next| &next.before).hash()
    }

    /// Back to before the oldest open tick, and all of them once more.
    fn roll_back(&mut self) {
        let Some(oldest) = self.open.front() else { return };
        self.shown = oldest.before;
        for _ in 0..self.open.len() {
            let Some(tick) = self.open.pop_front() else { return };
            self.play(tick.own);
            self.replayed += 1;
        }
    }

    /// How many ticks were run again.
    pub(crate) fn replayed(&self) -> usize {
        self.replayed
    }

    fn inputs(&self, tick: &Tick) -> [u8; 2] {
        if self.player == 0 { [tick.own, tick.other] } else { [tick.other, tick.own] }
    }
}
