//! The errors of the computed axes.
//!
//! u is the unit roundoff (2⁻²⁴ for `f32`, 2⁻⁵³ for `f64`). Each operation returns the true result
//! of its operands times (1 + δ), |δ| ≤ u.
//!
//! # Operands
//!
//! No face axis separates, so on each coordinate axis i the triangle meets the box, and |v_i| ≤ X_i
//! = h_i + s_i, where s_i is the triangle's extent along the axis; also |e_i| ≤ s_i. The size R is
//! the greatest of the X_i.
//!
//! * e = b − a: one operation on given numbers, with an error of at most u·s.
//! * v, for a box given by its centre: one operation, u·X. For a box given by its corners, v = ((v
//!   − min) + (v − max))/2: each difference is at most 2X and errs by at most 2u·X, their sum by
//!   4u·X + 2u·X, and its half by 3u·X.
//! * h: exact, or (max − min)/2, with an error of u·h.
//!
//! # Axes
//!
//! On an edge axis the kernel computes |p + m| − (|m| + r), with p = e_j·v_l − e_l·v_j, m half of
//! n_i = e_j·e'_l − e_l·e'_j, and r = h_j·|e_l| + h_l·|e_j|. `edges.g` proves that this errs by at
//! most [`EDGE`] roundoffs of R². On the normal it computes |n·v| − Σ h·|n|; `plane.g` proves at
//! most [`PLANE`] roundoffs of R³. The proofs include second orders, the rounding of R and of the
//! bounds, and underflow, which the range of R limits (see `arithmetic::float`).
//!
//! # By offsets
//!
//! [`Offset`](crate::arithmetic::Offset) rounds once, or twice in `f64`, where the first rounding
//! is 2⁻²⁹ of the second. From the two corners of a box `f32` rounds three times, which matters
//! only for a triangle prepared for many boxes.
//!
//! * v: one operation, u·X. In a prepared triangle it is the sum of two offsets, from the vertex to
//!   the first vertex and from there to the box: 3u·X. That also holds in `f32` for a box given by
//!   its corners. Let the first vertex lie at a distance A from the centre on an axis, and a second
//!   vertex at d from the first. The magnitudes of the first vertex's differences from the corners
//!   sum to 2·max(h, A), and the differences sum to 2A. So the first vertex errs by u·(max(h, A) +
//!   A), and the second by u·(d + |v|) more, with d ≤ s. If A ≤ h, then |v| ≤ h + s, and the error
//!   is at most 3h + 2s in all. Otherwise, if the second vertex lies farther out, |v| = A + d, and
//!   the sum 2A + d + |v| is at most 3·|v|, because no face separates. If it lies farther in, the
//!   error is at most 3A, or 3d if it lies beyond the centre.
//! * e: the difference of any two offsets: 3u·X.
//! * h: u·h.
//!
//! On a coordinate axis a prepared triangle errs by 3, h by 1, and their difference, at most 2, by
//! 2 more, in units of u·X: 6. `offset_faces.g`, `offset_edges.g` and `offset_plane.g` prove
//! [`OFFSET_FACE`], [`OFFSET_EDGE`] and [`OFFSET_PLANE`]. The last two exceed the proved errors by
//! a whole roundoff of R² and R³. So an axis that is certain by offsets is also certain in `f64`,
//! whose bounds are below 2⁻²³ of that roundoff.

use crate::arithmetic::{Arithmetic, Filtered, Number};

/// Roundoffs on an edge axis, per R².
const EDGE: u16 = 24;

/// Roundoffs on the normal, per R³.
const PLANE: u16 = 60;

/// Roundoffs by offsets: on a coordinate axis, on an edge axis, on the normal.
pub(super) const OFFSET_FACE: u16 = 7;
const OFFSET_EDGE: u16 = 40;
const OFFSET_PLANE: u16 = 100;

/// The gap, per R, R² and R³, that survives the truncation of coordinates: see `conservative.rs`.
const COARSE: f32 = 1.0 / 512.0;

/// Error bounds of the computed axes.
#[derive(Clone, Copy)]
pub(crate) struct ErrorBound<N: Arithmetic> {
    pub(crate) edge: N::Area,
    pub(crate) plane: N::Volume,
}

/// The bounds for shapes of this size; `None` if the size is out of range.
#[inline(always)]
pub(in crate::query) fn error_bound<N: Arithmetic>(size: N::Length) -> Option<ErrorBound<N>> {
    if N::CERTAIN {
        return Some(ErrorBound { edge: N::Area::ZERO, plane: N::Volume::ZERO });
    }
    size.in_range().then(|| bound_of_size::<N>(size))
}

/// The same, for callers that know the size to be in range, or check it later.
#[inline(always)]
pub(crate) fn bound_of_size<N: Arithmetic>(size: N::Length) -> ErrorBound<N> {
    let square = N::area(size, size);
    ErrorBound { edge: square.error(EDGE), plane: N::volume(square, size).error(PLANE) }
}

/// The bounds for offsets.
#[inline(always)]
pub(super) fn offset_bound(size: f32) -> ErrorBound<Filtered<f32>> {
    let square = size * size;
    ErrorBound { edge: square.error(OFFSET_EDGE), plane: (square * size).error(OFFSET_PLANE) }
}

/// The gaps that survive the truncation of coordinates: on a coordinate axis, and on the other
/// axes.
#[inline(always)]
pub(super) fn coarse_bound(size: f32) -> (f32, ErrorBound<Filtered<f32>>) {
    let face = size * COARSE;
    (face, ErrorBound { edge: face * size, plane: face * size * size })
}
