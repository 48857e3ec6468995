//! The errors of the axes of two oriented boxes. u is the unit roundoff.
//!
//! Each computed number is a sum of terms, and each term a product of operands. A is the greatest
//! magnitude among the components of the axes and one. R is such that |d|·one ≤ R and, for all
//! half-extents, h·A ≤ R. Products with one, a power of two, are exact. d carries one rounding. If
//! one box is axis-aligned and given by its corners, d carries three and its half-extents one (see
//! `plane_aabb::error_bound`).
//!
//! * On a coordinate the kernel compares |d| with six products of a half-extent and an axis.
//!   `error_bound.g` proves that the difference errs by at most [`COORDINATE`] roundoffs of R.
//! * On all other axes it compares d·w or d·(u × v) with four products of a half-extent and a
//!   determinant of axes. `error_bound.g` proves at most [`BOXES`] roundoffs of A²·R.
//!
//! The proofs include second orders and underflow.

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

/// The bounds, for axes up to `axes`, in a unit in which `one` is one, a difference of the centres
/// up to `way` and half-extents up to `half`. `None` outside the range of the bounds, or if
/// products may not fit.
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
    // Axes are unit vectors, or nearly. Longer ones go to the last stage.
    let is_known = axes < two + two && size.in_range();
    is_known.then(|| ErrorBound {
        coordinate: size.error(COORDINATE),
        axis: (axes * axes * size).error(BOXES),
    })
}
