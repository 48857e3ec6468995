//! A triangle, split into signed parts for exact sums.

use core::cmp::Ordering;

use crate::arithmetic::{Parts, pick, turn};
use crate::robust::{ExactSum, Vector, add_area, difference};
use crate::scalar::Scalar;

/// The coordinates of a triangle in signed parts.
pub(crate) struct ExactTriangle {
    pub(crate) v: [[Parts; 3]; 3],
}

impl ExactTriangle {
    pub(crate) fn new<S: Scalar>(points: &[[S; 3]; 3]) -> Self {
        Self { v: points.map(|p| p.map(S::parts)) }
    }

    /// Edge k, from vertex k to the next.
    pub(crate) fn edge(&self, k: usize) -> Vector {
        let (k, next, _) = turn(k);
        let (from, to) = (pick(&self.v, k), pick(&self.v, next));
        core::array::from_fn(|i| difference(to[i], from[i]))
    }

    /// The sign of component `i` of the normal, e0 × e1.
    pub(crate) fn normal_sign<S: Scalar>(&self, i: usize) -> Ordering {
        let (_, j, k) = turn(i);
        let (e0, e1) = (self.edge(0), self.edge(1));
        let mut sum = S::SeptumSum::new();
        add_area(&mut sum, pick(&e0, j), pick(&e1, k), false);
        add_area(&mut sum, pick(&e0, k), pick(&e1, j), true);
        sum.sign()
    }
}
