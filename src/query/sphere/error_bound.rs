//! The errors of what compares a distance with a radius.
//!
//! All vectors are differences of points, with one rounding; the ends of a segment given by its
//! centre take two. R is the greatest magnitude of a component. Roundoffs to first order:
//!
//! | number | of | roundoffs | terms |
//! | --- | --- | --- | --- |
//! | component of a × b | R² | 14 | 2 terms: 4 in the operands, 1 in the product; 4 of the difference |
//! | a·b | R² | 20 | 3 terms likewise, 5 of the sums |
//! | (a × b)·c | R³ | 88 | 3 terms of 14 + 2·3, 10 of the sums, and second orders |
//! | (a × b)·(c × d) | R⁴ | 192 | 3 terms of 2·2·14 + 4, 12 of the sums |
//! | p·(q + r) + q·s, all of them a·b | R⁴ | 345 | 5 errors of 20 times 3; 9 of q + r, 36 of the rest |
//!
//! `error_bound.g`, `side.g` and `side_by_dots.g` prove these, second orders and underflow included, and `corners.g`
//! the numbers of vectors from the corners of an oriented box.
//! A square of a number x with an error δ is off by δ·(2·|x| + δ), and the sum of three squares by 3
//! roundings of the sum more. Products of numbers that are not negative are off by a roundoff for
//! each operation.
//!
//! Underflow: R lies where the area R² is in range, so that products of six lengths stay normal
//! numbers, or lose less than the bounds leave. A sum of squares alone has
//! [`UNDERFLOW`](crate::arithmetic::Number::UNDERFLOW) beside its roundoffs.

use crate::arithmetic::{Arithmetic, Number, greatest};

const MINOR: u16 = 18;
const DOT: u16 = 24;
const VOLUME: u16 = 120;
const SIDE: u16 = 240;
const SIDE_BY_DOTS: u16 = 420;
const OF_LENGTHS: [u16; 4] = [MINOR, DOT, VOLUME, SIDE];

// Of vectors from the corners of an oriented box, which are shorter and err by less.
//
// The way e along a capsule is a difference of two of them, and errs by up to a quarter of a roundoff of R, which is not
// relative to e. Still e·e·r² has no more than `PRODUCT` roundoffs of itself as its error, for what `CORNER_MINOR` leaves
// covers the rest. Let k be a roundoff of R². A component of c = e × m errs by half of k, so c·c by 1.73·k·|c| + 0.75·k²,
// and 4·k·|c| + 12·k² are allowed. Where r is at most R, e·e·r² errs by 0.87·k·|e|·r. That is at most 0.87·k·|c| if the line
// lies beyond r, and else the difference allowed for is larger by as much as |e|·r exceeds |c|. Where r is greater than R,
// no point is beyond it.
const CORNER_MINOR: u16 = 2;
const CORNER_DOT: u16 = 3;
const CORNER_VOLUME: u16 = 2;
const CORNER_SIDE: u16 = 2;
const OF_CORNERS: [u16; 4] = [CORNER_MINOR, CORNER_DOT, CORNER_VOLUME, CORNER_SIDE];

/// Roundoffs of a sum of three squares of differences, compared with the square of a radius that
/// may be a sum.
pub(super) const SQUARE: u16 = 12;
/// Roundoffs of a sum of three squares, of itself.
pub(in crate::query) const SQUARES: u16 = 4;
/// Roundoffs of a square times the square of a radius.
pub(in crate::query) const PRODUCT: u16 = 16;

/// The errors of numbers made of lengths up to a size.
pub(in crate::query) struct Errors<N: Arithmetic> {
    /// Of a component of a cross product.
    pub(super) minor: N::Area,
    /// Of a dot product.
    pub(super) dot: N::Area,
    /// Of a cross product times a vector.
    pub(in crate::query) volume: N::Volume,
    /// Of a cross product times another.
    pub(in crate::query) side: N::Quartic,
}

impl<N: Arithmetic> Errors<N> {
    const NONE: Self = Self {
        minor: N::Area::ZERO,
        dot: N::Area::ZERO,
        volume: N::Volume::ZERO,
        side: N::Quartic::ZERO,
    };

    /// The errors for lengths up to `size`, with radii up to `radius`; `None` out of range.
    #[inline(always)]
    pub(in crate::query) fn new(size: N::Length, radius: N::Length) -> Option<Self> {
        if N::CERTAIN {
            return Some(Self::NONE);
        }
        let (area, most) = (N::area(size, size), greatest(size, radius));
        let is_known = area.in_range() & N::area(most, most).in_range();
        is_known.then(|| Self::of_area(area, size, OF_LENGTHS))
    }

    /// The errors for lengths up to `size`, without a radius; `None` out of range.
    #[inline(always)]
    pub(super) fn of_lengths(size: N::Length) -> Option<Self> {
        if N::CERTAIN {
            return Some(Self::NONE);
        }
        let area = N::area(size, size);
        area.in_range().then(|| Self::of_area(area, size, OF_LENGTHS))
    }

    /// The errors of products of a length up to `size` and a component of a direction up to `d`,
    /// which is not a length; `None` out of range.
    #[inline(always)]
    pub(in crate::query) fn with_direction(size: N::Length, d: N::Length) -> Option<Self> {
        if N::CERTAIN {
            return Some(Self::NONE);
        }
        let area = N::area(size, d);
        let is_known = N::area(size, size).in_range() & N::area(d, d).in_range() & area.in_range();
        is_known.then(|| Self::of_area(area, size, OF_LENGTHS))
    }

    /// The error of a cross product of a length up to `size` and a direction up to `d`, times one of
    /// two lengths.
    #[inline(always)]
    pub(in crate::query) fn side_of(size: N::Length, d: N::Length) -> N::Quartic {
        N::quartic(N::area(size, d), N::area(size, size)).error(SIDE)
    }

    /// The error of p·(q + r) + q·s, of dot products of lengths up to `size`.
    #[inline(always)]
    pub(super) fn side_by_dots(size: N::Length) -> N::Quartic {
        if N::CERTAIN {
            return N::Quartic::ZERO;
        }
        let area = N::area(size, size);
        N::quartic(area, area).error(SIDE_BY_DOTS)
    }

    /// The errors of vectors from the corners of an oriented box, which err by up to a roundoff of `size` and are
    /// not much longer than a quarter of it; `None` out of range.
    #[inline(always)]
    pub(super) fn of_corners(size: N::Length, radius: N::Length) -> Option<Self> {
        if N::CERTAIN {
            return Some(Self::NONE);
        }
        let (area, most) = (N::area(size, size), greatest(size, radius));
        let is_known = area.in_range() & N::area(most, most).in_range();
        is_known.then(|| Self::of_area(area, size, OF_CORNERS))
    }

    #[inline(always)]
    fn of_area(area: N::Area, size: N::Length, [minor, dot, volume, side]: [u16; 4]) -> Self {
        Self {
            minor: area.error(minor),
            dot: area.error(dot),
            volume: N::volume(area, size).error(volume),
            side: N::quartic(area, area).error(side),
        }
    }
}
