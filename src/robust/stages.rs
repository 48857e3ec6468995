//! How often a cascade escalates: counted in unit tests, and nowhere else.

/// Where a question escalates, or arrives at the last stage.
#[derive(Clone, Copy)]
pub(crate) enum Stage {
    /// Past the first stage for numbers, or past the slabs of a prepared ray.
    Numeric,
    /// Past a number system.
    Filter,
    /// Past a stage for narrow registers.
    #[cfg(feature = "fixed")]
    Narrow,
    /// Arrived at the exact sums.
    Exact,
}

/// Notes a step, in unit tests.
#[inline(always)]
pub(crate) fn note(stage: Stage) {
    #[cfg(all(test, feature = "fixed"))]
    counts::add(stage);
    #[cfg(not(all(test, feature = "fixed")))]
    let _ = stage;
}

#[cfg(all(test, feature = "fixed"))]
mod counts;
