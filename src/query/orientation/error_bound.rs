//! The error of a computed volume (a × b)·c.
//!
//! a, b and c are differences of points, and A, B and C bound the magnitudes of their components. A
//! difference takes one rounding. For a segment given by its centre it takes two, (p − q) ± h, and
//! its size is the size of p − q plus the size of h. The volume is a sum of 6 terms, each within
//! A·B·C, and at most 11 roundings touch a term. `error_bound.g` proves [`VOLUME`] roundoffs of
//! A·B·C, second orders and underflow included.

use crate::arithmetic::{Arithmetic, Number};

/// Roundoffs in a volume.
const VOLUME: u16 = 70;

/// The bound for vectors of these sizes; `None` if a size is out of range.
#[inline(always)]
pub(in crate::query) fn error_bound<N: Arithmetic>([a, b, c]: [N::Length; 3]) -> Option<N::Volume> {
    if N::CERTAIN {
        return Some(N::Volume::ZERO);
    }
    let is_known = a.in_range() & b.in_range() & c.in_range();
    is_known.then(|| N::volume(N::area(a, b), c).error(VOLUME))
}
