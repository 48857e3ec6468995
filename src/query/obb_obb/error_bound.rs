//! How far the axes of two oriented boxes may be from the truth, to first order in u, the
//! unit roundoff.
//!
//! Every number is a sum of terms, each a product of operands. Its error is the number of
//! roundings that touch a term, times the sum of the terms' sizes. Let A be the greatest
//! magnitude among the components of the axes and one, and R such that |d|·one ≤ R and, of the
//! half-extents, h·A ≤ R. Products with one, which is a power of two, are exact. d carries one
//! rounding, or three where one box is axis-aligned and given by its corners; its half-extents
//! then one (see `plane_aabb::error_bound`).
//!
//! All in A²·R, but for the coordinates in R:
//!
//! * Coordinates: d has 3; the reach is 6 products of a half-extent with an axis, 1 for the
//!   half-extent, 1 product, 3 sums: 30; their difference, of at most 1 and 6: 7. In all 40;
//!   [`COORDINATE`] = 44.
//! * d·w, or d·(u × v): 6 terms of 2 vectors of axes and d: 3 for d, 2 products, 1 difference,
//!   2 sums. 6·8 = 48.
//! * The reach: 4 products of a half-extent with a determinant of axes, of 6 terms each: 1 for
//!   the half-extent, 2 products and 1 difference and 2 sums for the determinant, 1 product and
//!   3 sums. 24·10 = 240.
//! * Their difference, of at most 6 and 24: 30. In all 318; [`BOXES`] = 340.
//!
//! `error_bound.g` proves both, second orders and underflow included.

use crate::arithmetic::{Arithmetic, Number, greatest};

/// Roundoffs on a coordinate, per R.
const COORDINATE: u16 = 44;
/// Roundoffs on an axis, per A²·R.
const BOXES: u16 = 340;

/// How far computed axes may be from the truth.
pub(super) struct ErrorBound<P> {
    pub(super) coordinate: P,
    pub(super) axis: P,
}

/// The bounds, for axes up to `axes`, of which `one` is one, a way from centre to centre up to
/// `way` and half-extents up to `half`; `None` where they are not known or products may not fit.
#[inline(always)]
pub(super) fn error_bound<N: Arithmetic>(
    one: N::Product,
    axes: N::Product,
    way: N::Product,
    half: N::Product,
) -> Option<ErrorBound<N::Product>> {
    let zero = N::Product::ZERO;
    if N::CERTAIN {
        let in_range = greatest(greatest(axes, way), half).in_range();
        return in_range.then_some(ErrorBound { coordinate: zero, axis: zero });
    }
    let size = greatest(way * one, half * axes);
    let two = one + one;
    // Axes are unit vectors, or near: what is longer may as well go to the end.
    let is_known = axes < two + two && size.in_range();
    is_known.then(|| ErrorBound {
        coordinate: size.error(COORDINATE),
        axis: (axes * axes * size).error(BOXES),
    })
}
