//! The last stage for an oriented box in wide words or in exact sums, after a look at cut numbers.
//!
//! A whole sum of products takes thousands of instructions on a 32-bit core, and an exact sum hundreds of
//! nanoseconds on a host, and most axes need none. So each number is also cut to 18 bits, and a sum of these
//! with a bound on its error comes first.
//!
//! # Numbers
//!
//! A power of two scales the greatest length, and another one the greatest component of the axes
//! and one, to 18 bits. All terms of a sum have equally many factors of either kind, so the sum is
//! scaled as a whole.
//!
//! | quantity | magnitude | error |
//! | --- | --- | --- |
//! | component, to the nearest, of a word that is off by 2^-9 | 2^18 | 0.502 |
//! | w = (a × b)/2^19, rounded down | 2^18 | 1 + 1.004 |
//! | w·c/2^18, rounded down | 3·2^18 | 1 + (1 + 1925)/2^8 |
//! | the same times a factor, over 2^10, rounded down | 3·2^26 | 1 + 2183 + 386 |
//! | sum of up to four of these | 3·2^28 | 10280 |
//!
//! * w: two products of components up to 2^18, each off by 0.502; each product errs by 1.004·2^18.
//! * w·c: three products of w, off by 2.004, with a component; and of w with a component off by 0.502.
//! * The last product: the determinant, off by 8.53, with a factor up to 2^18; and the determinant
//!   with a factor off by 0.502.
//!
//! [`DOUBT`] is above the last line; `cut.g` proves the sums.

use core::cmp::Ordering;
use core::marker::PhantomData;

use super::exact::{ExactParallelepiped, Factors, InSums, InWords, Term};
use super::known::{cross, product};
use super::short::EXACT;
use crate::arithmetic::{ProductSum, WholeWord, Word, three};
use crate::query::obb_short::size;
use crate::query::relation::Reading;
use crate::scalar::Scalar;

/// The bits of a cut number, without its sign.
const CUT: i32 = 18;
/// A sum of cut numbers that exceeds this in magnitude has the sign of the whole sum.
const DOUBT: i32 = 10_300;

/// Numbers, each also cut.
pub(super) struct InCut<'n, N>(PhantomData<&'n N>);

/// Numbers as they are, and cut.
#[derive(Clone, Copy)]
pub(super) struct Both<W, C> {
    whole: W,
    cut: C,
}

impl<'n, N: Factors> Factors for InCut<'n, N> {
    type Factor = Both<N::Factor, i32>;
    type Vector = Both<&'n N::Vector, [i32; 3]>;

    fn negated(x: Self::Factor) -> Self::Factor {
        Both { whole: N::negated(x.whole), cut: -x.cut }
    }
    #[inline(always)]
    fn sign_of<'a>(terms: impl Iterator<Item = Term<'a, Self>> + Clone) -> Ordering
    where
        Self: 'a,
    {
        let mut sum = 0;
        for Term(factor, a, b, c) in terms.clone() {
            let determinant = product(&cross(&a.cut, &b.cut), &c.cut) >> 8;
            sum += <i32 as Word>::Sum::new(determinant, factor.cut, 0, 0).scaled();
        }
        if sum.abs() > DOUBT {
            return sum.cmp(&0);
        }
        let whole = terms.map(|Term(f, a, b, c)| Term(f.whole, a.whole, b.whole, c.whole));
        if sum == 0 && whole.clone().all(N::is_zero) {
            return Ordering::Equal;
        }
        N::sign_of(whole)
    }
}

impl<'n, N: Factors> ExactParallelepiped<InCut<'n, N>> {
    /// Numbers as they are, and their leading bits in words cut to 18 bits. Words of lengths are accurate
    /// enough if `least` bits or more are cut of them; otherwise all cut numbers are zero.
    #[inline(never)]
    pub(super) fn new<W: WholeWord>(
        whole: &'n ExactParallelepiped<N>,
        words: &ExactParallelepiped<InWords<W>>,
        least: i32,
    ) -> Self {
        let ExactParallelepiped { t, e, u, h, one } = words;
        let with = |all: W, v: &[W; 3]| all | size(&[*v]);
        let lengths = t.iter().chain(e).fold(size(&[*h]), with).bits() - CUT;
        let lengths = if lengths < least { W::BITS as i32 - 2 } else { lengths };
        let axes = u.iter().fold(*one, with).bits() - CUT;
        let factor = |whole, x: W, down| Both { whole, cut: x.nearest_over(down) };
        let vectors = |whole: &'n [N::Vector; 3], words: &[[W; 3]; 3], down| {
            three(|i| vector(&whole[i], &words[i], down))
        };
        Self {
            t: vectors(&whole.t, t, lengths),
            e: vectors(&whole.e, e, lengths),
            u: vectors(&whole.u, u, axes),
            h: three(|i| factor(whole.h[i], h[i], lengths)),
            one: factor(whole.one, *one, axes),
        }
    }
}

#[inline(never)]
fn vector<'n, V, W: WholeWord>(whole: &'n V, v: &[W; 3], down: i32) -> Both<&'n V, [i32; 3]> {
    Both { whole, cut: v.map(|x| x.nearest_over(down)) }
}

impl<W: WholeWord> ExactParallelepiped<InWords<W>> {
    /// The answer; if words are wide, after a look at cut numbers.
    #[inline(always)]
    pub(super) fn after_cut<R: Reading>(&self) -> R::Answer {
        if W::IS_WIDE {
            ExactParallelepiped::<InCut<'_, _>>::new(self, self, EXACT).answer::<R>()
        } else {
            self.answer::<R>()
        }
    }
}

impl<S: Scalar> ExactParallelepiped<InSums<S>> {
    /// The answer, after a look at cut numbers. Where 10 bits are cut, the two units that a word may be off
    /// are 2^-9 of a cut number.
    pub(super) fn after_cut<R: Reading>(&self) -> R::Answer {
        let words = self.in_leading_words();
        ExactParallelepiped::<InCut<'_, _>>::new(self, &words, 10).answer::<R>()
    }
}

#[cfg(all(test, feature = "fixed"))]
mod tests {
    use super::{Both, InCut, vector};
    use crate::arithmetic::Word;
    use crate::query::triangle_obb::exact::{Factors, InWords, Term};
    use crate::random::Random;

    /// Determinants of turned columns are equal, and are rounded otherwise when cut. Sums of their
    /// differences, some of them with one number off by one, have the sign of the whole sum.
    #[test]
    fn cut_sums_have_the_sign_of_whole_sums() {
        let mut random = Random(1);
        let mut seen = [0; 3];
        for case in 0..20_000_i64 {
            let mut number = || (random.bits() >> 33) as i64 - (1 << 30);
            let [a, b, c] = [(); 3].map(|()| [number(), number(), number()]);
            let moved = [c[0] + case % 3 - 1, c[1], c[2]];
            let (f, g) = (number(), number());
            let order =
                [(f, [&a, &b, &moved]), (-f, [&b, &c, &a]), (g, [&c, &a, &b]), (-g, [&a, &b, &c])];
            let whole = order.map(|(f, [a, b, c])| Term::<InWords<i64>>(f, a, b, c));
            let cut = |v| vector(v, v, 12);
            let factor = |whole: i64| Both { whole, cut: whole.nearest_over(12) };
            let vectors = order.map(|(_, v)| v.map(cut));
            let cut: [_; 4] = core::array::from_fn(|k| {
                let [a, b, c] = &vectors[k];
                Term::<InCut<'_, InWords<i64>>>(factor(order[k].0), a, b, c)
            });
            let expected = InWords::sign(&whole);
            assert_eq!(InCut::sign(&cut), expected, "{order:?}");
            seen[(expected as i8 + 1) as usize] += 1;
        }
        assert!(seen.iter().all(|&n| n > 4_000), "{seen:?}");
    }
}
