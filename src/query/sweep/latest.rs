use super::FirstContact;
use crate::arithmetic::Number;
use crate::query::Axis;
use crate::robust::Uncertain;
use crate::scalar::Scalar;

/// The latest of the times at which axes cease to separate, errors allowed for.
///
/// Each is rounded down to the scalar by itself. Rounding keeps order, so the latest of them is
/// the true latest one, rounded, and no two fractions are compared.
pub(super) struct Latest<S> {
    /// Nothing while no axis is known to separate.
    found: Option<FirstContact<S>>,
    /// The latest of the times that may be of an axis whose own is not known.
    in_doubt: Option<S>,
}

impl<S: Scalar> Latest<S> {
    pub(super) const NONE: Self = Self { found: None, in_doubt: None };

    /// An axis with a gap that closes at some speed, and how far from the truth these may be. In
    /// the order of [`Axis::ALL`].
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

    /// An axis that separates until then.
    pub(super) fn set(&mut self, axis: Axis, t: S) {
        if self.found.is_none_or(|found| t > found.t) {
            self.found = Some(FirstContact { t, axis: Some(axis) });
        }
    }

    /// The first contact; `None` in doubt.
    pub(super) fn known(self) -> Option<FirstContact<S>> {
        let found = self.found.unwrap_or(FirstContact { t: S::ZERO, axis: None });
        // A time in doubt may be the same, of an axis that comes before.
        let is_later = |t: S| if self.found.is_some() { found.t > t } else { false };
        self.in_doubt.is_none_or(is_later).then_some(found)
    }
}
