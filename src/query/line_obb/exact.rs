//! The last stage of a line and an oriented box: exact sums of products of the given numbers. The
//! axes are the kernel's; each term has four factors.

use core::cmp::Ordering;
use core::marker::PhantomData;

use super::faces::Signs;
use crate::arithmetic::{Each, Parts, pick, three, turn};
use crate::robust::{ExactSum, Vector, add_determinant, singles};
use crate::scalar::Scalar;
use crate::shape::Obb;

/// A part of a line and a parallelepiped in exact parts.
pub(super) struct ExactLine<S> {
    /// The vector from the box's centre to the origin.
    m: Vector,
    d: Vector,
    ends: [Option<Parts>; 2],
    u: [Vector; 3],
    h: [Parts; 3],
    /// The signs of w_i·d, and of u_0·w_0.
    along: [Ordering; 3],
    volume: Ordering,
    scalar: PhantomData<S>,
}

/// A factor times the determinant of three vectors.
struct Term<'a>(Parts, [&'a Vector; 3]);

fn sum<S: Scalar>(terms: &[Term<'_>]) -> S::SeptumSum {
    let mut sum = S::SeptumSum::new();
    for Term(factor, vectors) in terms {
        add_determinant(&mut sum, *vectors, Some(*factor));
    }
    sum
}

fn signed(x: Parts, minus: bool) -> Parts {
    if minus { x.negated() } else { x }
}

impl<S: Scalar> ExactLine<S> {
    pub(super) fn new(obb: &Obb<S>, m: Vector, d: Vector, ends: [Option<Parts>; 2]) -> Self {
        let u = obb.axes_as_arrays().each(singles);
        let (h, none) = (obb.half_extents().to_array().each(S::parts), Ordering::Equal);
        let line = Self { m, d, ends, u, h, along: [none; 3], volume: none, scalar: PhantomData };
        let along = three(|i| sum::<S>(&[line.along(i, &line.d, S::ONE)]).sign());
        let volume = sum::<S>(&[line.volume(S::ONE)]).sign();
        Self { along, volume, ..line }
    }

    /// w_i·x as a term.
    fn along<'a>(&'a self, i: usize, x: &'a Vector, factor: Parts) -> Term<'a> {
        let (_, j, k) = turn(i);
        Term(factor, [pick(&self.u, j), pick(&self.u, k), x])
    }

    /// u_0·w_0 as a term.
    fn volume(&self, factor: Parts) -> Term<'_> {
        let [a, b, c] = &self.u;
        Term(factor, [a, b, c])
    }

    /// Whether one of the six axes separates.
    pub(super) fn is_separated(&self) -> bool {
        [Ordering::Greater, Ordering::Less]
            .into_iter()
            .any(|side| (0..3).any(|i| self.is_beside(i, side) || self.is_beyond(i, side)))
    }

    /// Whether the line passes the box on this side of d × u_i.
    fn is_beside(&self, i: usize, side: Ordering) -> bool {
        let (i, j, l) = turn(i);
        let minus = [side.is_lt(), !self.is_below(l), !self.is_below(j)];
        self.is_line_above(i, minus) == Some(true)
    }

    /// Whether the whole part lies beyond the box on this side of w_i.
    fn is_beyond(&self, i: usize, side: Ordering) -> bool {
        let (along, minus) = (*pick(&self.along, i), [side.is_lt(), self.volume.is_gt()]);
        let beyond = |t: Parts| self.is_above(i, t, minus);
        let [from, to] = self.ends;
        let first = from.map_or(along != side, beyond);
        let last = to.map_or(along != side.reverse(), beyond);
        first && last && (from.is_some() || to.is_some() || beyond(Parts::ZERO))
    }

    /// [`Signs::is_face_above`] at `t`.
    fn is_above(&self, i: usize, t: Parts, [at, volume]: [bool; 2]) -> bool {
        let terms = [
            self.along(i, &self.m, signed(S::ONE, at)),
            self.along(i, &self.d, signed(t, at)),
            self.volume(signed(*pick(&self.h, i), volume)),
        ];
        sum::<S>(&terms).sign().is_gt()
    }

    /// Where the line enters slab `i` and where it leaves it, rounded to the nearest; `None` if it
    /// runs parallel to the slab.
    pub(super) fn crossing(&self, i: usize) -> Option<(S, S)> {
        if pick(&self.along, i).is_eq() {
            return None;
        }
        let falls = self.is_below(i);
        let den = sum::<S>(&[self.along(i, &self.d, signed(S::ONE, falls))]);
        let at = |is_near: bool| {
            let face = self.volume(signed(*pick(&self.h, i), self.volume.is_lt() != is_near));
            let num = sum::<S>(&[self.along(i, &self.m, signed(S::ONE, !falls)), face]);
            S::quotient(&num, &den)
        };
        Some((at(true), at(false)))
    }
}

impl<S: Scalar> Signs for ExactLine<S> {
    fn crosses(&self, i: usize) -> Option<bool> {
        Some(pick(&self.along, i).is_ne())
    }

    fn is_below(&self, i: usize) -> bool {
        pick(&self.along, i).is_lt()
    }

    fn is_volume_below(&self) -> bool {
        self.volume.is_lt()
    }

    fn is_line_above(&self, k: usize, [minus, of_j, of_i]: [bool; 3]) -> Option<bool> {
        let Self { m, d, u, h, .. } = self;
        let (k, i, j) = turn(k);
        let terms = [
            Term(signed(S::ONE, minus), [m, d, pick(u, k)]),
            self.along(j, d, signed(*pick(h, i), of_j)),
            self.along(i, d, signed(*pick(h, j), of_i)),
        ];
        Some(sum::<S>(&terms).sign().is_gt())
    }

    fn is_face_above(&self, i: usize, is_last: bool, minus: [bool; 2]) -> Option<Option<bool>> {
        let t = self.ends[usize::from(is_last)]?;
        Some(Some(self.is_above(i, t, minus)))
    }
}
