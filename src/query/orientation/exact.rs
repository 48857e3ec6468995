//! The last stage: the same signs from exact sums of products of the original coordinates.

use core::cmp::Ordering;
use core::marker::PhantomData;

use super::Points;
use crate::arithmetic::{Parts, each, pick, three, turn};
use crate::robust::{ExactSum, Linear, Vector, add_area, add_determinant, sign};
use crate::scalar::Scalar;
use crate::shape::{Segment, SegmentForm};

/// Six points, each coordinate as the sum of two signed parts.
pub(crate) struct ExactPoints<S> {
    points: [[[Parts; 2]; 3]; 6],
    scalar: PhantomData<S>,
}

/// A point with its original coordinates.
fn given<S: Scalar>(p: [S; 3]) -> [[Parts; 2]; 3] {
    each(p, |x| [x.parts(), Parts::ZERO])
}

impl<S: Scalar> ExactPoints<S> {
    pub(crate) fn new(first: &[[S; 3]; 3], second: &[[S; 3]; 3]) -> Self {
        let ([a, b, c], [d, e, f]) = (each(*first, given), each(*second, given));
        Self { points: [a, b, c, d, e, f], scalar: PhantomData }
    }

    pub(crate) fn of_segment(segment: &Segment<S>, triangle: &[[S; 3]; 3]) -> Self {
        let [a, b] = match segment.form() {
            SegmentForm::Ends(a, b) => [given(a.to_array()), given(b.to_array())],
            SegmentForm::Center { center, half } => {
                let (c, h) = (center.to_array().map(S::parts), half.to_array().map(S::parts));
                let end = |minus: bool| {
                    core::array::from_fn(|i| [c[i], if minus { h[i].negated() } else { h[i] }])
                };
                [end(true), end(false)]
            }
        };
        let [c, d, e] = each(*triangle, given);
        Self { points: [a, b, b, c, d, e], scalar: PhantomData }
    }

    /// A coordinate of a point. The index is in range; `unwrap_or` links no panic.
    fn coordinate(&self, point: usize, axis: usize) -> [Parts; 2] {
        let [first, ..] = &self.points;
        *pick(self.points.get(point).unwrap_or(first), axis)
    }

    fn difference(&self, a: usize, b: usize, axis: usize) -> Linear {
        let ([a, b], [c, d]) = (self.coordinate(a, axis), self.coordinate(b, axis));
        // Only the ends of a segment are sums, and they share one centre.
        if a == c {
            [b, d.negated(), Parts::ZERO]
        } else if d == Parts::ZERO {
            [a, b, c.negated()]
        } else {
            debug_assert!(b == Parts::ZERO);
            [a, c.negated(), d.negated()]
        }
    }

    fn vector(&self, a: usize, b: usize) -> Vector {
        three(|axis| self.difference(a, b, axis))
    }
}

impl<S: Scalar> Points for ExactPoints<S> {
    fn volume(&self, [a, b, c, d]: [usize; 4]) -> Ordering {
        let mut sum = S::Sum::new();
        add_determinant(&mut sum, &self.vector(b, a), &self.vector(c, a), &self.vector(d, a));
        sum.sign()
    }

    fn area(&self, axis: usize, [a, b, c]: [usize; 3]) -> Ordering {
        let (_, j, k) = turn(axis);
        let from = |x: usize, axis: usize| self.difference(x, a, axis);
        let mut sum = S::Sum::new();
        add_area(&mut sum, &from(b, j), &from(c, k), false);
        add_area(&mut sum, &from(b, k), &from(c, j), true);
        sum.sign()
    }

    fn compare(&self, axis: usize, [a, b]: [usize; 2]) -> Ordering {
        sign::<S::Sum>(&self.difference(a, b, axis))
    }
}
