//! Bounds on the time of a contact, and the latest of the times at which axes stop separating.

use super::FirstContact;
use crate::arithmetic::{Each, Number};
use crate::query::Axis;
use crate::robust::Uncertain;
use crate::scalar::Scalar;

/// A relative bound, above the relative loss of a scalar's number in `f64`.
const NEAR: f64 = 64.0 * f64::EPSILON;

/// The bounds from floats on a motion.
#[derive(Clone, Copy, Debug, Default)]
pub(super) enum Instant {
    /// Nothing.
    #[default]
    Unknown,
    /// The shapes miss each other.
    Misses,
    /// They meet at the start.
    AtStart,
    /// They meet; the axis that closes last, if floats know it.
    Meets(Option<Last>),
}

/// The axis that closes last.
#[derive(Clone, Copy, Debug)]
pub(super) struct Last {
    pub(super) axis: Axis,
    /// A time at which all other axes have closed, and this one has not.
    pub(super) after: f64,
}

impl Last {
    /// The answer, if all other axes have closed before it also in the scalar's rounding. Otherwise
    /// an axis that comes first in the order may close at the same number.
    pub(super) fn at<S: Scalar>(self, t: S) -> Option<FirstContact<S>> {
        let is_after = t.in_double() > self.after * (1.0 + NEAR);
        is_after.then_some(FirstContact { t, axis: Some(self.axis) })
    }
}

/// A gap at the start and the speed that closes it, each with its error.
pub(super) type Closing<T> = [[T; 2]; 2];

/// The time at which an axis closes, rounded down, if it certainly has a gap.
#[inline(always)]
pub(super) fn closing_time<S: Scalar, T: Number>([[gap, error], speed]: Closing<T>) -> Option<S> {
    let [low, high] = gap.portion(speed[0], [error, speed[1]]).each(S::at_most);
    ((low == high) & Uncertain::above(gap, error).certain).then_some(low)
}

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

    /// Adds an axis, if it has a gap. Call it in the order of [`Axis::ALL`].
    #[inline(always)]
    pub(super) fn add<T: Number>(&mut self, axis: Axis, closing: Option<Closing<T>>) {
        let Some([[gap, error], speed]) = closing else { return };
        let is_gap = Uncertain::above(gap, error);
        if !is_gap.possible {
            return;
        }
        let [low, high] = gap.portion(speed[0], [error, speed[1]]).each(S::at_most);
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
