//! The intervals of an axis that a rule tests, one for each index: cells or their middles.

use super::place::{Level, Place, Span};

/// The intervals of an axis, numbered like the voxels.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Marks {
    /// From plane to plane, both included.
    Closed,
    /// From a plane, included, to the next, not included.
    HalfOpen,
    /// The middle between two planes, a single number.
    Center,
}

/// The marks of the three axes, known at compile time or not.
pub(super) trait AxisMarks: Copy {
    /// The marks of an axis.
    fn of(&self, axis: usize) -> Marks;
}

impl AxisMarks for [Marks; 3] {
    #[inline(always)]
    fn of(&self, axis: usize) -> Marks {
        self[axis]
    }
}

/// Closed on every axis, known at compile time: the most frequent rule.
#[cfg(not(feature = "small"))]
pub(super) const ALL_CLOSED: AllClosed = AllClosed;

/// Closed on every axis, in the type of the other rules, so that their code serves it too: one
/// kilobyte less beside solids, 2 % more time.
#[cfg(feature = "small")]
pub(super) const ALL_CLOSED: [Marks; 3] = [Marks::Closed; 3];

#[cfg(not(feature = "small"))]
#[derive(Clone, Copy, Debug)]
pub(super) struct AllClosed;

#[cfg(not(feature = "small"))]
impl AxisMarks for AllClosed {
    #[inline(always)]
    fn of(&self, _: usize) -> Marks {
        Marks::Closed
    }
}

impl Marks {
    /// Whether the limits of the intervals are planes and not middles.
    #[inline(always)]
    pub(super) fn are_cells(self) -> bool {
        self != Self::Center
    }

    /// The number of limits of an axis with `voxels` voxels.
    #[inline(always)]
    pub(super) fn limits(self, voxels: u32) -> i32 {
        voxels as i32 + i32::from(self.are_cells())
    }

    /// The distance of limit k from k, in cells.
    #[inline(always)]
    pub(super) fn shift(self) -> f64 {
        if self.are_cells() { 0.0 } else { 0.5 }
    }

    /// Limit k, a plane or a middle.
    #[inline(always)]
    pub(super) fn limit(self, k: i32) -> Level {
        Level { from: k, to: k + i32::from(!self.are_cells()) }
    }

    /// The first interval that a set meets, by the place of its least number or, if the set
    /// `is_open` there, of its greatest lower bound.
    #[inline(always)]
    pub(super) fn first(self, place: Place, is_open: bool) -> i32 {
        let from = if is_open || self == Self::HalfOpen { place.above } else { place.at };
        from - i32::from(self.are_cells())
    }

    /// The last interval that a set meets, by its greatest number or least upper bound.
    #[inline(always)]
    pub(super) fn last(self, place: Place, is_open: bool) -> i32 {
        (if is_open { place.at } else { place.above }) - 1
    }

    /// The intervals of a number, or of a bound that `is_open`.
    #[inline(always)]
    pub(super) fn at(self, place: Place, is_open: bool) -> Span {
        Span { first: self.first(place, is_open), last: self.last(place, is_open) }
    }

    /// The intervals of a closed set between two numbers; it may be empty.
    #[inline(always)]
    pub(super) fn span(self, least: Place, greatest: Place) -> Span {
        Span { first: self.first(least, false), last: self.last(greatest, false) }
    }

    /// The two ends of consecutive intervals taken together.
    #[inline(always)]
    pub(super) fn ends(self, Span { first, last }: Span) -> [Level; 2] {
        [self.limit(first), self.limit(last + i32::from(self.are_cells()))]
    }
}
