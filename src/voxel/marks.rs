//! What of an axis the boxes are that a triangle is asked about, one for each index.

use super::place::{Level, Place, Span};

/// The intervals of an axis, numbered as the voxels are.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Marks {
    /// From plane to plane, both included.
    Closed,
    /// From a plane, included, to the next, not included.
    HalfOpen,
    /// The middle between two planes alone.
    Center,
}

/// The marks of each axis: known to the compiler, or not.
pub(super) trait AxisMarks: Copy {
    /// Those of an axis.
    fn of(&self, axis: usize) -> Marks;
}

impl AxisMarks for [Marks; 3] {
    #[inline(always)]
    fn of(&self, axis: usize) -> Marks {
        self[axis]
    }
}

/// Closed on every axis: what is asked for most.
#[cfg(not(feature = "small"))]
pub(super) const ALL_CLOSED: AllClosed = AllClosed;

/// The same in the type of all others, whose code then serves it too: a kilobyte less beside
/// solids, for a fiftieth more time.
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
    /// Whether the limits of the intervals are planes; if not, they are middles.
    #[inline(always)]
    pub(super) fn are_cells(self) -> bool {
        self != Self::Center
    }

    /// How many limits an axis of so many voxels has.
    #[inline(always)]
    pub(super) fn limits(self, voxels: u32) -> i32 {
        voxels as i32 + i32::from(self.are_cells())
    }

    /// How far limit k is from k.
    #[inline(always)]
    pub(super) fn shift(self) -> f64 {
        if self.are_cells() { 0.0 } else { 0.5 }
    }

    /// Limit k, a plane or a middle.
    #[inline(always)]
    pub(super) fn limit(self, k: i32) -> Level {
        Level { from: k, to: k + i32::from(!self.are_cells()) }
    }

    /// The first interval that a set comes to whose least number has this place, or greatest
    /// lower bound, if it `is_open` there.
    #[inline(always)]
    pub(super) fn first(self, place: Place, is_open: bool) -> i32 {
        let from = if is_open || self == Self::HalfOpen { place.above } else { place.at };
        from - i32::from(self.are_cells())
    }

    /// The last interval that it comes to, by its greatest number or least upper bound.
    #[inline(always)]
    pub(super) fn last(self, place: Place, is_open: bool) -> i32 {
        (if is_open { place.at } else { place.above }) - 1
    }

    /// The intervals that a number, or a bound that `is_open`, is at.
    #[inline(always)]
    pub(super) fn at(self, place: Place, is_open: bool) -> Span {
        Span { first: self.first(place, is_open), last: self.last(place, is_open) }
    }

    /// The intervals of a closed set between two numbers, as far as there are any.
    #[inline(always)]
    pub(super) fn span(self, least: Place, greatest: Place) -> Span {
        Span { first: self.first(least, false), last: self.last(greatest, false) }
    }

    /// The two ends of some intervals together, as lines of the grid.
    #[inline(always)]
    pub(super) fn ends(self, Span { first, last }: Span) -> [Level; 2] {
        [self.limit(first), self.limit(last + i32::from(self.are_cells()))]
    }
}
