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
//! that axis; also |e_i| ≤ s_i. The reach R is the greatest of the X_i.
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
//! with all three X alike at the worst; the constant below is [`AREAS`] = 30.
//!
//! # The plane, in units of u·W with W = X_0·X_1·X_2 ≤ R³
//!
//! * n_i errs by 8·s_j·s_l and is at most 2·s_j·s_l.
//! * n_i·v_i: 8 + 2·3 + 2 = 16, each at most 2. Three of them 48, their two sums,
//!   at most 4 and 6, 10 more: 58.
//! * h_i·|n_i|: 8 + 2 + 2 = 12, three of them 36, their sums 10: 46.
//! * the difference of the two, each at most 6: 12.
//!
//! So n·v − Σ h·|n| errs by at most 116·u·R³; [`VOLUMES`] = 120.
//!
//! # What the first order leaves out
//!
//! Terms in u² are below 2·29²·u² of the first-order terms' unit, a relative
//! 10⁻⁴ for `f32`. The computed R may fall short by 4u·R, and the bound by 4u of
//! itself. 30 against 29 and 120 against 116 are 3 % more: enough for all of it.
//! Underflow is met by the range of R, see `scalar::float`.
//!
//! # A box with axes of its own (`axis::skewed`)
//!
//! Here every product is a sum of terms, each a product of operands; count how
//! many roundings touch a term, and multiply by the sum of the terms' sizes. Let
//! |u| ≤ A, |t| and |e| ≤ R and h·A ≤ R; t and e carry one rounding each.
//!
//! * Faces, in A²·R: w·t has 6 terms; w takes 2 roundings, t 1, the product 1,
//!   the sums 2: 36. h·|u·w|: 6 terms, 2 + 1 + 2 + 1: 36. Their comparison,
//!   with the bound added to one side, 12: 84. [`SKEWED`] has 100.
//! * Edges, doubled, in A·R²: p has 6 terms of 2 + 1 + 1 + 1 + 2 = 7: 42. q
//!   likewise 42. 2p + q: 84 + 42 + 18 for the last sum. |q| again: 42. r has 12
//!   terms of h·w·e, 2 + 1 + 1 + 2 + 1 + 1 = 8: 96, doubled 192. The last sum and
//!   difference, of at most 30 and 48: 78. In all 456; 550.
//! * Plane, in R³: n·t has 6 terms of 2 + 1 + 1 + 1 + 1 + 2 = 8: 48. r has 18
//!   terms of 7 + 1 + 2 = 10: 180. The difference, of at most 24: 24. In all 252;
//!   300.
//!
//! Underflow: A is at least one, for the one that stands in for an axis is counted
//! among them; so the margins of the range of R are as above.
//!
//! # A plane and an axis-aligned box, in units of u·(N·R + |d|)
//!
//! With |n| ≤ N and the plane's point and the half-extents within R in the box's
//! frame: n·v has 3 terms of 3 + 1 + 2 = 6: 18. Σ h·|n| has 3 of 1 + 1 + 2: 12.
//! Their comparison 6. In all 36; with an offset, 33 and 2 for d. [`PLANE`] = 40. A plane
//! given by its offset d has no point; then v is the world's origin, and d joins
//! the sum.

//! # A ray and a triangle, in units of u·D·E·R
//!
//! With D the sum of the direction's components, all taken as positive, E that of
//! both edges, and R that of the edges and the way to the origin. Edges and that way
//! carry one rounding each, the direction none.
//!
//! * det, u and v are 6 terms each, one for every way to pick one component of each
//!   of three vectors: together at most the product of the three sums. Each term is
//!   touched by at most 7 roundings: 2 differences, 2 products, 1 difference, 2 sums.
//!   So 7; [`RAY`] = 8. So is t, in units of u·E·E·R.
//! * w = det − u − v: 3·7, and 2 and 3 for the two differences: 26; [`RAY_SIDES`] =
//!   30.
//!
//! D, E and R are themselves computed with up to 6 roundings; there is more to spare.
//! Underflow: each of the three is within the range of R above, so u times the product
//! of any two exceeds by far what an operation can lose.

use crate::scalar::Numbers;

/// Roundoffs in a volume of ray and triangle.
pub(crate) const RAY: u8 = 8;

/// Roundoffs in the barycentric coordinate that is a difference of the others.
pub(crate) const RAY_SIDES: u8 = 30;

/// Roundoffs in the distance between a plane and a corner of a box.
pub(crate) const PLANE: u8 = 40;

/// Roundoffs in a face axis, an edge axis and the plane of a box with axes of its
/// own, per A²·R, A·R² and R³.
pub(crate) const SKEWED: [u16; 3] = [100, 550, 300];

/// Roundoffs in an edge axis, per R².
const AREAS: u8 = 30;

/// Roundoffs in the plane, per R³.
const VOLUMES: u8 = 120;

/// How far computed areas and volumes may be from the truth, for operands that
/// reach to `reach`; `None` where that is not known.
#[inline(always)]
pub(crate) fn bounds<N: Numbers>(reach: N::Length) -> Option<(N::Area, N::Volume)> {
    N::bounds(reach, AREAS, VOLUMES)
}
