/// What the axes tried so far say, errors allowed for.
///
/// Neither flag is branched on until both are final: which way a test goes is
/// as good as random, and a wrong guess costs more than all nine edge axes.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Uncertain {
    /// Some axis separates, beyond the error bound.
    pub(crate) certain: bool,
    /// Some axis may separate, for all that the error bound can tell.
    pub(crate) possible: bool,
}

impl Uncertain {
    /// No axis tried yet.
    pub(crate) const NONE: Self = Self { certain: false, possible: false };

    #[inline(always)]
    pub(crate) fn or(self, other: Self) -> Self {
        Self { certain: self.certain | other.certain, possible: self.possible | other.possible }
    }

    /// Whether an axis separates; `None` in doubt.
    #[inline(always)]
    pub(crate) fn verdict(self) -> Option<bool> {
        // One comparison that is nearly always false, not two that are random.
        if self.certain ^ self.possible { None } else { Some(self.certain) }
    }
}
