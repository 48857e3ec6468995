//! The last stage of a line and an oriented box: exact sums of products of the given numbers, in words
//! for a ray near the origin. The axes are the kernel's; each term has four factors.

use core::cmp::Ordering;

use super::faces::Signs;
use crate::arithmetic::{Each, Parts, pick, three, turn};
use crate::query::triangle_obb::exact::{Factors, InSums, Term, signed};
use crate::robust::{Vector, singles};
use crate::scalar::Scalar;
use crate::shape::Obb;

/// A part of a line and a parallelepiped.
pub(super) struct ExactLine<N: Factors> {
    /// The vector from the box's centre to the origin.
    m: N::Vector,
    d: N::Vector,
    ends: [Option<N::Factor>; 2],
    u: [N::Vector; 3],
    h: [N::Factor; 3],
    one: N::Factor,
    /// The signs of w_i·d, and of u_0·w_0.
    along: [Ordering; 3],
    volume: Ordering,
}

impl<S: Scalar> ExactLine<InSums<S>> {
    pub(super) fn of(obb: &Obb<S>, m: Vector, d: Vector, ends: [Option<Parts>; 2]) -> Self {
        let u = obb.axes_as_arrays().each(singles);
        Self::new(m, d, ends, u, obb.half_extents().to_array().each(S::parts), S::ONE)
    }

    /// Where the line enters slab `i` and where it leaves it, rounded to the nearest; `None` if it
    /// runs parallel to the slab.
    pub(super) fn crossing(&self, i: usize) -> Option<(S, S)> {
        if pick(&self.along, i).is_eq() {
            return None;
        }
        let falls = self.is_below(i);
        let den = InSums::<S>::sum([self.along(i, &self.d, S::ONE, falls)]);
        let at = |is_near: bool| {
            let face =
                self.volume(signed::<InSums<S>>(*pick(&self.h, i), self.volume.is_lt() != is_near));
            let num = InSums::<S>::sum([self.along(i, &self.m, S::ONE, !falls), face]);
            S::quotient(&num, &den)
        };
        Some((at(true), at(false)))
    }
}

impl<N: Factors> ExactLine<N> {
    pub(super) fn new(
        m: N::Vector,
        d: N::Vector,
        ends: [Option<N::Factor>; 2],
        u: [N::Vector; 3],
        h: [N::Factor; 3],
        one: N::Factor,
    ) -> Self {
        let none = Ordering::Equal;
        let line = Self { m, d, ends, u, h, one, along: [none; 3], volume: none };
        let along = three(|i| N::sign(&[line.along(i, &line.d, one, false)]));
        let volume = N::sign(&[line.volume(one)]);
        Self { along, volume, ..line }
    }

    /// w_i·x as a term, or its negative: not by the factor, which may be the least number of its type.
    fn along<'a>(
        &'a self,
        i: usize,
        x: &'a N::Vector,
        factor: N::Factor,
        minus: bool,
    ) -> Term<'a, N> {
        let (_, j, k) = turn(i);
        let (j, k) = if minus { (k, j) } else { (j, k) };
        Term(factor, pick(&self.u, j), pick(&self.u, k), x)
    }

    /// u_0·w_0 as a term.
    fn volume(&self, factor: N::Factor) -> Term<'_, N> {
        let [a, b, c] = &self.u;
        Term(factor, a, b, c)
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
        let beyond = |t: Option<N::Factor>| self.is_above(i, t, minus);
        let [from, to] = self.ends;
        let first = if from.is_some() { beyond(from) } else { along != side };
        let last = if to.is_some() { beyond(to) } else { along != side.reverse() };
        first && last && (from.is_some() || to.is_some() || beyond(None))
    }

    /// [`Signs::is_face_above`] at `t`, or at zero.
    fn is_above(&self, i: usize, t: Option<N::Factor>, [at, volume]: [bool; 2]) -> bool {
        let middle = self.along(i, &self.m, self.one, at);
        let face = self.volume(signed::<N>(*pick(&self.h, i), volume));
        let sign = match t {
            Some(t) => N::sign(&[middle, self.along(i, &self.d, t, at), face]),
            None => N::sign(&[middle, face]),
        };
        sign.is_gt()
    }
}

impl<N: Factors> Signs for ExactLine<N> {
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
        let Self { m, d, u, h, one, .. } = self;
        let (k, i, j) = turn(k);
        let terms = [
            Term(signed::<N>(*one, minus), m, d, pick(u, k)),
            self.along(j, d, *pick(h, i), of_j),
            self.along(i, d, *pick(h, j), of_i),
        ];
        Some(N::sign(&terms).is_gt())
    }

    fn is_face_above(&self, i: usize, is_last: bool, minus: [bool; 2]) -> Option<Option<bool>> {
        let t = self.ends[usize::from(is_last)]?;
        Some(Some(self.is_above(i, Some(t), minus)))
    }
}
