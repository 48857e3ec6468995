//! How far the computed axes may be from the truth.
//!
//! All to first order in u, the unit roundoff (2⁻²⁴ for `f32`, 2⁻⁵³ for `f64`);
//! the last paragraph accounts for the rest. Each operation returns the true
//! result of its operands times (1 + δ), |δ| ≤ u. A circumflex marks what was
//! computed.
//!
//! # Operands
//!
//! No face axis separates, so on each coordinate axis i the triangle meets the
//! box, and |v_i| ≤ X_i = h_i + s_i, where s_i is the triangle's extent along
//! that axis; also |e_i| ≤ s_i. The size R is the greatest of the X_i.
//!
//! * e = b − a: one operation on given numbers, error at most u·s.
//! * v, box given by its centre: one operation, u·X. By its corners,
//!   ((v − min) + (v − max))/2: each difference is at most 2X, so each errs by at
//!   most 2u·X, their sum by 4u·X + 2u·X, and half of it by 3u·X.
//! * h: exact, or (max − min)/2, u·h.
//!
//! # An edge axis, in units of u·X_j·X_l
//!
//! * p = e_j·v_l − e_l·v_j: each product errs by 1 (e) + 3 (v) + 1 (itself) = 5,
//!   the difference, at most 2, by 2 more: 12.
//! * n_i = e_j·e'_l − e_l·e'_j: each product errs by 3, the difference by 2: 8.
//!   Its half, m, by 4; |m| ≤ 1.
//! * p + m, at most 3: 12 + 4 + 3 = 19.
//! * r = h_j·|e_l| + h_l·|e_j|: each product errs by 3 times itself, the sum by 1
//!   time; with h_j·s_l + h_l·s_j ≤ 1 (in these units: X_j·X_l) that is 4.
//! * |m| + r: 4 + 4, and 2 for the two additions, for |m| + r ≤ s_j·s_l + h_j·s_l
//!   + h_l·s_j ≤ 1: 10.
//!
//! So |p + m| and |m| + r together err by at most 29·u·X_j·X_l ≤ 29·u·R². That is
//! with all three X alike at the worst.
//!
//! # The plane, in units of u·W with W = X_0·X_1·X_2 ≤ R³
//!
//! * n_i errs by 8·s_j·s_l and is at most 2·s_j·s_l.
//! * n_i·v_i: 8 + 2·3 + 2 = 16, each at most 2. Three of them 48, their two sums,
//!   at most 4 and 6, 10 more: 58.
//! * h_i·|n_i|: 8 + 2 + 2 = 12, three of them 36, their sums 10: 46.
//! * the difference of the two, each at most 6: 12.
//!
//! So n·v − Σ h·|n| errs by at most 116·u·R³.
//!
//! # What the first order leaves out
//!
//! Terms in u² are below 2·29²·u² of the first-order terms' unit, a relative
//! 10⁻⁴ for `f32`. The computed R may fall short by 4u·R, and the bound by 4u of
//! itself. The rounding of the last difference
//! is u times a number that is itself near the bound. Underflow is met by the range of
//! R, see `arithmetic::float`.
//!
//! # By offsets
//!
//! [`Offset`](crate::arithmetic::Offset) rounds once, or in `f64` twice, the first time by 2⁻²⁹ of the
//! second. But from the two corners of a box `f32` rounds three times, of which only a triangle prepared
//! for many boxes makes use.
//!
//! * v: one operation, u·X. Of a prepared triangle it is the sum of two offsets, from vertex to first
//!   vertex and from there to the box: 3u·X. That holds by corners in `f32` too. Let the first vertex lie
//!   A from the centre on an axis, and another d from the first. The differences from the corners are
//!   2·max(h, A) together, and their sum 2A: the first vertex errs by u·(max(h, A) + A), the other by
//!   u·(d + |v|) more, with d ≤ s. Where A ≤ h, |v| ≤ h + s: at most 3h + 2s in all. Else, if the other
//!   lies farther out, |v| = A + d, and 2A + d + |v| ≤ 3·|v|, for no face separates. If it lies farther
//!   in, that is at most 3A, or beyond the centre 3d.
//! * e: the difference of two of either kind: 3u·X.
//! * h: u·h.
//!
//! In units of u·X_j·X_l p errs by 2·(3 + 3 + 1) + 2 = 16, m by 8, p + m by 27; r by 3·2 for e, and 3:
//! 9; |m| + r by 19. In all 46. The plane, in units of u·W: n_i by 16, n_i·v_i by 16 + 2·3 + 2 = 24, three
//! of them and their sums 82; h_i·|n_i| by 16 + 2 + 2 = 20, three and their sums 70; the difference 12: 164.
//! On a coordinate axis a prepared triangle errs by 3, h by 1, and their difference, at most 2, by 2, in
//! units of u·X: 6.
//!
//! # What is proved
//!
//! The sums above take the worst of each term, which never meet. `edges.g` and
//! `plane.g` prove [`EDGE`] and [`PLANE`], second orders and underflow included; `offset_faces.g`,
//! `offset_edges.g` and `offset_plane.g` those of offsets.
//!
//! The last two leave a whole roundoff of R² and R³. So what is certain by offsets is certain in `f64`
//! too, whose bounds are below 2⁻²³ of one.

use crate::arithmetic::{Arithmetic, Filtered, Number};

/// Roundoffs in an edge axis, per R².
const EDGE: u16 = 24;

/// Roundoffs in the plane, per R³.
const PLANE: u16 = 60;

/// Roundoffs by offsets: in a coordinate axis, in an edge axis, in the plane.
const OFFSET_FACE: u16 = 7;
const OFFSET_EDGE: u16 = 40;
const OFFSET_PLANE: u16 = 100;

/// By how much of R, R² and R³ an axis separates that does so when coordinates are cut down:
/// `conservative.rs`.
const COARSE: f32 = 1.0 / 512.0;

/// How far computed axes may be from the truth.
#[derive(Clone, Copy)]
pub(in crate::query) struct ErrorBound<N: Arithmetic> {
    pub(in crate::query) edge: N::Area,
    pub(in crate::query) plane: N::Volume,
}

/// The bounds for shapes of this size; `None` where they are not known.
#[inline(always)]
pub(in crate::query) fn error_bound<N: Arithmetic>(size: N::Length) -> Option<ErrorBound<N>> {
    if N::CERTAIN {
        return Some(ErrorBound { edge: N::Area::ZERO, plane: N::Volume::ZERO });
    }
    size.in_range().then(|| bound_of_size::<N>(size))
}

/// The same, for a caller who knows that the size is in range, or asks later.
#[inline(always)]
pub(super) fn bound_of_size<N: Arithmetic>(size: N::Length) -> ErrorBound<N> {
    let square = N::area(size, size);
    ErrorBound { edge: square.error(EDGE), plane: N::volume(square, size).error(PLANE) }
}

/// By offsets.
#[inline(always)]
pub(super) fn offset_bound(size: f32) -> ErrorBound<Filtered<f32>> {
    let square = size * size;
    ErrorBound { edge: square.error(OFFSET_EDGE), plane: (square * size).error(OFFSET_PLANE) }
}

/// Those of a triangle prepared for many boxes on coordinate axes, by offsets.
#[inline(always)]
pub(super) fn offset_face(size: f32) -> f32 {
    size.error(OFFSET_FACE)
}

/// Which gaps are left when coordinates are cut down: on a coordinate axis, and on the others.
#[inline(always)]
pub(super) fn coarse_bound(size: f32) -> (f32, ErrorBound<Filtered<f32>>) {
    let face = size * COARSE;
    (face, ErrorBound { edge: face * size, plane: face * size * size })
}
