//! The last stage for an oriented box: exact signs of sums of products of the given numbers, as for
//! an axis-aligned box. The axes are the kernel's; each term has four factors. Sums are long
//! accumulators, or words if the shapes are short enough.

use core::cmp::Ordering;
use core::marker::PhantomData;

use crate::arithmetic::{
    Bits, Each, InRaw, Number, Parts, WholeVolume, WholeWord, cross_words, dot_words, pick, three,
    turn,
};
use crate::query::relation::{Reading, Relation, of_gaps};
use crate::query::triangle_aabb::words::minus;
use crate::robust::{ExactSum, Linear, Uncertain, Vector, add_determinant, difference, single};
use crate::scalar::Scalar;

/// The representation of factors, and the sign of a sum of their products.
pub(in crate::query) trait Factors: Sized {
    type Factor: Copy;
    type Vector;

    fn negated(x: Self::Factor) -> Self::Factor;

    /// The sign of the sum of such terms.
    fn sign_of<'a>(terms: impl Iterator<Item = Term<'a, Self>> + Clone) -> Ordering
    where
        Self: 'a;

    #[inline(never)]
    fn sign(terms: &[Term<'_, Self>]) -> Ordering {
        Self::sign_of(terms.iter().copied())
    }

    /// Whether a term is seen to be zero.
    fn is_zero(term: Term<'_, Self>) -> bool {
        let _ = term;
        false
    }
}

/// A factor times the determinant of three vectors.
pub(in crate::query) struct Term<'a, N: Factors>(
    pub(in crate::query) N::Factor,
    pub(in crate::query) &'a N::Vector,
    pub(in crate::query) &'a N::Vector,
    pub(in crate::query) &'a N::Vector,
);

impl<N: Factors> Copy for Term<'_, N> {}

impl<N: Factors> Clone for Term<'_, N> {
    fn clone(&self) -> Self {
        *self
    }
}

/// Exact sums, for any numbers.
pub(in crate::query) struct InSums<S>(PhantomData<S>);

impl<S: Scalar> InSums<S> {
    #[inline(always)]
    pub(in crate::query) fn sum<'a>(terms: impl IntoIterator<Item = Term<'a, Self>>) -> S::SeptumSum
    where
        S: 'a,
    {
        let mut sum = S::SeptumSum::new();
        for Term(factor, a, b, c) in terms {
            add_determinant(&mut sum, [a, b, c], Some(factor));
        }
        sum
    }
}

impl<S: Scalar> Factors for InSums<S> {
    type Factor = Parts;
    type Vector = Vector;

    fn negated(x: Parts) -> Parts {
        x.negated()
    }
    #[inline(always)]
    fn sign_of<'a>(terms: impl Iterator<Item = Term<'a, Self>> + Clone) -> Ordering
    where
        Self: 'a,
    {
        Self::sum(terms).sign()
    }
}

/// Words that hold the lengths of the shapes and one.
pub(in crate::query) struct InWords<W>(PhantomData<W>);

impl<W: WholeWord> Factors for InWords<W> {
    type Factor = W;
    type Vector = [W; 3];

    fn negated(x: W) -> W {
        W::ZERO - x
    }
    #[inline(always)]
    fn sign_of<'a>(terms: impl Iterator<Item = Term<'a, Self>> + Clone) -> Ordering
    where
        Self: 'a,
    {
        let mut sum = (W::Whole::ZERO, W::Whole::ZERO);
        for Term(factor, a, b, c) in terms {
            sum = dot_words(&cross_words(a, b), c).product_onto(sum, factor);
        }
        W::Whole::sign_of(sum)
    }

    /// Whether each product of the determinant has a factor zero, as of an edge and an axis along one
    /// coordinate axis.
    #[inline(never)]
    fn is_zero(Term(_, a, b, c): Term<'_, Self>) -> bool {
        let has = |x: &[W; 3], i: usize| *pick(x, i) != W::ZERO;
        !(0..3).any(|i| {
            let (i, j, k) = turn(i);
            has(a, i) && (has(b, j) && has(c, k) || has(b, k) && has(c, j))
        })
    }
}

/// A triangle and a parallelepiped.
pub(super) struct ExactParallelepiped<N: Factors> {
    /// The vertices, relative to the centre.
    pub(super) t: [N::Vector; 3],
    /// The edges.
    pub(super) e: [N::Vector; 3],
    /// The axes.
    pub(super) u: [N::Vector; 3],
    pub(super) h: [N::Factor; 3],
    pub(super) one: N::Factor,
}

impl<S: Scalar> ExactParallelepiped<InSums<S>> {
    pub(super) fn new([a, b, c]: [[S; 3]; 3], [center, u, v, w, half]: [[S; 3]; 5]) -> Self {
        // Inlined: of a call, each result would be on the stack twice.
        let from = |to: [S; 3], from: [S; 3]| three(|i| difference(to[i].parts(), from[i].parts()));
        Self {
            t: [from(a, center), from(b, center), from(c, center)],
            e: [from(b, a), from(c, b), from(a, c)],
            u: [u, v, w].each(|u| u.each(|x| single(x.parts()))),
            h: half.each(S::parts),
            one: S::ONE,
        }
    }

    /// The leading bits of all numbers, those of lengths in one unit and those of axes in another. A
    /// length is off by less than two units, and an axis by less than one.
    pub(super) fn in_leading_words(&self) -> ExactParallelepiped<InWords<i64>> {
        let Self { t, e, u, h, one } = self;
        let unit = |vectors: &[Vector; 3], factors: &[Parts]| {
            let bits = factors.iter().fold(Bits::NONE, |bits, &x| bits.with(x));
            let all = vectors.as_flattened().as_flattened();
            all.iter().fold(bits, |bits, &x| bits.with(x)).high - 60
        };
        let (length, axis) = (unit(t, h), unit(u, &[*one]));
        let word = |x: &Linear, unit| x.iter().map(|x| x.cut_to_units(unit)).sum::<i64>();
        let words = |v: &Vector, unit| three(|i| word(&v[i], unit));
        ExactParallelepiped {
            t: t.each_ref().map(|v| words(v, length)),
            e: e.each_ref().map(|v| words(v, length)),
            u: u.each_ref().map(|v| words(v, axis)),
            h: h.map(|x| x.cut_to_units(length)),
            one: one.cut_to_units(axis),
        }
    }
}

impl<W: WholeWord> ExactParallelepiped<InWords<W>> {
    /// In words; differences that do not fit wrap around.
    #[inline(always)]
    pub(super) fn in_words<S: Scalar + InRaw>(
        [a, b, c]: [[S; 3]; 3],
        [center, u, v, w, half]: [[S; 3]; 5],
        one: W,
    ) -> Self {
        let words = |x: [S; 3]| [x[0].in_word(), x[1].in_word(), x[2].in_word()];
        let ([a, b, c], center) = ([words(a), words(b), words(c)], words(center));
        Self {
            t: [a, b, c].each(|p| minus(&p, &center)),
            e: [minus(&b, &a), minus(&c, &b), minus(&a, &c)],
            u: [words(u), words(v), words(w)],
            h: words(half),
            one,
        }
    }

    /// Divides all lengths by a common power of two. Shapes whose coordinates are multiples of a
    /// larger unit, as on a grid, then fit words from farther away. Each term has the same number
    /// of lengths.
    ///
    /// A wrapped difference does not pass as a short one. From a word in the middle half it is at
    /// least 2^14, 2^30 or 2^62. After the greatest division here, what counts as short is below
    /// 2^13, 2^29 or 2^55.
    #[inline(always)]
    fn take_off_common_zeros(&mut self) {
        let Self { t, e, h, .. } = self;
        let lengths = [t.as_flattened(), e.as_flattened(), h];
        let mut all = lengths.into_iter().flatten().fold(W::ZERO, |all, &x| all | x);
        let mut zeros = 0;
        // The same number of passes for all numbers, because the worst case is promised.
        for _ in 0..size_of::<W>() * 8 / 3 {
            let is_even = u32::from((all >> 1).plus(all >> 1) == all);
            (all, zeros) = (all >> is_even, zeros + is_even);
        }
        for x in [t.as_flattened_mut(), e.as_flattened_mut(), h].into_iter().flatten() {
            *x = *x >> zeros;
        }
    }

    /// Whether words can hold all products of these lengths, if no length is wrapped, perhaps after
    /// a common division. Out of line, because the axes, which follow, take the most stack.
    #[inline(never)]
    pub(super) fn becomes_near(&mut self) -> bool {
        self.take_off_common_zeros();
        let Self { t, e, u, h, .. } = self;
        let lengths = [t.as_flattened(), e.as_flattened(), u.as_flattened(), h];
        lengths.into_iter().flatten().fold(W::ZERO, |all, x| all | x.folded()).has_volumes()
    }
}

impl<N: Factors> ExactParallelepiped<N> {
    /// The answer from the 13 axes.
    pub(super) fn answer<R: Reading>(&self) -> R::Answer {
        R::of(self.relation::<R>())
    }

    /// The relation. Unless contact is asked for, touching counts as overlapping, and an axis ends
    /// as soon as it does not separate.
    #[inline(always)]
    fn relation<R: Reading>(&self) -> Relation {
        let [u0, u1, u2] = &self.u;
        let volume = N::sign(&[Term(self.one, u0, u1, u2)]);
        let mut so_far = Relation::Overlapping;
        for i in 0..3 {
            so_far = so_far.min(self.face::<R>(i, volume));
            if so_far == Relation::Disjoint {
                return so_far;
            }
        }
        let [e0, e1, _] = &self.e;
        let un = [0, 1, 2].each(|i| N::sign(&[Term(self.one, pick(&self.u, i), e0, e1)]));
        so_far = so_far.min(self.normal::<R>(&un));
        for k in 0..3 {
            for i in 0..3 {
                if so_far == Relation::Disjoint {
                    return so_far;
                }
                so_far = so_far.min(self.edge::<R>(i, k, *pick(&un, i)));
            }
        }
        so_far
    }

    /// Whether a face of the box separates: all that can of a triangle that is a point.
    pub(super) fn is_beyond_a_face(&self) -> bool {
        let [u0, u1, u2] = &self.u;
        let volume = N::sign(&[Term(self.one, u0, u1, u2)]);
        (0..3).any(|i| self.face::<Uncertain>(i, volume) == Relation::Disjoint)
    }

    /// Whether all vertices lie beyond h_i·|det u|, on each side.
    #[inline(never)]
    fn face<R: Reading>(&self, i: usize, volume: Ordering) -> Relation {
        let (i, j, k) = turn(i);
        let (u, v) = (pick(&self.u, j), pick(&self.u, k));
        let [u0, u1, u2] = &self.u;
        on_either_side::<R>(|side| {
            let h = signed::<N>(*pick(&self.h, i), volume == side);
            let mut gap = Ordering::Greater;
            for t in &self.t {
                let sign = N::sign(&[Term(self.one, u, v, t), Term(h, u0, u1, u2)]);
                gap = gap.min(toward(side, sign));
                // No vertex can make the gap less, or it is closed already.
                if gap == Ordering::Less || !R::TELLS_CONTACT && gap == Ordering::Equal {
                    break;
                }
            }
            gap
        })
    }

    /// Whether n·t_0 lies beyond Σ h_i·|u_i·n|, on each side.
    #[inline(never)]
    fn normal<R: Reading>(&self, un: &[Ordering; 3]) -> Relation {
        let [e0, e1, _] = &self.e;
        on_either_side::<R>(|side| {
            let box_term = |i: usize| {
                let h = signed::<N>(*pick(&self.h, i), *pick(un, i) == side);
                Term(h, pick(&self.u, i), e0, e1)
            };
            let triangle_term = Term(self.one, &self.t[0], e0, e1);
            toward(side, N::sign(&[triangle_term, box_term(0), box_term(1), box_term(2)]))
        })
    }

    /// Whether the triangle's interval on e_k × u_i lies beyond the box's, on each side.
    #[inline(never)]
    fn edge<R: Reading>(&self, i: usize, k: usize, un: Ordering) -> Relation {
        let (i, j, l) = turn(i);
        let (k, _, opposite) = turn(k);
        let [ui, uj, ul] = [i, j, l].each(|i| pick(&self.u, i));
        let e = pick(&self.e, k);
        // w_l·e and w_j·e
        let along_l = N::sign(&[Term(self.one, ui, uj, e)]);
        let along_j = N::sign(&[Term(self.one, ul, ui, e)]);
        on_either_side::<R>(|side| {
            // The end of the interval that is nearer to the box: p, or p + u·n of the opposite
            // vertex.
            let nearer = if un == side.reverse() { opposite } else { k };
            let sign = N::sign(&[
                Term(self.one, ui, e, pick(&self.t, nearer)),
                Term(signed::<N>(*pick(&self.h, j), along_l == side), ui, uj, e),
                Term(signed::<N>(*pick(&self.h, l), along_j == side), ul, ui, e),
            ]);
            toward(side, sign)
        })
    }
}

/// The relation on an axis, from the gaps on its two sides.
#[inline(always)]
fn on_either_side<R: Reading>(gap: impl Fn(Ordering) -> Ordering) -> Relation {
    if R::TELLS_CONTACT {
        of_gaps([gap(Ordering::Greater), gap(Ordering::Less)])
    } else if [Ordering::Greater, Ordering::Less].into_iter().any(|side| gap(side).is_gt()) {
        Relation::Disjoint
    } else {
        Relation::Overlapping
    }
}

/// The sign toward a side, from the sign along the axis.
fn toward(side: Ordering, sign: Ordering) -> Ordering {
    if side.is_gt() { sign } else { sign.reverse() }
}

pub(in crate::query) fn signed<N: Factors>(x: N::Factor, minus: bool) -> N::Factor {
    if minus { N::negated(x) } else { x }
}

#[cfg(all(test, feature = "fixed"))]
mod tests;
