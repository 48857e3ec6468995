//! The measurement of one query.

use core::hint::black_box;

use crate::clock::Clock;
use crate::stack;

/// A query about two shapes.
pub(crate) type Ask<A, B> = fn(&A, &B) -> bool;

/// The cost of some queries.
#[derive(Clone, Copy, Default)]
pub(crate) struct Taken {
    queries: u64,
    instructions: u64,
    stack: usize,
    /// The lowest byte of stack of an empty query, or zero before it is known.
    top: usize,
}

impl Taken {
    /// The instructions of all queries.
    pub(crate) fn total(&self) -> u64 {
        self.instructions
    }

    /// The instructions of one query: the rounded average.
    #[allow(dead_code, reason = "not of every example that measures")]
    pub(crate) fn instructions(&self) -> u64 {
        (self.instructions + self.queries / 2).checked_div(self.queries).unwrap_or(0)
    }

    /// The greatest number of bytes of stack of a query.
    pub(crate) fn stack(&self) -> usize {
        self.stack
    }
}

/// Measures instructions and stack.
pub(crate) struct Meter(Clock);

impl Meter {
    pub(crate) fn new(clock: Clock) -> Self {
        Self(clock)
    }

    /// Whether this machine counts instructions.
    pub(crate) fn counts(&self) -> bool {
        self.0.count(|| ()).1.is_some()
    }

    /// Adds the cost of a query on each of the pairs, minus the cost of an empty query. Calls with the
    /// same `taken` come from one place, because only the first measures the stack of an empty query.
    pub(crate) fn add<A, B>(&self, taken: &mut Taken, pairs: &[(A, B)], ask: Ask<A, B>) {
        let nothing: Ask<A, B> = |_, _| false;
        let count = |ask| self.0.count(|| ask_all(pairs, ask)).1.unwrap_or(0);
        taken.instructions += count(ask).saturating_sub(count(nothing));
        taken.queries += pairs.len() as u64;
        // Not the last statement, because an external counter waits for the return.
        let run = |ask| {
            ask_all(pairs, ask);
            black_box(());
        };
        let lowest = |ask| stack::lowest(&mut || run(ask));
        if taken.top == 0 {
            taken.top = lowest(nothing);
        }
        taken.stack = taken.stack.max(taken.top.saturating_sub(lowest(ask)));
    }
}

/// Never inlined, so that the loop is the same code for every query.
#[inline(never)]
fn ask_all<A, B>(pairs: &[(A, B)], ask: Ask<A, B>) {
    let ask = black_box(ask);
    for (a, b) in pairs {
        black_box(ask(black_box(a), black_box(b)));
    }
}
