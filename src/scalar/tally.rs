//! How far questions climb: counted in unit tests, and nowhere else.

/// Where a question goes on to the next rung, or arrives at the last.
#[derive(Clone, Copy)]
pub(super) enum Step {
    /// Past the first rung for numbers.
    First,
    /// Past a rung.
    Rung,
    /// Past a rung for narrow registers.
    #[cfg(feature = "fixed")]
    Words,
    /// Arrived at the exact sums.
    Exactly,
}

/// Notes a step, in unit tests.
#[inline(always)]
pub(super) fn note(step: Step) {
    #[cfg(all(test, feature = "fixed"))]
    super::climbs::add(step);
    #[cfg(not(all(test, feature = "fixed")))]
    let _ = step;
}
