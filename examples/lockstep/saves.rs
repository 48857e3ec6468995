//! The states of the last frames, with their checksums.

use crate::game::{Game, State};
use crate::number::Number;
use crate::session::{MOST_BACK, Request, Requests};

#[derive(Clone, Copy)]
struct Saved<T, const N: usize> {
    frame: usize,
    state: State<T, N>,
    checksum: u64,
}

/// A ring.
#[derive(Clone)]
pub(crate) struct Saves<T, const N: usize>([Option<Saved<T, N>>; MOST_BACK + 1]);

impl<T: Number, const N: usize> Saves<T, N> {
    pub(crate) fn new() -> Self {
        Self([None; MOST_BACK + 1])
    }

    fn get(&self, frame: usize) -> Option<&Saved<T, N>> {
        self.0[frame % self.0.len()].as_ref().filter(|saved| saved.frame == frame)
    }

    /// The checksum of the state before this frame.
    pub(crate) fn checksum(&self, frame: usize) -> Option<u64> {
        self.get(frame).map(|saved| saved.checksum)
    }

    /// Fulfils the requests. Returns the first frame whose state is another one than was saved
    /// before. A state to be loaded that is missing counts as another one.
    pub(crate) fn fulfil<const TOUCHES: usize>(
        &mut self,
        game: &mut Game<'_, T, N, TOUCHES>,
        requests: &Requests,
    ) -> Option<usize> {
        let mut differs = None;
        for request in requests {
            match *request {
                Request::Save { frame } => {
                    let state = game.save();
                    let checksum = state.checksum();
                    if self.checksum(frame).is_some_and(|known| known != checksum) {
                        differs = differs.or(Some(frame));
                    }
                    self.0[frame % self.0.len()] = Some(Saved { frame, state, checksum });
                }
                Request::Load { frame } => match self.get(frame) {
                    Some(saved) => game.load(&saved.state),
                    None => differs = differs.or(Some(frame)),
                },
                Request::Advance { inputs } => game.advance(inputs),
            }
        }
        differs
    }
}
