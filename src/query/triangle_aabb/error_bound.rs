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
//! # What is proved
//!
//! The sums above take the worst of each term, which never meet. `edges.g` and
//! `plane.g` prove [`EDGE`] and [`PLANE`], second orders and underflow included.

use crate::arithmetic::{Arithmetic, Number};

/// Roundoffs in an edge axis, per R².
const EDGE: u16 = 24;

/// Roundoffs in the plane, per R³.
const PLANE: u16 = 60;

/// How far computed axes may be from the truth.
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
