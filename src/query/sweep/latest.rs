//! Bounds on the time of a contact, and the latest of the times at which axes stop separating.

use super::FirstContact;
use crate::arithmetic::{Each, Number, Soft};
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

/// What is done with each axis of a motion, in the order of [`Axis::ALL`].
pub(super) trait Closings {
    /// Adds an axis, if it has a gap.
    fn add<T: Number>(&mut self, axis: Axis, closing: Option<Closing<T>>);
}

/// The axis that closes last, of axes whose times have bounds.
pub(super) struct Later {
    /// The axis that closes last at the earliest, with that time and the latest.
    found: Option<(Axis, [Soft; 2])>,
    /// The latest time of all other axes.
    others: Soft,
}

impl Later {
    pub(super) const NONE: Self = Self { found: None, others: Soft::ZERO };

    pub(super) fn last(self) -> Option<Last> {
        let (axis, [low, _]) = self.found?;
        let (low, after) = (low.in_double(), self.others.in_double());
        (low > after * (1.0 + NEAR)).then_some(Last { axis, after })
    }
}

impl Closings for Later {
    #[inline(always)]
    fn add<T: Number>(&mut self, axis: Axis, closing: Option<Closing<T>>) {
        let Some([[gap, error], speed]) = closing else { return };
        let is_gap = Uncertain::above(gap, error);
        if !is_gap.possible {
            return;
        }
        let [low, high] = gap.portion(speed[0], [error, speed[1]]);
        let is_later = self.found.is_none_or(|(_, [found, _])| found.is_less_than(low));
        let other = if is_gap.certain && is_later {
            self.found.replace((axis, [low, high])).map_or(Soft::ZERO, |(_, [_, high])| high)
        } else {
            high
        };
        if self.others.is_less_than(other) {
            self.others = other;
        }
    }
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

impl<S: Scalar> Closings for Latest<S> {
    #[inline(always)]
    fn add<T: Number>(&mut self, axis: Axis, closing: Option<Closing<T>>) {
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
}

#[cfg(test)]
mod tests {
    use super::super::passing::{Misses, Passing};
    use crate::arithmetic::{Each, Filtered};
    use crate::query::sweep::Motion;
    use crate::random::Random;
    use crate::robust::Predicate;
    use crate::shape::{Aabb, Triangle};

    /// The axis that `f32` selects has the time of the first contact.
    #[test]
    fn a_selected_axis_closes_last() {
        let (mut random, mut seen) = (Random(0x1a57), [0; 3]);
        for n in 0..20_000 {
            let bits = [3, 30][n % 2];
            let mut point = || [(); 3].each(|()| (random.bits() as i32 >> (31 - bits)) as f32);
            let (triangle, motion) = (
                Triangle::new(point(), point(), point()).unwrap(),
                Motion::new(point(), point()).unwrap(),
            );
            let half = point().each(|x| x.abs() / 8.0);
            let aabb = Aabb::from_center_half_extents(point(), half).unwrap();
            let passing = Passing::new(&triangle, &aabb, &motion);
            if Misses(Passing::new(&triangle, &aabb, &motion)).exact() {
                continue;
            }
            let expected = passing.exactly().first_contact::<f32>();
            let last = passing.course::<Filtered<f32>>().unwrap().last();
            let Some(last) = last else {
                seen[usize::from(expected.axis.is_some())] += 1;
                continue;
            };
            let found = passing.course::<Filtered<f64>>().unwrap().at_last::<f32>(last);
            assert!(found.is_none_or(|found| found == expected), "{triangle:?} {motion:?}");
            seen[2] += usize::from(found.is_some());
        }
        // None at the start, and few in doubt.
        assert!(seen[0] > 400 && seen[1] < 50 && seen[2] > 1_000, "{seen:?}");
    }
}
