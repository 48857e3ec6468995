//! Sessions decide which frames are played again; the game saves, loads and advances as they
//! request, in their order. A rollback library has this shape: in GGRS the same requests come from
//! a `P2PSession`, and from a `SyncTestSession`.

use heapless::Vec;

/// The most frames that a session rolls back.
pub(crate) const MOST_BACK: usize = 8;
/// The frames whose inputs are kept: a remote peer may be as far ahead.
const WINDOW: usize = 2 * MOST_BACK + 1;

/// A request to the game.
pub(crate) enum Request {
    /// Save the state before this frame.
    Save { frame: usize },
    /// Load the state before this frame.
    Load { frame: usize },
    /// Advance by a frame.
    Advance { inputs: [u8; 2] },
}

/// The requests of a frame. Each frame that is played again has two, and there are up to four more.
pub(crate) type Requests = Vec<Request, { 2 * MOST_BACK + 4 }>;

/// The inputs of the last frames, and the current frame.
struct Inputs {
    frame: usize,
    kept: [[u8; 2]; WINDOW],
    replayed: usize,
}

impl Inputs {
    const NONE: Self = Self { frame: 0, kept: [[0; 2]; WINDOW], replayed: 0 };

    fn of(&mut self, frame: usize) -> &mut [u8; 2] {
        &mut self.kept[frame % WINDOW]
    }

    /// Requests all frames from `first` to the current one again, and saves that one.
    fn replay(&mut self, first: usize, requests: &mut Requests) {
        let mut push = |request| {
            // There is room for `MOST_BACK` frames.
            let _ = requests.push(request);
        };
        push(Request::Load { frame: first });
        for frame in first..self.frame {
            push(Request::Advance { inputs: *self.of(frame) });
            push(Request::Save { frame: frame + 1 });
            self.replayed += 1;
        }
    }

    /// Requests the current frame.
    fn advance(&mut self, requests: &mut Requests) {
        let _ = requests.push(Request::Advance { inputs: *self.of(self.frame) });
        self.frame += 1;
    }
}

/// One of two peers. It predicts the remote input, and rolls back if a prediction was wrong.
pub(crate) struct Peer {
    player: usize,
    inputs: Inputs,
    /// The number of frames whose remote input has arrived.
    confirmed: usize,
    last_known: u8,
    /// The first frame that was predicted wrongly.
    wrong: Option<usize>,
}

impl Peer {
    pub(crate) fn new(player: usize) -> Self {
        Self { player, inputs: Inputs::NONE, confirmed: 0, last_known: 0, wrong: None }
    }

    /// Takes the remote input of the next frame.
    pub(crate) fn add_remote_input(&mut self, input: u8) {
        let frame = self.confirmed;
        let predicted = &mut self.inputs.of(frame)[1 - self.player];
        let is_wrong = *predicted != input;
        *predicted = input;
        if is_wrong && frame < self.inputs.frame {
            self.wrong.get_or_insert(frame);
        }
        (self.confirmed, self.last_known) = (frame + 1, input);
    }

    /// The requests of a frame with this local input, or `None` if the remote peer is too far behind
    /// to go on.
    pub(crate) fn advance_frame(&mut self, local: u8) -> Option<Requests> {
        let (now, remote) = (self.inputs.frame, 1 - self.player);
        if now >= self.confirmed + MOST_BACK {
            return None;
        }
        // The prediction: the remote input has not changed.
        for frame in self.confirmed..=now {
            self.inputs.of(frame)[remote] = self.last_known;
        }
        self.inputs.of(now)[self.player] = local;
        let mut requests = Requests::new();
        match self.wrong.take() {
            Some(first) => self.inputs.replay(first, &mut requests),
            None => drop(requests.push(Request::Save { frame: now })),
        }
        self.inputs.advance(&mut requests);
        Some(requests)
    }

    /// The number of frames whose inputs are all known.
    pub(crate) fn confirmed(&self) -> usize {
        self.confirmed.min(self.inputs.frame)
    }

    /// The number of frames that were played again.
    pub(crate) fn replayed(&self) -> usize {
        self.inputs.replayed
    }
}

/// A test on one machine: each frame goes back a few frames and plays them again. Each save must have
/// the checksum of the first save of its frame.
pub(crate) struct SyncTest {
    back: usize,
    inputs: Inputs,
}

impl SyncTest {
    /// `back` is at most [`MOST_BACK`].
    pub(crate) fn new(back: usize) -> Self {
        Self { back, inputs: Inputs::NONE }
    }

    /// The requests of a frame with these inputs.
    pub(crate) fn advance_frame(&mut self, inputs: [u8; 2]) -> Requests {
        let now = self.inputs.frame;
        *self.inputs.of(now) = inputs;
        let mut requests = Requests::new();
        let _ = requests.push(Request::Save { frame: now });
        if let Some(first) = now.checked_sub(self.back) {
            self.inputs.replay(first, &mut requests);
        }
        self.inputs.advance(&mut requests);
        requests
    }

    /// The number of frames that were played again.
    pub(crate) fn replayed(&self) -> usize {
        self.inputs.replayed
    }
}
