//! Products of vectors in a number system.

use super::Arithmetic;
use super::index::three;

/// a × b.
#[inline(always)]
pub(crate) fn cross<N: Arithmetic>(a: &[N::Length; 3], b: &[N::Length; 3]) -> [N::Area; 3] {
    three(|i| {
        let (j, k) = ((i + 1) % 3, (i + 2) % 3);
        N::minor([a[j], b[k]], [a[k], b[j]])
    })
}

/// a·b.
#[inline(always)]
pub(crate) fn dot<N: Arithmetic>(a: &[N::Area; 3], b: &[N::Length; 3]) -> N::Volume {
    N::dot(a, b)
}
