//! The last stage of a point and a triangle: exact sums.

use core::cmp::Ordering;

use crate::robust::{ExactSum, Vector, add_area, add_determinant, difference};
use crate::scalar::Scalar;

/// The sign of (v − u) × (p − u) by the second and the third coordinate.
pub(super) fn turn<S: Scalar>(p: &[S; 3], u: &[S; 3], v: &[S; 3]) -> Ordering {
    let between = |to: &[S; 3], i: usize| difference(to[i].parts(), u[i].parts());
    let mut sum = S::Sum::new();
    add_area(&mut sum, &between(v, 1), &between(p, 2), false);
    add_area(&mut sum, &between(v, 2), &between(p, 1), true);
    sum.sign()
}

/// The sign of (a − p)·((b − p) × (c − p)).
pub(super) fn volume<S: Scalar>(p: &[S; 3], points: &[[S; 3]; 3]) -> Ordering {
    let from_p =
        |q: &[S; 3]| -> Vector { core::array::from_fn(|i| difference(q[i].parts(), p[i].parts())) };
    let [a, b, c] = [from_p(&points[0]), from_p(&points[1]), from_p(&points[2])];
    let mut sum = S::Sum::new();
    add_determinant(&mut sum, &b, &c, &a);
    sum.sign()
}
