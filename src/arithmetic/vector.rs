//! Products of vectors in a number system.

use super::Arithmetic;

/// a × b.
#[inline(always)]
pub(crate) fn cross<N: Arithmetic>(a: &[N::Length; 3], b: &[N::Length; 3]) -> [N::Area; 3] {
    let minor = |j: usize, k: usize| N::area(a[j], b[k]) - N::area(a[k], b[j]);
    [minor(1, 2), minor(2, 0), minor(0, 1)]
}

/// a·b.
#[inline(always)]
pub(crate) fn dot<N: Arithmetic>(a: &[N::Area; 3], b: &[N::Length; 3]) -> N::Volume {
    N::volume(a[0], b[0]) + N::volume(a[1], b[1]) + N::volume(a[2], b[2])
}
