//! The last stage of a line and an oriented box: exact sums of products of the given numbers. The
//! axes are the kernel's; each term has four factors.

use core::cmp::Ordering;
use core::marker::PhantomData;

use super::faces::ThereAndBack;
use crate::arithmetic::{Parts, each, pick, three, turn};
use crate::query::crossing::Entries;
use crate::robust::{ExactSum, Vector, add_scaled_determinant, single};
use crate::scalar::Scalar;
use crate::shape::Obb;

/// A part of a line and a parallelepiped in exact parts.
pub(super) struct ExactLine {
    /// The vector from the box's centre to the origin.
    pub(super) m: Vector,
    pub(super) d: Vector,
    pub(super) ends: [Option<Parts>; 2],
    u: [Vector; 3],
    h: [Parts; 3],
}

/// A factor times the determinant of three vectors.
struct Term<'a>(Parts, [&'a Vector; 3]);

fn sum<S: Scalar>(terms: &[Term<'_>]) -> S::SeptumSum {
    let mut sum = S::SeptumSum::new();
    for Term(factor, [a, b, c]) in terms {
        add_scaled_determinant(&mut sum, a, b, c, *factor);
    }
    sum
}

fn sign<S: Scalar>(terms: &[Term<'_>]) -> Ordering {
    sum::<S>(terms).sign()
}

fn signed(x: Parts, minus: bool) -> Parts {
    if minus { x.negated() } else { x }
}

impl ExactLine {
    pub(super) fn new<S: Scalar>(
        obb: &Obb<S>,
        m: Vector,
        d: Vector,
        ends: [Option<Parts>; 2],
    ) -> Self {
        let u = each(obb.axes_as_arrays(), |u| each(u, |x| single(x.parts())));
        Self { m, d, ends, u, h: each(obb.half_extents().to_array(), S::parts) }
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
    pub(super) fn is_separated<S: Scalar>(&self) -> bool {
        let along = three(|i| sign::<S>(&[self.along(i, &self.d, S::ONE)]));
        let volume = sign::<S>(&[self.volume(S::ONE)]);
        [Ordering::Greater, Ordering::Less].into_iter().any(|side| {
            (0..3).any(|i| {
                self.line::<S>(i, side, &along) || self.face::<S>(i, side, *pick(&along, i), volume)
            })
        })
    }

    /// Whether the line passes the box on this side of d × u_i.
    fn line<S: Scalar>(&self, i: usize, side: Ordering, along: &[Ordering; 3]) -> bool {
        let (i, j, l) = turn(i);
        let reach = |j: usize, l: usize| {
            self.along(l, &self.d, signed(*pick(&self.h, j), *pick(along, l) == side))
        };
        let line = Term(S::ONE, [&self.m, &self.d, pick(&self.u, i)]);
        sign::<S>(&[line, reach(j, l), reach(l, j)]) == side
    }

    /// Whether the whole part lies beyond the box on this side of w_i.
    fn face<S: Scalar>(&self, i: usize, side: Ordering, along: Ordering, volume: Ordering) -> bool {
        let beyond = |t: Parts| {
            let reach = self.volume(signed(*pick(&self.h, i), volume == side));
            let at = [self.along(i, &self.m, S::ONE), self.along(i, &self.d, t), reach];
            sign::<S>(&at) == side
        };
        let [from, to] = self.ends;
        let first = from.map_or(along != side, beyond);
        let last = to.map_or(along != side.reverse(), beyond);
        first && last && (from.is_some() || to.is_some() || beyond(Parts::ZERO))
    }

    /// The entries of the line into the slabs.
    pub(super) fn entries<S: Scalar>(&self) -> ExactEntries<'_, S> {
        let along = three(|i| sign::<S>(&[self.along(i, &self.d, S::ONE)]));
        let volume = sign::<S>(&[self.volume(S::ONE)]);
        ExactEntries { line: self, along, volume, is_back: false, scalar: PhantomData }
    }

    /// Where the line enters slab `i` and where it leaves it, rounded to the nearest; `None` if it
    /// runs parallel to the slab.
    pub(super) fn crossing<S: Scalar>(&self, i: usize) -> Option<(S, S)> {
        let falls = match sign::<S>(&[self.along(i, &self.d, S::ONE)]) {
            Ordering::Equal => return None,
            side => side == Ordering::Less,
        };
        let is_negative = sign::<S>(&[self.volume(S::ONE)]) == Ordering::Less;
        let den = sum::<S>(&[self.along(i, &self.d, signed(S::ONE, falls))]);
        let at = |is_near: bool| {
            let face = self.volume(signed(*pick(&self.h, i), is_negative != is_near));
            let num = sum::<S>(&[self.along(i, &self.m, signed(S::ONE, !falls)), face]);
            S::quotient(&num, &den)
        };
        Some((at(true), at(false)))
    }
}

/// The entries of a line, or of the line that runs back, into the slabs: see `faces`.
#[derive(Clone, Copy)]
pub(super) struct ExactEntries<'a, S> {
    line: &'a ExactLine,
    along: [Ordering; 3],
    volume: Ordering,
    is_back: bool,
    scalar: PhantomData<S>,
}

impl<S: Scalar> ExactEntries<'_, S> {
    fn is_below(&self, i: usize) -> bool {
        pick(&self.along, i).is_lt()
    }
}

impl<S: Scalar> ThereAndBack for ExactEntries<'_, S> {
    fn entries(&self, is_back: bool) -> impl Entries {
        Self { is_back, ..*self }
    }

    fn is_upper(&self, i: usize) -> bool {
        self.is_below(i) != self.volume.is_lt()
    }
}

impl<S: Scalar> Entries for ExactEntries<'_, S> {
    fn crosses(&self, i: usize) -> Option<bool> {
        Some(pick(&self.along, i).is_ne())
    }

    fn is_later(&self, i: usize, j: usize) -> Option<bool> {
        let ExactLine { m, d, u, h, .. } = self.line;
        let (_, next, last) = turn(i);
        let is_cyclic = j == next;
        let k = if is_cyclic { last } else { next };
        let is_odd = self.is_below(i) ^ self.is_below(j) ^ self.volume.is_lt();
        let beside = signed(S::ONE, is_odd ^ is_cyclic ^ self.is_back);
        let terms = [
            Term(beside, [m, d, pick(u, k)]),
            self.line.along(i, d, signed(*pick(h, j), self.is_below(i))),
            self.line.along(j, d, signed(*pick(h, i), !self.is_below(j))),
        ];
        Some(sign::<S>(&terms).is_gt())
    }

    fn is_past(&self, i: usize) -> Option<bool> {
        let ExactLine { m, d, ends: [from, to], h, .. } = self.line;
        let Some(t) = (if self.is_back { to } else { from }) else { return Some(false) };
        let minus = self.is_below(i) != self.is_back;
        let terms = [
            self.line.along(i, m, signed(S::ONE, minus)),
            self.line.along(i, d, signed(*t, minus)),
            self.line.volume(signed(*pick(h, i), self.volume.is_lt())),
        ];
        Some(sign::<S>(&terms).is_gt())
    }
}
