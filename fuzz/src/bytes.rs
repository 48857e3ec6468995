//! Bytes as choices. After the last byte every choice is zero, so that every input means something,
//! and a longer input begins like a shorter one.

/// The rest of the input.
pub(crate) struct Bytes<'a>(&'a [u8]);

impl<'a> Bytes<'a> {
    pub(crate) fn new(data: &'a [u8]) -> Self {
        Self(data)
    }

    pub(crate) fn byte(&mut self) -> u8 {
        let Some((&first, rest)) = self.0.split_first() else { return 0 };
        self.0 = rest;
        first
    }

    /// A number from 0 to n − 1.
    pub(crate) fn below(&mut self, n: usize) -> usize {
        usize::from(self.byte()) % n
    }

    /// True once in `n` times.
    pub(crate) fn one_in(&mut self, n: usize) -> bool {
        self.below(n) == n - 1
    }

    /// An integer from −n to n.
    pub(crate) fn about_zero(&mut self, n: i64) -> i64 {
        i64::from(self.byte()) % (2 * n + 1) - n
    }

    /// Eight bytes.
    pub(crate) fn word(&mut self) -> i64 {
        i64::from_le_bytes([(); 8].map(|()| self.byte()))
    }
}
