//! Products of short words, and the size of vectors.

use crate::arithmetic::{InRaw, ProductSum, Word};
use crate::shape::Vec3;

/// A sum of products.
pub(super) type Sum = <i32 as Word>::Sum;

#[inline(always)]
pub(in crate::query) fn raw<S: InRaw>(v: &Vec3<S>) -> [S::Raw; 3] {
    [v.x.raw(), v.y.raw(), v.z.raw()]
}

/// A number at least as great as each of the numbers, and less than twice the greatest.
#[inline(always)]
pub(in crate::query) fn size<W: Word, const K: usize>(x: &[[W; 3]; K]) -> W {
    let mut size = W::ZERO;
    for x in x {
        size = size | x[0].folded() | x[1].folded() | x[2].folded();
    }
    size
}

/// The cross product over 2^19, rounded down.
#[inline(always)]
pub(super) fn cross(a: &[i32; 3], b: &[i32; 3]) -> [i32; 3] {
    let area = |j: usize, l: usize| Sum::new(a[j], b[l], -a[l], b[j]).scaled_by(9);
    [area(1, 2), area(2, 0), area(0, 1)]
}

/// The product over 2^10, rounded down.
#[inline(always)]
pub(super) fn product(a: &[i32; 3], b: &[i32; 3]) -> i32 {
    product_over(a, b, 0)
}

/// The product over 2^10 and 2^`places`, rounded down.
#[inline(always)]
pub(super) fn product_over(a: &[i32; 3], b: &[i32; 3], places: u32) -> i32 {
    Sum::new(a[0], b[0], a[1], b[1]).with_product(a[2], b[2]).scaled_by(places)
}
