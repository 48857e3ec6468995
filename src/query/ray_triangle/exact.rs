//! The last stage where registers have 32 bits: the same volumes as in `super::crossing`, by exact
//! sums of products of the coordinates as given. It takes 17 KB less code and 5 KB less stack there
//! than the kernel in exact integers.

use core::cmp::Ordering;

use crate::arithmetic::{pick, turn};
use crate::robust::{
    ExactSum, Vector, add_area, add_determinant, add_scaled_determinant, difference, single,
};
use crate::scalar::Scalar;

/// A line and a triangle, taken apart, relative to the first vertex.
pub(crate) struct ExactRay {
    d: Vector,
    e: [Vector; 2],
    /// From the second vertex to the third.
    across: Vector,
    s: Vector,
}

/// Determinant and numerators; see `super::crossing::Crossing`. The signs are as
/// they come.
pub(crate) struct ExactCrossing<T> {
    pub(crate) det: T,
    pub(crate) t: T,
    pub(crate) sides: [T; 3],
}

impl ExactRay {
    pub(crate) fn new<S: Scalar>([a, b, c]: &[[S; 3]; 3], origin: &[S; 3], d: &[S; 3]) -> Self {
        let from = |to: &[S; 3], from: &[S; 3]| {
            core::array::from_fn(|i| difference(pick(to, i).parts(), pick(from, i).parts()))
        };
        let d = core::array::from_fn(|i| single(pick(d, i).parts()));
        Self { d, e: [from(b, a), from(c, a)], across: from(c, b), s: from(origin, a) }
    }

    /// All volumes of the crossing.
    pub(crate) fn crossing<S: Scalar>(&self) -> ExactCrossing<S::SeptumSum> {
        let Self { d, e: [e1, e2], s, .. } = self;
        let volume = |a: &Vector, b: &Vector, c: &Vector| {
            let mut sum = S::SeptumSum::new();
            add_determinant(&mut sum, a, b, c);
            sum
        };
        let mut w = volume(d, e2, e1);
        add_determinant(&mut w, e2, d, s);
        add_determinant(&mut w, e1, s, d);
        ExactCrossing {
            det: volume(d, e2, e1),
            t: volume(s, e1, e2),
            sides: [w, volume(d, e2, s), volume(s, e1, d)],
        }
    }

    /// How the numerator of t compares with `t` times the determinant.
    pub(crate) fn compare<S: Scalar>(&self, t: S) -> Ordering {
        let Self { d, e: [e1, e2], s, .. } = self;
        let mut sum = S::SeptumSum::new();
        add_scaled_determinant(&mut sum, s, e1, e2, S::ONE);
        add_scaled_determinant(&mut sum, e2, d, e1, t.parts());
        sum.sign()
    }

    /// The sign of the derivative of side `k` with respect to the origin; see
    /// `super::crossing`.
    pub(crate) fn perturbed_side<S: Scalar>(&self, k: usize) -> Ordering {
        let Self { d, e: [e1, e2], across, .. } = self;
        match k {
            0 => first_sign::<S>(across, d),
            1 => first_sign::<S>(d, e2),
            _ => first_sign::<S>(e1, d),
        }
    }

    /// The same of the numerator of t.
    pub(crate) fn perturbed_t<S: Scalar>(&self) -> Ordering {
        first_sign::<S>(&self.e[0], &self.e[1])
    }
}

/// The sign of the first component of a × b that has one.
fn first_sign<S: Scalar>(a: &Vector, b: &Vector) -> Ordering {
    (0..3).fold(Ordering::Equal, |first, i| {
        first.then_with(|| {
            let (_, j, k) = turn(i);
            let mut sum = S::SeptumSum::new();
            add_area(&mut sum, pick(a, j), pick(b, k), false);
            add_area(&mut sum, pick(a, k), pick(b, j), true);
            sum.sign()
        })
    })
}
