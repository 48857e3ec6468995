//! How far the axes of a triangle and an oriented box may be from the truth, to first order
//! in u, the unit roundoff.
//!
//! Every projection is a sum of terms, each a product of operands. Its error is the number
//! of roundings that touch a term, times the sum of the terms' sizes. Let A be the greatest
//! magnitude among the components of the axes u_i and one, and R such that |t|·one and
//! |e|·one ≤ R and h·A ≤ R. t and e carry one rounding each. Products with one, which is
//! a power of two, are exact. One is 1 in floats and no less in fixed point, so R bounds
//! |t| and |e| too, and a term that has one once and two lengths is within R².
//!
//! * Faces, in A²·R: w·t has 6 terms; w takes 2 roundings, t 1, the product 1,
//!   the sums 2: 36. h·|u·w|: 6 terms, 2 + 1 + 2 + 1: 36. Their comparison,
//!   with the bound added to one side, 12: 84; [`FACE`] = 100.
//! * Edges, doubled, in A·R²: p has 6 terms of 2 + 1 + 1 + 1 + 2 = 7: 42. q
//!   likewise 42. 2p + q: 84 + 42 + 18 for the last sum. |q| again: 42. r has 12
//!   terms of h·w·e, 2 + 1 + 1 + 2 + 1 + 1 = 8: 96, doubled 192. The last sum and
//!   difference, of at most 30 and 48: 78. In all 456; [`EDGE`] = 550.
//! * Plane, in R³: n·t has 6 terms of 2 + 1 + 1 + 1 + 1 + 2 = 8: 48. r has 18
//!   terms of 7 + 1 + 2 = 10: 180. The difference, of at most 24: 24. In all 252;
//!   [`PLANE`] = 300.
//!
//! Underflow: A is at least one, so the margins of the range of R are those of an
//! axis-aligned box (see `arithmetic::float`).
//!
//! `error_bound.g` proves all three bounds, second orders and underflow included.

use super::kernel::ErrorBound;
use crate::arithmetic::{Arithmetic, Number, greatest};

/// Roundoffs in a face axis, per A²·R.
const FACE: u16 = 100;
/// Roundoffs in an edge axis, per A·R².
const EDGE: u16 = 550;
/// Roundoffs in the plane, per R³.
const PLANE: u16 = 300;

/// The bounds, for axes up to `axes`, of which `one` is one, lengths up to `length` and
/// half-extents up to `half`; `None` where they are not known or the products may not fit.
pub(in crate::query) fn error_bound<N: Arithmetic>(
    one: N::Product,
    axes: N::Product,
    length: N::Product,
    half: N::Product,
) -> Option<ErrorBound<N::Product>> {
    let zero = N::Product::ZERO;
    if N::CERTAIN {
        let in_range = greatest(greatest(axes, length), half).in_range();
        return in_range.then_some(ErrorBound { face: zero, edge: zero, plane: zero });
    }
    let size = greatest(length * one, half * axes);
    let two = one + one;
    // Axes are unit vectors, or near: what is longer may as well go to the end.
    if !(axes < two + two && size.in_range()) {
        return None;
    }
    let square = size * size;
    Some(ErrorBound {
        face: (axes * axes * size).error(FACE),
        edge: (axes * square).error(EDGE),
        plane: (square * size).error(PLANE),
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::arithmetic::Filtered;

    /// Each term of a face, an edge or the plane is a product of four numbers in the unit of
    /// which there are `one` in one.
    #[test]
    fn bounds_grow_with_the_unit_as_terms_do() {
        for half in [0.0, 0.01, 3.0] {
            let bound = |one: f64| {
                error_bound::<Filtered<f64>>(one, one, 1.5 * one, half * one).expect("in range")
            };
            for bits in [1, 8, 16, 31] {
                let one = f64::from(1_u32 << bits);
                let (plain, scaled) = (bound(1.0), bound(one));
                let fourth = one * one * one * one;
                assert!(scaled.face >= plain.face * fourth, "{half} {bits}");
                assert!(scaled.edge >= plain.edge * fourth, "{half} {bits}");
                assert!(scaled.plane >= plain.plane * fourth, "{half} {bits}");
            }
        }
    }
}
