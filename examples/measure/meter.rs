//! The measuring of one query.

use core::hint::black_box;

use crate::clock::Clock;
use crate::stack;

/// A question about two shapes.
pub(crate) type Ask<A, B> = fn(&A, &B) -> bool;

/// What queries took.
#[derive(Clone, Copy, Default)]
pub(crate) struct Taken {
    queries: u64,
    instructions: u64,
    stack: usize,
}

impl Taken {
    /// All instructions.
    pub(crate) fn total(&self) -> u64 {
        self.instructions
    }

    /// Those of a query, on average, to the nearest.
    pub(crate) fn instructions(&self) -> u64 {
        (self.instructions + self.queries / 2).checked_div(self.queries).unwrap_or(0)
    }

    /// Bytes, at most.
    pub(crate) fn stack(&self) -> usize {
        self.stack
    }
}

/// Counts instructions, and looks at the stack.
pub(crate) struct Meter(Clock);

impl Meter {
    pub(crate) fn new(clock: Clock) -> Self {
        Self(clock)
    }

    /// Whether there is anything to count with.
    pub(crate) fn counts(&self) -> bool {
        self.0.count(|| ()).1.is_some()
    }

    /// Adds what a query about each of the pairs takes beyond one that says nothing.
    pub(crate) fn add<A, B>(&self, taken: &mut Taken, pairs: &[(A, B)], ask: Ask<A, B>) {
        let nothing: Ask<A, B> = |_, _| false;
        let count = |ask| self.0.count(|| ask_all(pairs, ask)).1.unwrap_or(0);
        taken.instructions += count(ask).saturating_sub(count(nothing));
        taken.queries += pairs.len() as u64;
        let lowest = |ask| stack::lowest(&mut || ask_all(pairs, ask));
        taken.stack = taken.stack.max(lowest(nothing).saturating_sub(lowest(ask)));
    }
}

/// The same code for every query about such shapes.
#[inline(never)]
fn ask_all<A, B>(pairs: &[(A, B)], ask: Ask<A, B>) {
    let ask = black_box(ask);
    for (a, b) in pairs {
        black_box(ask(black_box(a), black_box(b)));
    }
}
