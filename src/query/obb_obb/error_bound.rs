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

use crate::arithmetic::{Arithmetic, Float, Number, Quad, greatest};

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

/// Roundoffs of a gap in a frame, per R.
const ROUNDING: u16 = 180;
/// The most by which a gap in a frame differs from the true one, per tilt and R.
const FRAME: u16 = 28;
/// Roundoffs of the tilt.
const TILT: u16 = 13;

/// The bound for boxes whose axes are `tilt` from orthonormal, in each lane; `None` if the size or
/// the tilt is out of range. R is the size, the greatest magnitude of d and of the half-extents.
///
/// U has the axes of one box as rows, and G = U·Uᵀ differs from I by at most t in each entry, t ≤
/// 2^-6. So G^-1 = I + F with |F| ≤ t/(1 − 3t) ≤ 1.05·t. In the basis of the axes a vector x is
/// G^-1·U·x, and the products of x with the face normals, w_i·x, are that times det U. The filter
/// takes U·x, which errs by F·U·x.
///
/// * x is an axis of the second box: its length is at most 1.008 and |U·x| at most 1.032, so an entry
///   of F·U·x is at most 1.05·t·√3·1.032 < 1.9·t. An entry of U·x is at most 1 + t ≤ 1.016.
/// * x is d, whose length is at most √3·R: likewise 3.24·t·R, and 1.76·R.
///
/// On a face the gap is |w·d| less the reach; both boxes' faces have this form. On u_i × v_j it is,
/// divided by det U and in coordinates δ of d and α of v_j in the basis u, and γ of u_i in the
/// basis v, |δ_m·α_l − δ_l·α_m| less h_l·|α_m| + h_m·|α_l| + ρ·(k_p·|γ_q| + k_q·|γ_p|). ρ is
/// |det V / det U|. det² is det G, which is between 1 − 3t − 6t² − 6t³ and (1 + t)³, so ρ is from
/// 1 − 3.2·t to 1 + 3.2·t. `tilted.g` proves that all this changes a gap by at most [`FRAME`]·t·R.
/// `frames.g` proves at most [`ROUNDING`] roundoffs, and that the tilt as computed errs by at most
/// [`TILT`], with room for the subtraction of one, in whatever scalar the boxes are given.
///
/// The bound holds for all half-extents up to R, including zero. `None` out of range, or if not all axes are
/// known to be short.
#[inline(always)]
pub(super) fn in_frames<Q: Quad<Lane = f32>>(size: Q, tilt: Q, are_short: bool) -> Option<Q> {
    let roundoffs = f32::from(ROUNDING + FRAME * TILT) * f32::ROUNDOFF;
    let error = size * (Q::splat(f32::from(FRAME)) * tilt + Q::splat(roundoffs));
    let [size, tilt] = [size.to_array()[0], tilt.to_array()[0]];
    (size.in_range() & (tilt < 1.0 / 128.0) & are_short).then_some(error)
}
