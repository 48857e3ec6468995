//! The place of a coordinate among the planes of a grid: by floats if their error bound permits,
//! otherwise by exact comparisons.

use core::cmp::Ordering;

/// The place of a number among planes in rising order: the first plane not below it and the first
/// plane above it. They differ if the number lies on a plane.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Place {
    pub(super) at: i32,
    pub(super) above: i32,
}

impl Place {
    /// Between plane k − 1 and plane k.
    #[inline(always)]
    pub(super) const fn before(k: i32) -> Self {
        Self { at: k, above: k }
    }

    /// On plane k.
    pub(super) const fn on(k: i32) -> Self {
        Self { at: k, above: k + 1 }
    }

    #[inline(always)]
    pub(super) fn least(self, other: Self) -> Self {
        Self { at: self.at.min(other.at), above: self.above.min(other.above) }
    }

    #[inline(always)]
    pub(super) fn greatest(self, other: Self) -> Self {
        Self { at: self.at.max(other.at), above: self.above.max(other.above) }
    }
}

/// A range of cells, both ends included; empty where the first is above the last.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Span {
    pub(super) first: i32,
    pub(super) last: i32,
}

impl Span {
    pub(super) const EMPTY: Self = Self { first: i32::MAX, last: i32::MIN };

    #[inline(always)]
    pub(super) const fn is_empty(self) -> bool {
        self.first > self.last
    }

    /// One cell.
    #[inline(always)]
    pub(super) const fn one(k: i32) -> Self {
        Self { first: k, last: k }
    }

    /// The intersection of two spans.
    #[inline(always)]
    pub(super) fn common(self, other: Self) -> Self {
        Self { first: self.first.max(other.first), last: self.last.min(other.last) }
    }

    /// The least span that holds two spans.
    #[inline(always)]
    pub(super) fn joined(self, other: Self) -> Self {
        Self { first: self.first.min(other.first), last: self.last.max(other.last) }
    }
}

/// The middle between two planes of a grid, or one plane, given twice.
#[derive(Clone, Copy, Debug)]
pub(super) struct Level {
    pub(super) from: i32,
    pub(super) to: i32,
}

impl Level {
    /// Plane k.
    #[inline(always)]
    pub(super) const fn plane(k: i32) -> Self {
        Self { from: k, to: k }
    }

    /// The place of the level, in cells.
    #[inline(always)]
    pub(super) fn middle(self) -> f64 {
        // Halves first: the sum of two planes at 2^30 overflows `i32`.
        0.5 * f64::from(self.from) + 0.5 * f64::from(self.to)
    }
}

/// Finds the place of a number X that is not before `low` and not behind `high`. |X − x| < `error`,
/// and `plane(k)` compares plane k with X exactly.
#[inline(always)]
pub(super) fn locate(
    x: f64,
    error: f64,
    low: Place,
    high: Place,
    plane: impl Fn(i32) -> Ordering,
) -> Place {
    if low == high {
        return low;
    }
    // Clamp to half a cell beyond the planes in question, clear of the next planes.
    let (least, greatest) = (f64::from(low.at) - 0.5, f64::from(high.above) - 0.5);
    let x = if x < least { least } else { x };
    let x = if x > greatest { greatest } else { x };
    let (nearest, k) = nearest_whole(x);
    let rest = x - nearest;
    // A NaN fails this comparison and is in doubt.
    if rest.abs() > error {
        return Place::before(k + i32::from(rest > 0.0));
    }
    search(if error < 0.5 { Some(k) } else { None }, low, high, plane)
}

/// Finds the place by exact comparisons: with plane k = `doubt` only, or by bisection.
#[cold]
#[inline(never)]
fn search(doubt: Option<i32>, low: Place, high: Place, plane: impl Fn(i32) -> Ordering) -> Place {
    let (mut from, mut to) = doubt.map_or((low.at, high.above), |k| (k, k + 1));
    // Planes before `from` are below X, planes from `to` on are above X.
    while from < to {
        let middle = from + (to - from) / 2;
        match plane(middle) {
            Ordering::Less => from = middle + 1,
            Ordering::Equal => return Place::on(middle),
            Ordering::Greater => to = middle,
        }
    }
    Place::before(from)
}

/// Rounds a number with a magnitude below 2³¹ to the nearest whole number.
#[inline(always)]
fn nearest_whole(x: f64) -> (f64, i32) {
    // Beside 1.5·2^52 the last place is 1, and the last bits are the whole number.
    const SHIFTER: f64 = (3_u64 << 51) as f64;
    let shifted = x + SHIFTER;
    (shifted - SHIFTER, shifted.to_bits() as i32)
}

// The intervals of an axis that a rule tests, one for each index: cells or their middles.

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
