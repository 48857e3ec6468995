//! Sides of planes in a number system, with error bounds.

use super::error_bound;
use crate::arithmetic::{Arithmetic, Number, cross, dot, greatest, largest};
use crate::robust::certain_sign;

/// Three lengths.
pub(crate) type Vector<N> = [<N as Arithmetic>::Length; 3];

/// a − b.
#[inline(always)]
pub(crate) fn from<N: Arithmetic>(a: &Vector<N>, b: &Vector<N>) -> Vector<N> {
    [a[0] - b[0], a[1] - b[1], a[2] - b[2]]
}

/// The greatest magnitude in two vectors.
#[inline(always)]
pub(crate) fn larger<N: Arithmetic>(a: &Vector<N>, b: &Vector<N>) -> N::Length {
    greatest(largest(a), largest(b))
}

/// The sides of the plane spanned by two edges to which these vectors point: zero in doubt, and in
/// an exact number system on the plane. `None` if the error is unknown.
#[inline(always)]
pub(crate) fn sides<N: Arithmetic, const K: usize>(
    [e, f]: [&Vector<N>; 2],
    vectors: &[Vector<N>; K],
    size: N::Length,
) -> Option<[i8; K]> {
    let edges = if N::CERTAIN { N::Length::ZERO } else { larger::<N>(e, f) };
    let error = error_bound::<N>([edges, edges, size])?;
    let n = cross::<N>(e, f);
    let mut signs = [0; K];
    for k in 0..K {
        signs[k] = certain_sign(dot::<N>(&n, &vectors[k]), error);
    }
    Some(signs)
}

/// The greatest magnitude in these vectors; zero in an exact number system, which needs none.
#[inline(always)]
pub(crate) fn size<N: Arithmetic, const K: usize>(vectors: &[Vector<N>; K]) -> N::Length {
    let mut size = N::Length::ZERO;
    if !N::CERTAIN {
        for v in vectors {
            size = greatest(size, largest(v));
        }
    }
    size
}

/// Whether a coordinate separates the points `some` from `others`.
#[inline(never)]
pub(crate) fn are_apart<T: PartialOrd>(some: &[[T; 3]], others: &[[T; 3]]) -> bool {
    // By `get`, because indices are checked in builds for small code.
    let is_below = |i, p: &[T; 3], q: &[T; 3]| p.get(i).zip(q.get(i)).is_some_and(|(p, q)| p < q);
    let all_below = |i: usize, some: &[[T; 3]], others: &[[T; 3]]| {
        some.iter().all(|p| others.iter().all(|q| is_below(i, p, q)))
    };
    (0..3).any(|i| all_below(i, some, others) || all_below(i, others, some))
}

/// Whether `some` and `others` share a point.
#[inline(never)]
pub(crate) fn share_a_point<T: PartialEq>(some: &[[T; 3]], others: &[[T; 3]]) -> bool {
    some.iter().any(|p| others.contains(p))
}
