//! The last stage of lines against a box: cross-multiplied slabs by exact sums of
//! products of the coordinates as they were given.

use core::cmp::Ordering;

use crate::arithmetic::{Parts, pick, three};
use crate::query::exact_aabb::ExactAabb;
use crate::robust::{ExactSum, Linear, add_area, difference, single};
use crate::scalar::Scalar;
use crate::shape::AabbForm;

/// A line in the slabs of a box, every axis mirrored on which the line falls: see
/// [`Slabs`](super::Slabs).
pub(crate) struct ExactLine {
    near: [Linear; 3],
    far: [Linear; 3],
    m: [Linear; 3],
}

impl ExactLine {
    /// The line from `o` along `d`.
    pub(crate) fn along<S: Scalar>(o: [S; 3], d: [S; 3], form: &AabbForm<S>) -> Self {
        let falls = d.map(|d| d < S::ZERO);
        Self::new(o, d.map(|d| single(d.parts())), falls, form)
    }

    /// The line from `o`, in the direction from `a` to `b`.
    pub(crate) fn between<S: Scalar>(o: [S; 3], a: [S; 3], b: [S; 3], form: &AabbForm<S>) -> Self {
        let direction = |i| difference(pick(&b, i).parts(), pick(&a, i).parts());
        let falls = three(|i| pick(&b, i) < pick(&a, i));
        Self::new(o, three(direction), falls, form)
    }

    fn new<S: Scalar>(o: [S; 3], d: [Linear; 3], falls: [bool; 3], form: &AabbForm<S>) -> Self {
        let faces = ExactAabb::new(form);
        let mirrored = |x: Linear, falls: bool| if falls { x.map(Parts::negated) } else { x };
        let face = |i: usize, ahead: bool| {
            let (o, falls) = (pick(&o, i).parts(), *pick(&falls, i));
            let toward = if ahead == falls { Ordering::Less } else { Ordering::Greater };
            mirrored(faces.to_face(o, i, toward), falls)
        };
        Self {
            near: three(|i| face(i, false)),
            far: three(|i| face(i, true)),
            m: three(|i| mirrored(*pick(&d, i), *pick(&falls, i))),
        }
    }

    /// Whether the whole line misses the box, unless its direction is zero.
    pub(crate) fn line_misses<S: Scalar>(&self) -> bool {
        let pair = |i: usize, j: usize| {
            let mut sum = S::Sum::new();
            add_area(&mut sum, pick(&self.near, i), pick(&self.m, j), false);
            add_area(&mut sum, pick(&self.far, j), pick(&self.m, i), true);
            sum.sign() == Ordering::Greater
        };
        [(0, 1), (1, 2), (2, 0)].into_iter().any(|(i, j)| pair(i, j) || pair(j, i))
    }

    /// Whether all of the box lies before the origin on some axis: t < 0.
    pub(crate) fn lies_before<S: Scalar>(&self) -> bool {
        self.far.iter().any(|x| sign::<S>(&[*x]) == Ordering::Less)
    }

    /// Whether all of the box lies beyond the origin on some axis: t > 0.
    pub(crate) fn lies_beyond<S: Scalar>(&self) -> bool {
        self.near.iter().any(|x| sign::<S>(&[*x]) == Ordering::Greater)
    }

    /// Whether on some axis all of the box lies at t < −1 or at t > 1.
    pub(crate) fn lies_beyond_one<S: Scalar>(&self) -> bool {
        (0..3).any(|i| {
            let (near, far, m) = (*pick(&self.near, i), *pick(&self.far, i), *pick(&self.m, i));
            sign::<S>(&[far, m]) == Ordering::Less
                || sign::<S>(&[near, m.map(Parts::negated)]) == Ordering::Greater
        })
    }

    /// Whether on some axis all of the box lies at t < `from` or at t > `to`.
    pub(crate) fn lies_outside<S: Scalar>(&self, from: Option<S>, to: Option<S>) -> bool {
        let side = |x: Linear, t: S, i: usize| {
            let mut sum = S::Sum::new();
            add_area(&mut sum, &x, &single(S::ONE), false);
            add_area(&mut sum, pick(&self.m, i), &single(t.parts()), true);
            sum.sign()
        };
        (0..3).any(|i| {
            from.is_some_and(|t| side(*pick(&self.far, i), t, i) == Ordering::Less)
                || to.is_some_and(|t| side(*pick(&self.near, i), t, i) == Ordering::Greater)
        })
    }

    /// Where the line enters slab `i` and where it leaves it, to the nearest; nothing
    /// if it runs along it.
    pub(crate) fn crossing<S: Scalar>(&self, i: usize) -> Option<(S, S)> {
        let sum = |x: &Linear| {
            let mut sum = S::Sum::new();
            x.iter().for_each(|&x| sum.add(&[x]));
            sum
        };
        let m = sum(pick(&self.m, i));
        let at = |x: &[Linear; 3]| S::quotient(&sum(pick(x, i)), &m);
        (m.sign() == Ordering::Greater).then(|| (at(&self.near), at(&self.far)))
    }
}

fn sign<S: Scalar>(lengths: &[Linear]) -> Ordering {
    let mut sum = S::Sum::new();
    lengths.as_flattened().iter().for_each(|&x| sum.add(&[x]));
    sum.sign()
}
