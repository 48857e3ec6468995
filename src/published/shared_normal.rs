//! Triangle and box by the kernel of the exact test, in the scalar's own arithmetic. Its nine edge
//! axes share the normal.

use crate::query::disjoint_rounded;
use crate::scalar::Scalar;
use crate::shape::{Aabb, Triangle};

/// Does the triangle overlap the box? In the scalar's own arithmetic, every result rounded: fast,
/// and sometimes wrong.
///
/// It is the kernel of [`Triangle::overlaps`] without its error bound.
///
/// *Numerics*: it errs in both directions on slivers, far from the origin, and within rounding of
/// contact. In fixed point, products lose their last bits and wrap around outside the range, and
/// then it errs often. It is here for comparison, and for drawing.
///
/// *Panics*: never. *Cost*: 21 comparisons, 48 multiplications.
///
/// *Source*: Akenine-Möller 2001; the shared normal is ours.
#[inline]
pub fn overlaps<S: Scalar>(triangle: &Triangle<S>, aabb: &Aabb<S>) -> bool {
    !disjoint_rounded(triangle, aabb)
}
