//! Points in a number system: the sides of planes on which they lie, with error bounds or exactly.

use core::cmp::Ordering;

use super::{Relation, error_bound};
use crate::arithmetic::{
    Arithmetic, Each, Number, cross, dot, greatest, largest, least, minus3, pick, sign, turn,
};
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

/// The vertices of the first shape, and of the second.
pub(super) const FIRST: [usize; 3] = [0, 1, 2];
pub(super) const SECOND: [usize; 3] = [3, 4, 5];

/// Six points in an exact number system: the vertices of the first shape and of the second.
pub(crate) struct Whole<N: Arithmetic>(pub(crate) [[N::Length; 3]; 6]);

impl<N: Arithmetic> Whole<N> {
    /// A point. The index is in range; `unwrap_or` links no panic.
    fn point(&self, a: usize) -> &[N::Length; 3] {
        let [first, ..] = &self.0;
        self.0.get(a).unwrap_or(first)
    }

    fn difference(&self, a: usize, b: usize) -> [N::Length; 3] {
        minus3(self.point(a), self.point(b))
    }

    /// The side of the plane through a, b and c on which d lies: the sign of ((b − a) × (c − a))·(d − a).
    pub(super) fn volume(&self, [a, b, c, d]: [usize; 4]) -> Ordering {
        let [b, c, d] = [b, c, d].each(|x| self.difference(x, a));
        sign(dot::<N>(&cross::<N>(&b, &c), &d))
    }

    /// The sign of component `axis` of (b − a) × (c − a).
    pub(super) fn area(&self, axis: usize, [a, b, c]: [usize; 3]) -> Ordering {
        let (_, j, k) = turn(axis);
        let (b, c) = (self.difference(b, a), self.difference(c, a));
        sign(N::area(b[j], c[k]) - N::area(b[k], c[j]))
    }

    /// The sides of the plane through a, b and c on which the points `of` lie.
    pub(super) fn sides(&self, [a, b, c]: [usize; 3], of: [usize; 3]) -> [Ordering; 3] {
        let n = cross::<N>(&self.difference(b, a), &self.difference(c, a));
        of.each(|d| sign(dot::<N>(&n, &self.difference(d, a))))
    }

    /// The sides of the line through a and b on which the points `of` lie, in the projection along
    /// `axis`.
    pub(super) fn sides_of_line(
        &self,
        axis: usize,
        [a, b]: [usize; 2],
        of: [usize; 3],
    ) -> [Ordering; 3] {
        let (_, j, k) = turn(axis);
        let a = self.point(a);
        let from = |x: usize| {
            let x = self.point(x);
            [*pick(x, j) - *pick(a, j), *pick(x, k) - *pick(a, k)]
        };
        let e = from(b);
        of.each(|x| {
            let v = from(x);
            sign(N::area(e[0], v[1]) - N::area(e[1], v[0]))
        })
    }

    /// The nearest relation that coordinate `axis` allows.
    pub(super) fn along_axis(&self, axis: usize) -> Relation {
        let ends = |of: [usize; 3]| {
            let [x, y, z] = of.each(|x| *pick(self.point(x), axis));
            (least(least(x, y), z), greatest(greatest(x, y), z))
        };
        let ((a, b), (c, d)) = (ends(FIRST), ends(SECOND));
        if (b > c) == (a < d) {
            Relation::Overlapping
        } else if a == d || b == c {
            Relation::Touching
        } else {
            Relation::Disjoint
        }
    }
}
