//! How far a computed volume (a × b)·c may be from the truth.
//!
//! To first order in u, the unit roundoff. a, b and c are differences of points. A, B and C
//! are sizes: no component of the vector is greater. A segment given by its centre takes two
//! roundings for a difference, (p − q) ± h, and its size is that of p − q plus that of h; all
//! else takes one.
//!
//! The volume is a sum of 6 terms, each within A·B·C. At most 11 roundings touch a term: 2 for
//! each of the three vectors, 2 products, 1 difference of products, 2 sums. 6·11 = 66;
//! [`VOLUME`] = 70.
//!
//! `error_bound.g` proves it, second orders and underflow included.

use crate::arithmetic::{Arithmetic, Number};

/// Roundoffs in a volume.
const VOLUME: u16 = 70;

/// The bound for vectors of these sizes; `None` where it is not known.
#[inline(always)]
pub(in crate::query) fn error_bound<N: Arithmetic>([a, b, c]: [N::Length; 3]) -> Option<N::Volume> {
    if N::CERTAIN {
        return Some(N::Volume::ZERO);
    }
    let is_known = a.in_range() & b.in_range() & c.in_range();
    is_known.then(|| N::volume(N::area(a, b), c).error(VOLUME))
}
