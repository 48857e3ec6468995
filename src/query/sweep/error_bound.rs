//! The errors of the computed numbers of a triangle that moves past a box. u is the unit roundoff.
//!
//! No face separates all the way. On each coordinate axis the box, the triangle at the start and
//! the motion together therefore span at most X_i = h_i + s_i + |d_i|, with h the half-extent, s
//! the triangle's extent and d the displacement. No vertex is farther from the box's centre, and no
//! edge is longer. The size R is the greatest of the X_i. Vertices in the box's frame carry up to
//! three roundings, all other operands one.
//!
//! * On an axis x_i × e_k the kernel computes |p + m + w| − (|m| + |w| + r), with p = e_j·v_l −
//!   e_l·v_j, m half of n_i, w half of (e_k × d)_i, and r = h_j·|e_l| + h_l·|e_j|. `edge.g` proves
//!   that this errs by at most [`EDGE`] roundoffs of R². An axis x_i × d has the same terms with d
//!   for e, without m and w.
//! * On the normal it computes |n·v + w| − (|w| + Σ h·|n|), with w half of n·d. `volume.g` proves
//!   at most [`VOLUME`] roundoffs of R³. An axis e_k × d has the same terms with q = e_k × d: |q·v
//!   − w| − (|w| + Σ h·|q|).
//! * The speed along an axis is (e_k × d)_i or n·d. `speed.g` proves at most [`AREA_SPEED`]
//!   roundoffs of R² and [`VOLUME_SPEED`] of R³.
//! * On a face the gap g at the start loses |d|. `face.g` proves that the rest errs by at most
//!   [`FACE`] roundoffs of g + h + |d|.
//! * At a time t (`instants`) the gap is |p + m| − (|m| + r), or its like, moved by t·s, with s the
//!   speed. `edge_instant.g`, `volume_instant.g` and `face_instant.g` prove the same bounds there.
//!
//! The proofs include second orders. They include underflow too, except that a face at a time t
//! also needs the least normal number.
//!
//! Double-word floats (`arithmetic::double`) have errors in units of u², here to first order.
//! Edges and d are exact. A component n_i is a difference of two products within R²: each product
//! errs by 5, and the difference by 3 of itself, together 16. The vector from vertex to corner is
//! at most 2·R and errs by 3 of itself. Its product with n_i is at most 4·R³ and errs by 16·2 +
//! 6·2 + 5·4 = 64; three products err by 192, and their sums by 3·(8 + 12) = 60. If a component of
//! n has the wrong sign, it lies within its error and selects the wrong corner: 2·16·R³ each,
//! together 96. In n·d each product errs by 16 + 5·2, together 78, and the sums by 3·(4 + 6),
//! together 108. With t ≤ 1 and a product of speed and t of at most 6·R³, gap − t·speed errs by
//! 252 + 96 + 108 + 5·6 + 3·18 = 540. An axis x_i × e_k, whose components are exact, errs by less,
//! and so does a face. [`LONG`] = 2^-96 is 1,024·u².
//!
//! The gaps at the start, on axes without d, have the bounds of `triangle_aabb::error_bound`, whose
//! sizes are within these.

use crate::arithmetic::{Arithmetic, Number, exp2};
use crate::query::triangle_aabb::error_bound::{ErrorBound, error_bound};

/// Roundoffs on a face, per g + h + |d|.
pub(super) const FACE: u16 = 6;
/// Roundoffs on an axis with areas, per R².
const EDGE: u16 = 64;
/// Roundoffs on an axis with volumes, per R³.
const VOLUME: u16 = 200;
/// Roundoffs in a speed that is an area, per R².
const AREA_SPEED: u16 = 10;
/// Roundoffs in a speed that is a volume, per R³.
const VOLUME_SPEED: u16 = 52;

/// How far gap − t·speed in 106 digits may be from the truth, per R, R² or R³.
pub(super) const LONG: f64 = exp2(-96);

/// How far computed axes may be from the truth at any time of the motion.
#[derive(Clone, Copy)]
pub(super) struct Along<N: Arithmetic> {
    pub(super) area: N::Area,
    pub(super) volume: N::Volume,
}

/// The bounds for shapes and a motion of this size; `None` outside the range where they hold.
#[inline(always)]
pub(super) fn along<N: Arithmetic>(size: N::Length) -> Option<Along<N>> {
    if N::CERTAIN {
        return Some(Along { area: N::Area::ZERO, volume: N::Volume::ZERO });
    }
    let square = N::area(size, size);
    let volume = N::volume(square, size);
    size.in_range().then(|| Along { area: square.error(EDGE), volume: volume.error(VOLUME) })
}

/// The bounds for gaps at the start, and for speeds.
pub(super) struct AtStart<N: Arithmetic> {
    pub(super) gap: ErrorBound<N>,
    pub(super) area_speed: N::Area,
    pub(super) volume_speed: N::Volume,
}

/// The bounds for shapes and a motion of this size; `None` outside the range where they hold.
#[inline(always)]
pub(super) fn at_start<N: Arithmetic>(size: N::Length) -> Option<AtStart<N>> {
    let gap = error_bound::<N>(size)?;
    if N::CERTAIN {
        let (area_speed, volume_speed) = (N::Area::ZERO, N::Volume::ZERO);
        return Some(AtStart { gap, area_speed, volume_speed });
    }
    let square = N::area(size, size);
    Some(AtStart {
        gap,
        area_speed: square.error(AREA_SPEED),
        volume_speed: N::volume(square, size).error(VOLUME_SPEED),
    })
}
