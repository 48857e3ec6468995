//! Two boxes in floats, of which at least one is oriented.

use super::exact::Given;
use super::kernel;
use super::{First, Lie};
use crate::arithmetic::{Float, InFloat};
use crate::query::obb_rows::{ObbInFloats, fits, holds_one, in_floats};
use crate::query::relation::Relation;
use crate::scalar::Scalar;

/// Two parallelepipeds: the difference of the centres, axes and half-extents.
pub(super) struct Boxes<F> {
    pub(super) d: [F; 3],
    pub(super) u: [[F; 3]; 3],
    pub(super) h: [F; 3],
    pub(super) v: [[F; 3]; 3],
    pub(super) k: [F; 3],
}

/// The relation of the boxes in floats, if these hold all numbers. The boxes are passed on, because
/// an `Option` of them would go through memory.
#[inline(always)]
pub(super) fn of_boxes<S: Scalar + InFloat<F>, F: Float>(
    question: &Lie<'_, S>,
    relation: impl FnOnce(&Boxes<F>) -> Option<Relation>,
) -> Option<Relation> {
    let Lie { first, second, .. } = *question;
    if !holds_one::<S, F>() {
        return None;
    }
    let ObbInFloats { center: b, axes: v, half: k } = ObbInFloats::<F>::new(second);
    let boxes = match first {
        First::Obb(first) => {
            let ObbInFloats { center: a, axes: u, half: h } = ObbInFloats::<F>::new(first);
            if !fits::<S, F::Quad, 4>(&[a, h, b, k]) {
                return None;
            }
            Boxes { d: each(b, a, |b, a| b - a), u, h, v, k }
        }
        First::Aabb(first) => {
            let (p, q, is_by_center) = first.numbers();
            let (p, q): ([F; 3], [F; 3]) = (in_floats(p), in_floats(q));
            if !fits::<S, F::Quad, 4>(&[p, q, b, k]) {
                return None;
            }
            let from = |p| each(b, p, |b: F, p| b - p);
            let (d, h) = if is_by_center {
                (from(p), q)
            } else {
                (each(from(p), from(q), |x, y| (x + y).half()), each(q, p, |q, p| (q - p).half()))
            };
            let (zero, one) = (F::ZERO, F::from(1));
            let u = [[one, zero, zero], [zero, one, zero], [zero, zero, one]];
            Boxes { d, u, h, v, k }
        }
    };
    relation(&boxes)
}

#[inline(always)]
fn each<F: Copy>(a: [F; 3], b: [F; 3], f: impl Fn(F, F) -> F) -> [F; 3] {
    [f(a[0], b[0]), f(a[1], b[1]), f(a[2], b[2])]
}

impl<F: Float> Boxes<F> {
    /// The numbers as given.
    #[inline(always)]
    pub(super) fn given<S: Scalar + InFloat<F>>(&self, question: &Lie<'_, S>) -> Given<F> {
        let ObbInFloats { center, half, .. } = ObbInFloats::<F>::new(question.second);
        let (first, by_corners) = match question.first {
            First::Obb(first) => {
                let ObbInFloats { center, half, .. } = ObbInFloats::<F>::new(first);
                ([center, half], false)
            }
            First::Aabb(first) => {
                let (p, q, is_by_center) = first.numbers();
                ([in_floats(p), in_floats(q)], !is_by_center)
            }
        };
        Given { first, second: [center, half], u: self.u, v: self.v, by_corners }
    }

    pub(super) fn as_single_numbers(&self) -> kernel::Boxes<F> {
        let Self { d, u, h, v, k } = *self;
        kernel::Boxes { d, u, h, v, k, one: F::from(1) }
    }
}
