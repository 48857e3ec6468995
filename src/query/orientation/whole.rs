//! Points in whole numbers, whose signs are certain.

use core::cmp::Ordering;

use super::Points;
use crate::arithmetic::{Arithmetic, Number, compare, cross, dot, each, pick, turn};

/// Six points in a number system that is certain.
pub(crate) struct Whole<N: Arithmetic>(pub(crate) [[N::Length; 3]; 6]);

impl<N: Arithmetic> Whole<N> {
    /// A point. There is one; to say so links no panic.
    fn point(&self, a: usize) -> &[N::Length; 3] {
        let [first, ..] = &self.0;
        self.0.get(a).unwrap_or(first)
    }

    fn difference(&self, a: usize, b: usize) -> [N::Length; 3] {
        let (a, b) = (self.point(a), self.point(b));
        [a[0] - b[0], a[1] - b[1], a[2] - b[2]]
    }
}

fn sign<T: Number>(x: T) -> Ordering {
    compare(x, T::ZERO)
}

impl<N: Arithmetic> Points for Whole<N> {
    fn volume(&self, [a, b, c, d]: [usize; 4]) -> Ordering {
        let [b, c, d] = each([b, c, d], |x| self.difference(x, a));
        sign(dot::<N>(&cross::<N>(&b, &c), &d))
    }

    fn area(&self, axis: usize, [a, b, c]: [usize; 3]) -> Ordering {
        let (_, j, k) = turn(axis);
        let (b, c) = (self.difference(b, a), self.difference(c, a));
        sign(N::area(b[j], c[k]) - N::area(b[k], c[j]))
    }

    fn compare(&self, axis: usize, [a, b]: [usize; 2]) -> Ordering {
        sign(*pick(self.point(a), axis) - *pick(self.point(b), axis))
    }
}
