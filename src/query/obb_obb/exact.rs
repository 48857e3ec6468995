//! Two boxes, of which at least one is oriented, exactly. The last stage is exact sums of products of
//! the given numbers; each term has four factors. Before it integers in a window of 120 bits compute the
//! axes that floats leave open.

use core::cmp::Ordering;

use super::{First, Lie};
use crate::arithmetic::{BigInt, Each, Embeds, Float, Number, Parts, Window, cross, dot, three};
use crate::query::relation::{Nearness, Reading, Relation, of_gaps};
use crate::robust::{ExactSum, Linear, Vector, add_determinant, along_axis, difference, singles};
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
        let parts = |p: [S; 3]| p.each(S::parts);
        let second = lie.second;
        let [b, k] = [second.center(), second.half_extents()].each(|v| parts(v.to_array()));
        let vector = |of: &dyn Fn(usize) -> Linear| [of(0), of(1), of(2)];
        let axes = |obb: &Obb<S>| obb.axes_as_arrays().each(singles);
        let along = three(|i| along_axis(i, S::ONE));
        let pairs = |half: [Parts; 3]| half.each(|h| [h, Parts::ZERO]);
        let (d, u, h, k) = match lie.first {
            First::Obb(first) => {
                let [a, h] = [first.center(), first.half_extents()].each(|v| parts(v.to_array()));
                (vector(&|i| difference(b[i], a[i])), axes(first), pairs(h), pairs(k))
            }
            First::Aabb(first) => match first.form() {
                AabbForm::Center { center, half } => {
                    let [a, h] = [center, half].each(|v| parts(v.to_array()));
                    (vector(&|i| difference(b[i], a[i])), along, pairs(h), pairs(k))
                }
                // Everything is doubled, because the centre need not be a number of the scalar.
                AabbForm::Corners { min, max } => {
                    let [p, q] = [min, max].each(|v| parts(v.to_array()));
                    let d = vector(&|i| [twice(b[i]), p[i].negated(), q[i].negated()]);
                    let h = three(|i| [q[i], p[i].negated()]);
                    (d, along, h, pairs(k.each(twice)))
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
        for [a, b] in AXES {
            so_far = so_far.min(self.axis::<S>(a, b));
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
            add_determinant(sum, [a, b, x], Some(factor));
        };
        // The distance by which the second box stays beyond the first, on both sides.
        of_gaps([Ordering::Greater, Ordering::Less].each(|side| {
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

/// The 15 axes, each the cross product of two of the vectors u_0, u_1, u_2, v_0, v_1, v_2: the face
/// normals of the first box and of the second, and then for each v_j its products with all u_i.
#[rustfmt::skip]
const AXES: [[usize; 2]; 15] = [
    [1, 2], [2, 0], [0, 1], [4, 5], [5, 3], [3, 4],
    [0, 3], [1, 3], [2, 3], [0, 4], [1, 4], [2, 4], [0, 5], [1, 5], [2, 5],
];

/// The boxes as they are given: centres and half-extents, or corners of the first, and the axes.
pub(super) struct Given<F> {
    pub(super) first: [[F; 3]; 2],
    pub(super) second: [[F; 3]; 2],
    pub(super) u: [[F; 3]; 3],
    pub(super) v: [[F; 3]; 3],
    pub(super) by_corners: bool,
}

/// Returns the relation of two boxes. Bit k of `open` marks entry k of [`AXES`] for the test; on all
/// other axes the boxes overlap for certain. Returns `None` if the window does not hold the numbers.
#[cold]
#[inline(never)]
pub(super) fn in_window<F: Float>(boxes: &Given<F>, open: u32) -> Option<Relation> {
    let Given { first: [p, q], second: [b, k], u: [u0, u1, u2], v: [v0, v1, v2], .. } = *boxes;
    let ones = [F::from(1); 3];
    let all = [p, q, b, k, u0, u1, u2, v0, v1, v2, ones];
    let [p, q, b, k, u0, u1, u2, v0, v1, v2, [one, ..]] = Window::embed(&all)?;
    let by = |f: fn([i128; 4]) -> i128| [0, 1, 2].each(|i: usize| f([p[i], q[i], b[i], k[i]]));
    // Between corners all lengths are doubled.
    let (d, h, k) = if boxes.by_corners {
        (by(|[p, q, b, _]| (b - p) + (b - q)), by(|[p, q, ..]| q - p), by(|[.., k]| k + k))
    } else {
        (by(|[p, _, b, _]| b - p), q, k)
    };

    let (spans, extents) = ([u0, u1, u2, v0, v1, v2], [h, k]);
    let mut found = Nearness::NONE;
    for (_, [a, b]) in AXES.iter().enumerate().filter(|(bit, _)| open >> bit & 1 == 1) {
        let (a, b) = (*a, *b);
        let axis = cross::<Window>(&spans[a], &spans[b]);
        let along = |x: &[i128; 3], times: i128| -> BigInt<8> {
            dot::<Window>(&axis, x).times::<2, 8>(&times.into()).magnitude()
        };
        let mut reach = BigInt::<8>::ZERO;
        for (r, span) in spans.iter().enumerate().filter(|&(r, _)| r != a && r != b) {
            reach = reach + along(span, extents[r / 3][r % 3]);
        }
        found.add(along(&d, one) - reach, reach, BigInt::ZERO);
        if found.is_disjoint {
            break;
        }
    }
    found.answer(true)
}
