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
