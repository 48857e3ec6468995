//! The error of the computed distance between a plane and a corner of a box, in units of u·(N·R +
//! |d|), with u the unit roundoff.
//!
//! N is the greatest magnitude among the components of the normal n. v is the plane's point and h
//! the half-extents, both in the box's frame, and R is their greatest magnitude. The kernel
//! computes n·v and Σ h·|n| and subtracts them. Each v errs by up to 3 (see
//! `triangle_aabb::error_bound`). The count to first order is 36.
//!
//! For a plane given by its offset d, v is the world's origin in the box's frame and errs by 1.
//! Adding d adds 1 rounding, and the count is 33, plus 2 for |d|.
//!
//! `error_bound.g` proves [`PLANE`], second orders and underflow included.

use crate::arithmetic::{Arithmetic, Number};

/// Roundoffs in the distance.
const PLANE: u16 = 40;

/// The bound for normals up to `normal`, lengths up to `size`, and an offset times one of up to
/// `offset`. `None` if a size is out of range.
#[inline(always)]
pub(super) fn error_bound<N: Arithmetic>(
    normal: N::Length,
    size: N::Length,
    offset: N::Area,
) -> Option<N::Area> {
    let sum = N::area(normal, size) + offset;
    (normal.in_range() && size.in_range()).then(|| sum.error(PLANE))
}
