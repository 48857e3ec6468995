//! The last stage for an oriented box in wide words, after a look at cut numbers.
//!
//! A whole sum of products takes thousands of instructions there, and most axes need none. So each
//! number is also cut to 18 bits, and a sum of these with a bound on its error comes first.
//!
//! # Numbers
//!
//! A power of two scales the greatest length, and another one the greatest component of the axes
//! and one, to 18 bits. All terms of a sum have equally many factors of either kind, so the sum is
//! scaled as a whole.
//!
//! | quantity | magnitude | error |
//! | --- | --- | --- |
//! | component, to the nearest | 2^18 | 1/2 |
//! | w = (a × b)/2^19, rounded down | 2^18 | 1 + 1 |
//! | w·c/2^18, rounded down | 3·2^18 | 1 + (1 + 1920)/2^8 |
//! | the same times a factor, over 2^10, rounded down | 3·2^26 | 1 + 2177 + 384 |
//! | sum of up to four of these | 3·2^28 | 10248 |
//!
//! * w: two products of components up to 2^18, each off by 1/2; each product errs by 2^18.
//! * w·c: three products of w, off by 2, with a component; and of w with a component off by 1/2.
//! * The last product: the determinant, off by 8.51, with a factor up to 2^18; and the determinant
//!   with a factor off by 1/2.
//!
//! [`DOUBT`] is above the last line; `cut.g` proves the sums.

use core::cmp::Ordering;
use core::marker::PhantomData;

use super::exact::{ExactParallelepiped, Factors, InWords, Term};
use super::known::{cross, product};
use crate::arithmetic::{ProductSum, WholeWord, Word, pick, turn};
use crate::query::obb_short::size;
use crate::query::relation::Reading;

/// The bits of a cut number, without its sign.
const CUT: i32 = 18;
/// A sum of cut numbers that exceeds this in magnitude has the sign of the whole sum.
const DOUBT: i32 = 10_250;

/// Words, each also cut.
pub(super) struct InCutWords<'w, W>(PhantomData<&'w W>);

/// Numbers as they are, and cut.
#[derive(Clone, Copy)]
pub(super) struct Both<W, C> {
    whole: W,
    cut: C,
}

impl<'w, W: WholeWord> Factors for InCutWords<'w, W> {
    type Factor = Both<W, i32>;
    type Vector = Both<&'w [W; 3], [i32; 3]>;

    fn negated(x: Self::Factor) -> Self::Factor {
        Both { whole: W::ZERO - x.whole, cut: -x.cut }
    }
    #[inline(never)]
    fn sign(terms: &[Term<'_, Self>]) -> Ordering {
        let mut sum = 0;
        for Term(factor, a, b, c) in terms {
            let determinant = product(&cross(&a.cut, &b.cut), &c.cut) >> 8;
            sum += <i32 as Word>::Sum::new(determinant, factor.cut, 0, 0).scaled();
        }
        if sum.abs() > DOUBT {
            return sum.cmp(&0);
        }
        if sum == 0 && terms.iter().all(is_zero) {
            return Ordering::Equal;
        }
        InWords::sum_sign(terms.iter().map(|Term(f, a, b, c)| (f.whole, a.whole, b.whole, c.whole)))
    }
}

/// Whether each product of a determinant has a factor zero, as of an edge and an axis along one
/// coordinate axis.
#[inline(never)]
fn is_zero<W: WholeWord>(Term(_, a, b, c): &Term<'_, InCutWords<'_, W>>) -> bool {
    let has = |x: &[W; 3], i: usize| *pick(x, i) != W::ZERO;
    let [a, b, c] = [a.whole, b.whole, c.whole];
    !(0..3).any(|i| {
        let (i, j, k) = turn(i);
        has(a, i) && (has(b, j) && has(c, k) || has(b, k) && has(c, j))
    })
}

impl<'w, W: WholeWord> ExactParallelepiped<InCutWords<'w, W>> {
    /// The numbers, which words hold, and the same cut.
    #[inline(never)]
    pub(super) fn new(words: &'w ExactParallelepiped<InWords<W>>) -> Self {
        let ExactParallelepiped { t, e, u, h, one } = words;
        let with = |all: W, v: &[W; 3]| all | size(&[*v]);
        let lengths = t.iter().chain(e).fold(size(&[*h]), with).bits() - CUT;
        let axes = u.iter().fold(*one, with).bits() - CUT;
        let factor = |x: W, down| Both { whole: x, cut: x.nearest_over(down) };
        Self {
            t: t.each_ref().map(|v| vector(v, lengths)),
            e: e.each_ref().map(|v| vector(v, lengths)),
            u: u.each_ref().map(|v| vector(v, axes)),
            h: h.map(|x| factor(x, lengths)),
            one: factor(*one, axes),
        }
    }
}

#[inline(never)]
fn vector<W: WholeWord>(v: &[W; 3], down: i32) -> Both<&[W; 3], [i32; 3]> {
    Both { whole: v, cut: v.map(|x| x.nearest_over(down)) }
}

impl<W: WholeWord> ExactParallelepiped<InWords<W>> {
    /// The answer; if words are wide, after a look at cut numbers.
    #[inline(always)]
    pub(super) fn after_cut<R: Reading>(&self) -> R::Answer {
        if W::IS_WIDE {
            ExactParallelepiped::<InCutWords<'_, W>>::new(self).answer::<R>()
        } else {
            self.answer::<R>()
        }
    }
}

#[cfg(all(test, feature = "fixed"))]
mod tests {
    use super::{Both, InCutWords, vector};
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
            let cut = |v| vector::<i64>(v, 12);
            let factor = |whole: i64| Both { whole, cut: whole.nearest_over(12) };
            let vectors = order.map(|(_, v)| v.map(cut));
            let cut: [_; 4] = core::array::from_fn(|k| {
                let [a, b, c] = &vectors[k];
                Term::<InCutWords<'_, i64>>(factor(order[k].0), a, b, c)
            });
            let expected = InWords::sign(&whole);
            assert_eq!(InCutWords::sign(&cut), expected, "{order:?}");
            seen[(expected as i8 + 1) as usize] += 1;
        }
        assert!(seen.iter().all(|&n| n > 4_000), "{seen:?}");
    }
}
