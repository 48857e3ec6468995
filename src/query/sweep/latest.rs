use super::FirstContact;
use crate::arithmetic::Number;
use crate::query::Axis;
use crate::robust::Uncertain;
use crate::scalar::Scalar;

/// The latest of the times at which axes stop separating, with errors.
///
/// Each time is rounded down to the scalar by itself. Rounding keeps the order, so the latest
/// rounded time is the latest true time, rounded; fractions need not be compared.
pub(super) struct Latest<S> {
    /// `None` until an axis is known to separate.
    found: Option<FirstContact<S>>,
    /// The latest possible time of the axes whose own time is unknown.
    in_doubt: Option<S>,
}

impl<S: Scalar> Latest<S> {
    pub(super) const NONE: Self = Self { found: None, in_doubt: None };

    /// Adds an axis with a gap that closes at some speed, each with its error. Call it in the order
    /// of [`Axis::ALL`].
    #[inline(always)]
    pub(super) fn add<T: Number>(&mut self, axis: Axis, gap: [T; 2], speed: [T; 2]) {
        let [gap, error] = gap;
        let is_gap = Uncertain::above(gap, error);
        if !is_gap.possible {
            return;
        }
        let [low, high] = gap.portion(speed[0], [error, speed[1]]).map(S::at_most);
        if low == high && is_gap.certain {
            self.set(axis, low);
        } else if self.in_doubt.is_none_or(|t| high > t) {
            self.in_doubt = Some(high);
        }
    }

    /// Adds an axis that separates until then.
    pub(super) fn set(&mut self, axis: Axis, t: S) {
        if self.found.is_none_or(|found| t > found.t) {
            self.found = Some(FirstContact { t, axis: Some(axis) });
        }
    }

    /// The first contact; `None` while it is in doubt.
    pub(super) fn known(self) -> Option<FirstContact<S>> {
        let found = self.found.unwrap_or(FirstContact { t: S::ZERO, axis: None });
        // A time in doubt may be equal and belong to an axis that comes before.
        let is_later = |t: S| if self.found.is_some() { found.t > t } else { false };
        self.in_doubt.is_none_or(is_later).then_some(found)
    }
}
