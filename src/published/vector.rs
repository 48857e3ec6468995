//! Operations on three rounded numbers.

use crate::arithmetic::Rounded;
use crate::scalar::Scalar;
use crate::shape::Ray;

/// A vector in the scalar's own arithmetic.
pub(crate) type Triple<S> = [Rounded<S>; 3];

#[inline(always)]
pub(crate) fn rounded<S>([x, y, z]: [S; 3]) -> Triple<S> {
    [Rounded(x), Rounded(y), Rounded(z)]
}

/// The origin and the direction of a ray.
#[inline(always)]
pub(crate) fn line<S: Scalar>(ray: &Ray<S>) -> (Triple<S>, Triple<S>) {
    (rounded(ray.origin().to_array()), rounded(ray.direction().to_array()))
}

/// Component `i` of three, by its address, because a branch on the index would be unpredictable.
#[inline(always)]
pub(super) fn by_index<T>(x: &[T; 3], i: u8) -> &T {
    &x[if i < 3 { usize::from(i) } else { 0 }]
}
