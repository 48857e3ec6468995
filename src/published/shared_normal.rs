//! Triangle and box by the kernel of the exact test, whose nine edge axes share the normal,
//! in the scalar's own arithmetic.

use crate::query::disjoint_rounded;
use crate::scalar::Scalar;
use crate::shape::{Aabb, Triangle};

/// The overlap test in the scalar's own arithmetic, every result rounded:
/// fast, and sometimes wrong.
///
/// The same kernel as [`Triangle::overlaps`] without its error bound.
///
/// *Numerics*: on slivers, far from the origin, and within rounding of
/// contact it errs either way; in fixed point products lose their last bits
/// and wrap beyond the range, and then it errs often. Here for comparison,
/// and for those who draw with it.
///
/// *Panics*: never. *Cost*: 21 comparisons, 48 multiplications.
///
/// *Source*: Akenine-Möller 2001; the shared normal is ours.
#[inline]
pub fn overlaps<S: Scalar>(triangle: &Triangle<S>, aabb: &Aabb<S>) -> bool {
    !disjoint_rounded(triangle, aabb)
}
