//! How far the numbers of a triangle that moves past a box may be from the truth, to first order
//! in u, the unit roundoff.
//!
//! No face separates all of the way, so on each coordinate axis the box, the triangle at the
//! start and the way together span no more than X_i = h_i + s_i + |d_i|, with h the half-extent,
//! s the triangle's extent and d the displacement; no vertex is farther from the centre of the
//! box, and no edge longer. The size R is the greatest of the X_i. Every number is a sum of
//! terms, each a product of two or three of these and so within R² or R³: its error is the number
//! of roundings that touch a term, summed over the terms. A vertex v in the frame of the box
//! carries up to three roundings, all else one.
//!
//! * An axis x_i × e_k, |p + m + w| − (|m| + |w| + r), with p = e_j·v_l − e_l·v_j, m half of n_i,
//!   w half of (e_k × d)_i and r = h_j·|e_l| + h_l·|e_j|. A term of p is touched by 4 (e, v),
//!   1 product, 1 difference, 2 sums and the last difference: 9. One of m or w by 2, 1, 1, 2 and
//!   1: 7; on the right likewise. One of r by 2, 1, 1, 2 and 1: 7. There are 2 of p, and, halves
//!   of two each, 1 of m, 1 of w, the same on the right, and 2 of r: 18 + 28 + 14 = 60.
//!   An axis x_i × d, the same with d for e and without m and w: below that. [`EDGE`] = 64.
//! * The plane, |n·v + w| − (|w| + Σ h·|n|), with w half of n·d. A term of n·v is touched by 5 (e,
//!   e', v), 2 products, 1 difference, 2 sums, 1 sum with w and the last difference: 11. One of w
//!   by 3, 2, 1, 2, 1 and 1: 10; on the right likewise. One of Σ h·|n| by 3, 2, 1, 2, 1 and 1: 10.
//!   There are 6, 3, 3 and 6: 66 + 60 + 60 = 186. An axis e_k × d, |q·v − w| − (|w| + Σ h·|q|) with
//!   q = e_k × d, has the same terms. [`VOLUME`] = 200.
//! * A speed, (e_k × d)_i: 2 terms, touched by 2, 1 product and 1 difference: 8. [`AREA_SPEED`] =
//!   10. n·d: 6 terms, touched by 3, 2, 1 and 2: 48. [`VOLUME_SPEED`] = 52.
//! * A face. The gap g at the start errs by one rounding, or with a box given by its centre by
//!   two, the first of which is relative to at most g + h. d errs by one, and so does the
//!   difference of the two: at most 4·u·(g + h + |d|). [`FACE`] = 6.
//!
//! * At a time t on the way (`instants`), |p + m| − (|m| + r) and its like move by t·s, with s the
//!   speed. What was w is t·s, once and not on both sides: its terms are touched by 2, 1, 1, the
//!   product with t, a sum: 6 each of an area, 12 in all. One of p is touched by 9, of m by 6, of r
//!   by 6, as before or less: 18 + 12 + 12 + 12 = 54, below [`EDGE`]. On the normal an n·v term is
//!   touched by 10, one of t·n·d by 9, of Σ h·|n| by 9: 60 + 54 + 54 = 168, below [`VOLUME`]. A
//!   face has a product with t besides, which errs by u·|d|: at most 5·u·(g + h + |d|).
//!
//! `edge.g`, `volume.g`, `speed.g` and `face.g` prove these, second orders and underflow included;
//! `edge_instant.g`, `volume_instant.g` and `face_instant.g` those of a time.
//!
//! In numbers of 106 digits (`arithmetic::long`), in units of u² and to first order: edges and d
//! are exact. n_i is a difference of two products within R², of which each errs by 5 and the
//! difference by 3 of itself: 16. From vertex to corner is at most 2·R, and errs by 3 of itself.
//! Its product with n_i, at most 4·R³, errs by 16·2 + 6·2 + 5·4 = 64; three of them 192, and their
//! sums 3·(8 + 12) = 60. A component of n of the wrong sign, which is within its error, takes
//! the wrong corner: 2·16·R³ each, 96. n·d: 16 + 5·2 for each product, 78, and sums 3·(4 + 6): 108.
//! So gap − t·speed, with t ≤ 1 and the product of speed and t at most 6·R³, errs by 252 + 96 +
//! 108 + 5·6 + 3·18 = 540. An axis x_i × e_k, whose components are exact, and a face have less.
//! [`LONG`] = 2^-96 is 1,024·u².
//!
//! The gaps at the start, on the axes that do not move, have the bounds of
//! `triangle_aabb::error_bound`, whose sizes are within these.

use crate::arithmetic::{Arithmetic, Number};
use crate::query::triangle_aabb::error_bound::{ErrorBound, error_bound};

/// Roundoffs on a face, per g + h + |d|.
pub(super) const FACE: u16 = 6;
/// Roundoffs on an axis with areas, per R².
const EDGE: u16 = 64;
/// Roundoffs on one with volumes, per R³.
const VOLUME: u16 = 200;
/// Roundoffs in a speed that is an area, per R².
const AREA_SPEED: u16 = 10;
/// Roundoffs in one that is a volume, per R³.
const VOLUME_SPEED: u16 = 52;

/// How far what is left of a gap in numbers of 106 digits may be from the truth, per R, R² or R³.
pub(super) const LONG: f64 = f64::from_bits((1023 - 96) << 52);

/// How far computed axes may be from the truth, all along the way.
#[derive(Clone, Copy)]
pub(super) struct Along<N: Arithmetic> {
    pub(super) area: N::Area,
    pub(super) volume: N::Volume,
}

/// The bounds for shapes and a way of this size; `None` where they are not known.
#[inline(always)]
pub(super) fn along<N: Arithmetic>(size: N::Length) -> Option<Along<N>> {
    if N::CERTAIN {
        return Some(Along { area: N::Area::ZERO, volume: N::Volume::ZERO });
    }
    let square = N::area(size, size);
    let volume = N::volume(square, size);
    size.in_range().then(|| Along { area: square.error(EDGE), volume: volume.error(VOLUME) })
}

/// The same of gaps at the start, and of speeds.
pub(super) struct AtStart<N: Arithmetic> {
    pub(super) gap: ErrorBound<N>,
    pub(super) area_speed: N::Area,
    pub(super) volume_speed: N::Volume,
}

/// The bounds for shapes and a way of this size; `None` where they are not known.
#[inline(always)]
pub(super) fn at_start<N: Arithmetic>(size: N::Length) -> Option<AtStart<N>> {
    let square = N::area(size, size);
    Some(AtStart {
        gap: error_bound::<N>(size)?,
        area_speed: square.error(AREA_SPEED),
        volume_speed: N::volume(square, size).error(VOLUME_SPEED),
    })
}
