//! The last stage of two boxes, of which at least one is oriented: exact sums of products of the
//! given numbers. Each term has four factors.

use core::cmp::Ordering;

use super::{First, Lie};
use crate::arithmetic::{Parts, three, turn};
use crate::query::relation::{Relation, of_gaps};
use crate::robust::{ExactSum, Linear, Vector, add_scaled_determinant, difference, single};
use crate::scalar::Scalar;
use crate::shape::{AabbForm, Obb};

/// An axis of a box and its half-extent, as the sum of two numbers.
struct Extent {
    axis: Vector,
    half: [Parts; 2],
}

/// Two boxes in exact parts.
pub(super) struct ExactBoxes {
    /// The difference of the centres.
    d: Vector,
    extents: [Extent; 6],
}

/// Twice the number.
fn twice(x: Parts) -> Parts {
    Parts { shift: x.shift + 1, ..x }
}

impl ExactBoxes {
    pub(super) fn new<S: Scalar>(lie: &Lie<'_, S>) -> Self {
        let parts = |p: [S; 3]| p.map(S::parts);
        let second = lie.second;
        let [b, k] = [second.center(), second.half_extents()].map(|v| parts(v.to_array()));
        let vector = |of: &dyn Fn(usize) -> Linear| [of(0), of(1), of(2)];
        let axes = |obb: &Obb<S>| obb.axes().map(|u| u.to_array().map(|x| single(x.parts())));
        let along = three(|i| {
            let zero = single(Parts::ZERO);
            let mut axis = [zero; 3];
            axis[i] = single(S::ONE);
            axis
        });
        let pairs = |half: [Parts; 3]| half.map(|h| [h, Parts::ZERO]);
        let (d, u, h, k) = match lie.first {
            First::Obb(first) => {
                let [a, h] = [first.center(), first.half_extents()].map(|v| parts(v.to_array()));
                (vector(&|i| difference(b[i], a[i])), axes(first), pairs(h), pairs(k))
            }
            First::Aabb(first) => match first.form() {
                AabbForm::Center { center, half } => {
                    let [a, h] = [center, half].map(|v| parts(v.to_array()));
                    (vector(&|i| difference(b[i], a[i])), along, pairs(h), pairs(k))
                }
                // Everything is doubled, because the centre need not be a number of the scalar.
                AabbForm::Corners { min, max } => {
                    let [p, q] = [min, max].map(|v| parts(v.to_array()));
                    let d = vector(&|i| [twice(b[i]), p[i].negated(), q[i].negated()]);
                    let h = three(|i| [q[i], p[i].negated()]);
                    (d, along, h, pairs(k.map(twice)))
                }
            },
        };
        let extent = |axis: Vector, half: [Parts; 2]| Extent { axis, half };
        let ([u0, u1, u2], [v0, v1, v2]) = (u, axes(second));
        let ([h0, h1, h2], [k0, k1, k2]) = (h, k);
        let first = [extent(u0, h0), extent(u1, h1), extent(u2, h2)];
        let second = [extent(v0, k0), extent(v1, k1), extent(v2, k2)];
        let ([a, b, c], [e, f, g]) = (first, second);
        Self { d, extents: [a, b, c, e, f, g] }
    }

    /// The relation of the boxes from the 15 axes.
    pub(super) fn relation<S: Scalar>(&self) -> Relation {
        let mut so_far = Relation::Overlapping;
        for i in 0..3 {
            let (_, j, k) = turn(i);
            so_far = so_far.min(self.axis::<S>(j, k)).min(self.axis::<S>(3 + j, 3 + k));
            for other in 3..6 {
                so_far = so_far.min(self.axis::<S>(i, other));
            }
            if so_far == Relation::Disjoint {
                break;
            }
        }
        so_far
    }

    /// The relation on the cross product of two axes.
    fn axis<S: Scalar>(&self, a: usize, b: usize) -> Relation {
        let (a, b) = (&self.extents[a].axis, &self.extents[b].axis);
        let determinant = |sum: &mut S::SeptumSum, x: &Vector, factor: Parts| {
            add_scaled_determinant(sum, a, b, x, factor);
        };
        // The distance by which the second box stays beyond the first, on both sides.
        of_gaps([Ordering::Greater, Ordering::Less].map(|side| {
            let mut sum = S::SeptumSum::new();
            determinant(&mut sum, &self.d, S::ONE);
            for Extent { axis, half } in &self.extents {
                let mut product = S::SeptumSum::new();
                determinant(&mut product, axis, S::ONE);
                let is_against = product.sign() == side;
                for h in half {
                    determinant(&mut sum, axis, if is_against { h.negated() } else { *h });
                }
            }
            if side.is_gt() { sum.sign() } else { sum.sign().reverse() }
        }))
    }
}
