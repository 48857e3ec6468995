//! A peer: plays ahead on a guess, and goes back where it was wrong.

use crate::world::World;

/// How many ticks an input takes from one peer to the other.
pub(crate) const DELAY: usize = 5;

/// One of the two players.
pub(crate) struct Peer {
    own: usize,
    /// After all ticks whose inputs are known.
    confirmed: World,
    /// As it is shown.
    shown: World,
    /// Own inputs since, and what was guessed of the other's.
    ahead: heapless::Deque<(u8, u8), { DELAY + 1 }>,
    last_known: u8,
    replayed: usize,
}

impl Peer {
    pub(crate) fn new(own: usize) -> Self {
        let world = World::new();
        Self {
            own,
            confirmed: world,
            shown: world,
            ahead: heapless::Deque::new(),
            last_known: 0,
            replayed: 0,
        }
    }

    fn both(&self, own: u8, other: u8) -> [u8; 2] {
        if self.own == 0 { [own, other] } else { [other, own] }
    }

    /// One tick ahead: the other's hand is where it was last seen.
    pub(crate) fn play(&mut self, own: u8) {
        let guess = self.last_known;
        self.shown.step(self.both(own, guess));
        // Inputs that are known leave as fast as others come.
        let _ = self.ahead.push_back((own, guess));
    }

    /// The other's input of the oldest tick that is not certain yet: the hash of the
    /// world after it.
    pub(crate) fn confirm(&mut self, other: u8) -> u64 {
        let Some((own, guess)) = self.ahead.pop_front() else { return self.confirmed.hash() };
        self.confirmed.step(self.both(own, other));
        self.last_known = other;
        if guess != other {
            self.roll_back();
        }
        self.confirmed.hash()
    }

    /// All since the last certain tick once more, by a better guess.
    fn roll_back(&mut self) {
        let mut world = self.confirmed;
        for k in 0..self.ahead.len() {
            let Some((own, _)) = self.ahead.pop_front() else { break };
            let guess = self.last_known;
            world.step(self.both(own, guess));
            let _ = self.ahead.push_back((own, guess));
            self.replayed += 1;
            debug_assert!(k < DELAY);
        }
        self.shown = world;
    }

    /// How many ticks were run again.
    pub(crate) fn replayed(&self) -> usize {
        self.replayed
    }
}
