/// A number as sign, whole magnitude and power of two, in units of the least
/// number of its type.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Parts {
    /// Whether it is below zero.
    pub negative: bool,
    /// The magnitude before the shift.
    pub magnitude: u64,
    /// How far to shift the magnitude up.
    pub shift: u16,
}

impl Parts {
    /// Zero.
    pub(crate) const ZERO: Self = Self { negative: false, magnitude: 0, shift: 0 };

    /// The number one, in no unit: a factor that changes nothing.
    pub(crate) const UNIT: Self = Self { negative: false, magnitude: 1, shift: 0 };

    /// The number with the other sign.
    pub fn negated(self) -> Self {
        Self { negative: !self.negative, ..self }
    }
}
