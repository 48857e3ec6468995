//! The errors of the axes of a triangle and an oriented box. u is the unit roundoff.
//!
//! Each projection is a sum of terms, and each term a product of operands. A is the greatest
//! magnitude among the components of the axes u_i and one. R is such that |t|·one ≤ R, |e|·one ≤ R
//! and h·A ≤ R. t and e carry one rounding each. Products with one, a power of two, are exact. One
//! is 1 in floats and at least 1 in fixed point, so R bounds |t| and |e| too, and a term with one
//! and two lengths is within R². `error_bound.g` proves the bounds:
//!
//! * a face, w·t against h·|u·w|, errs by at most [`FACE`] roundoffs of A²·R;
//! * an edge, all doubled, by at most [`EDGE`] roundoffs of A·R²;
//! * the plane, n·t against Σ h·|u·n|, by at most [`PLANE`] roundoffs of R³.
//!
//! The proofs include second orders and underflow. A is at least one, so R has the range that it
//! has for an axis-aligned box (see `arithmetic::float`).

use super::kernel::ErrorBound;
use crate::arithmetic::{Arithmetic, Number, greatest};

/// Roundoffs in a face axis, per A²·R.
const FACE: u16 = 100;
/// Roundoffs in an edge axis, per A·R².
const EDGE: u16 = 550;
/// Roundoffs in the plane, per R³.
const PLANE: u16 = 300;

/// The bounds, for axes up to `axes`, in a unit in which `one` is one, lengths up to `length` and
/// half-extents up to `half`. `None` outside the range of the bounds, or if products may not fit.
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
    // Axes are unit vectors, or nearly. Longer ones go to the last stage.
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

    /// Each term of a face, an edge or the plane is a product of four numbers, in a unit in which
    /// `one` is one.
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
