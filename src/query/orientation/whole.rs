//! Points in an exact number system.

use core::cmp::Ordering;

use super::{FIRST, Points, Relation, SECOND};
use crate::arithmetic::{Arithmetic, Each, cross, dot, greatest, least, minus3, pick, sign, turn};

/// Six points in an exact number system.
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
}

impl<N: Arithmetic> Points for Whole<N> {
    fn volume(&self, [a, b, c, d]: [usize; 4]) -> Ordering {
        let [b, c, d] = [b, c, d].each(|x| self.difference(x, a));
        sign(dot::<N>(&cross::<N>(&b, &c), &d))
    }

    fn area(&self, axis: usize, [a, b, c]: [usize; 3]) -> Ordering {
        let (_, j, k) = turn(axis);
        let (b, c) = (self.difference(b, a), self.difference(c, a));
        sign(N::area(b[j], c[k]) - N::area(b[k], c[j]))
    }

    fn sides(&self, [a, b, c]: [usize; 3], of: [usize; 3]) -> [Ordering; 3] {
        let n = cross::<N>(&self.difference(b, a), &self.difference(c, a));
        of.each(|d| sign(dot::<N>(&n, &self.difference(d, a))))
    }

    fn sides_of_line(&self, axis: usize, [a, b]: [usize; 2], of: [usize; 3]) -> [Ordering; 3] {
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

    fn along_axis(&self, axis: usize) -> Relation {
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

    fn compare(&self, axis: usize, [a, b]: [usize; 2]) -> Ordering {
        sign(*pick(self.point(a), axis) - *pick(self.point(b), axis))
    }
}
