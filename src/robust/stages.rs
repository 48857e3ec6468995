//! How often a cascade escalates; counted only in unit tests.

/// A step of a question: an escalation, or the arrival at the last stage.
#[derive(Clone, Copy)]
pub(crate) enum Stage {
    /// Past the first look: past the first stage for numbers, the slabs of a prepared ray, or a
    /// kernel that leaves its doubts to another.
    Look,
    /// Past a number system.
    Filter,
    /// Past a stage for narrow registers.
    #[cfg(feature = "fixed")]
    Narrow,
    /// Arrived at the last stage.
    Exact,
}

/// Records a step, in unit tests.
#[inline(always)]
pub(crate) fn note(stage: Stage) {
    #[cfg(all(test, feature = "fixed"))]
    counter::add(stage);
    #[cfg(not(all(test, feature = "fixed")))]
    let _ = stage;
}

/// The answer of a number system. Without one, the question goes past it.
#[inline(always)]
pub(crate) fn noted<T>(answer: Option<T>) -> Option<T> {
    if answer.is_none() {
        note(Stage::Filter);
    }
    answer
}

#[cfg(all(test, feature = "fixed"))]
mod counter {
    extern crate std;

    use core::cell::Cell;

    use super::Stage;

    std::thread_local! {
        static COUNTS: Cell<[u32; 4]> = const { Cell::new([0; 4]) };
    }

    pub(super) fn add(stage: Stage) {
        let mut counts = COUNTS.get();
        counts[stage as usize] += 1;
        COUNTS.set(counts);
    }

    /// How often the question takes each step.
    pub(crate) fn escalations(question: impl FnOnce()) -> [u32; 4] {
        COUNTS.set([0; 4]);
        question();
        COUNTS.get()
    }
}

#[cfg(all(test, feature = "fixed"))]
pub(crate) use counter::escalations;
