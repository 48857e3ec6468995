//! How far the distance between a plane and a corner of a box may be from the truth, in
//! units of u·(N·R + |d|), with u the unit roundoff.
//!
//! Let N be the greatest magnitude among the components of the normal n. Let v be the
//! plane's point and h the half-extents, both in the box's frame, and R their greatest
//! magnitude.
//!
//! * n·v: v errs by up to 3 (see `triangle_aabb::error_bound`). 3 terms of 3 + 1 + 2 = 6: 18.
//! * Σ h·|n|: 3 terms of 1 + 1 + 2 = 4: 12.
//! * Their difference, of at most 3 and 3: 6. In all 36; [`PLANE`] = 40.
//!
//! A plane given by its offset d has no point. v is the world's origin then. Differences
//! from zero are exact, so v errs by 1: 3 terms of 1 + 1 + 2 = 4: 12. To take d from n·v adds
//! 3 and 1 for d, and the last difference 1 more for d. In all 33, and 2 for d.
//!
//! `error_bound.g` proves the bound, second orders and underflow included.

use crate::arithmetic::{Arithmetic, Number};

/// Roundoffs in the distance.
const PLANE: u16 = 40;

/// The bound, for normals up to `normal`, lengths up to `size` and an offset times one
/// of up to `offset`; `None` where it is not known.
#[inline(always)]
pub(super) fn error_bound<N: Arithmetic>(
    normal: N::Length,
    size: N::Length,
    offset: N::Area,
) -> Option<N::Area> {
    if N::CERTAIN {
        return Some(N::Area::ZERO);
    }
    let sum = N::area(normal, size) + offset;
    (normal.in_range() && size.in_range()).then(|| sum.error(PLANE))
}
