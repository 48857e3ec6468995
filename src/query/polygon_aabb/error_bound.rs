//! How far the distance between the plane of three vertices of a polygon and a corner of the box
//! may be from the truth, seen from any vertex of the polygon, in units of u·R³.
//!
//! R is the greatest sum, on an axis, of the half-extent of the box and the extent of the
//! polygon. If no face separates, no vertex is farther than R from the centre of the box, and no
//! edge between two vertices is longer than the extent. So operands and steps err as in
//! `triangle_aabb::error_bound`, which uses no more than that: 58 for n·v, 46 for Σ h·|n|, and 12
//! for the difference of the two; in all 116. The worst of the terms never meet: `error_bound.g`
//! proves [`PLANE`].

use crate::arithmetic::{Arithmetic, Number};

/// Roundoffs in the distance.
const PLANE: u16 = 64;

/// The bound for shapes of this size; `None` where it is not known.
#[inline(always)]
pub(super) fn error_bound<N: Arithmetic>(size: N::Length) -> Option<N::Volume> {
    size.in_range().then(|| N::volume(N::area(size, size), size).error(PLANE))
}
