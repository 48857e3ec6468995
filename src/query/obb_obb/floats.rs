//! Two boxes in floats, of which at least one is oriented.

use super::error_bound::ErrorBound;
use super::exact::{Given, in_window};
use super::kernel::{Boxes, all_axes, is_zero};
use super::{First, Lie};
use crate::arithmetic::{Float, InFloat, Quad, SMALL_CODE, greatest, three_in_float};
use crate::query::obb_rows::{ObbInFloats, fits, holds_one};
use crate::query::relation::Relation;
use crate::scalar::Scalar;

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
    let (zero, one) = (F::ZERO, F::from(1));
    let boxes = match first {
        First::Obb(first) => {
            let ObbInFloats { center: a, axes: u, half: h } = ObbInFloats::<F>::new(first);
            if !fits::<S, F::Quad, 4>(&[a, h, b, k]) {
                return None;
            }
            Boxes { d: each(b, a, |b, a| b - a), u, h, v, k, one }
        }
        First::Aabb(first) => {
            let (p, q, is_by_center) = first.numbers();
            let (p, q): ([F; 3], [F; 3]) = (three_in_float(p), three_in_float(q));
            if !fits::<S, F::Quad, 4>(&[p, q, b, k]) {
                return None;
            }
            let from = |p| each(b, p, |b: F, p| b - p);
            let (d, h) = if is_by_center {
                (from(p), q)
            } else {
                (each(from(p), from(q), |x, y| (x + y).half()), each(q, p, |q, p| (q - p).half()))
            };
            let u = [[one, zero, zero], [zero, one, zero], [zero, zero, one]];
            Boxes { d, u, h, v, k, one }
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
                ([three_in_float(p), three_in_float(q)], !is_by_center)
            }
        };
        Given { first, second: [center, half], u: self.u, v: self.v, by_corners }
    }
}

// What rows of floats do not decide: most such boxes touch, with axes that are parallel or nearly so.

/// Bounds and facts from floats about two boxes that they do not decide.
pub(super) struct Doubt<F> {
    pub(super) error: ErrorBound<F>,
    pub(super) are_faces_clear: bool,
    /// The axes on which the boxes do not overlap for certain; see [`in_window`].
    pub(super) open: u32,
}

impl<F: Float> Boxes<F> {
    /// The relation, where floats are in doubt.
    #[cold]
    #[inline(never)]
    pub(super) fn in_doubt<S: Scalar + InFloat<F>>(
        &self,
        question: &Lie<'_, S>,
        doubt: &Doubt<F>,
    ) -> Option<Relation> {
        if doubt.are_faces_clear && self.overlap_beside_near_axes(&doubt.error) {
            return Some(Relation::Overlapping);
        }
        let given = self.given(question);
        self.exactly(&given).or_else(|| {
            // `f32` goes on in `f64`.
            let is_last = size_of::<F>() == size_of::<f64>() && !SMALL_CODE;
            if is_last { in_window(&given, doubt.open) } else { None }
        })
    }

    /// Whether the boxes overlap, if the faces are clear and only pairs of axes that may be nearly
    /// parallel are in doubt.
    #[cold]
    #[inline(never)]
    fn overlap_beside_near_axes(&self, error: &ErrorBound<F>) -> bool {
        all_axes(self, error, false, true) == Some(Relation::Overlapping)
    }

    /// The relation of boxes that are rotated by no angle or by quarter turns. It is exact if the
    /// `given` numbers, centres and half-extents or corners, are short.
    ///
    /// P is the power of two that is not above the greatest of them. All are multiples of the last
    /// place of 192·P, which is P/2^16 in `f32`, so they are below 2^18 of its halves. The
    /// difference of the centres is below 2^19 halves, and that from a corner to the middle below
    /// 2^18; both are integers. Axes of components 0, 1 and −1 have normals of components up to 2
    /// and a determinant of at most 6. A reach is therefore up to 24·2^18, a distance up to
    /// 12·2^18, and their difference below 2^24, so nothing is rounded. `f64` has 2^29 times as
    /// much room. Nothing underflows, because the size is within the range of the error bound.
    #[cold]
    #[inline(never)]
    pub(super) fn exactly(&self, given: &Given<F>) -> Option<Relation> {
        let Self { u, v, .. } = self;
        let (zero, one) = (F::ZERO, F::from(1));
        let is_whole = |x: &F| *x == zero || x.magnitude() == one;
        if !u.iter().chain(v).flatten().all(is_whole) {
            return None;
        }
        let numbers = || given.first.iter().chain(&given.second).flatten();
        let most = numbers().fold(zero, |most, x| greatest(most, x.magnitude()));
        let shifter = F::from(192) * most.power_of_two_below();
        let is_short = |x: &F| *x + shifter - shifter == *x;
        if !numbers().all(is_short) {
            return None;
        }
        let nothing = ErrorBound { coordinate: zero, axis: zero };
        all_axes(self, &nothing, true, false)
    }

    /// Whether all axes that are not clear are certainly zero: products of each axis of one box
    /// with each axis of the second box, in order.
    #[inline(never)]
    pub(super) fn are_zero_where_near<Q: Quad<Lane = F>>(&self, pairs: [Q; 3], below: Q) -> bool {
        pairs.iter().zip(&self.v).all(|(gaps, v)| {
            let clear = below.exceeds(*gaps);
            self.u.iter().enumerate().all(|(i, u)| clear >> i & 1 == 1 || is_zero(u, v))
        })
    }
}
