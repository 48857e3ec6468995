//! The error of the computed distance between the plane of three vertices of a polygon and a corner
//! of the box, seen from any vertex of the polygon, in units of u·R³.
//!
//! R is the greatest sum, over the axes, of the half-extent of the box and the extent of the
//! polygon. If no face separates, every vertex is within R of the centre of the box, and no edge is
//! longer than the extent. The steps and their operands are those of `triangle_aabb::error_bound`.
//! `error_bound.g` proves [`PLANE`].

use crate::arithmetic::{Arithmetic, Number};

/// Roundoffs in the distance.
const PLANE: u16 = 64;

/// The bound for shapes of this size; `None` if the size is out of range.
#[inline(always)]
pub(super) fn error_bound<N: Arithmetic>(size: N::Length) -> Option<N::Volume> {
    size.in_range().then(|| N::volume(N::area(size, size), size).error(PLANE))
}
