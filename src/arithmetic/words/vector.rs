//! Products of vectors of words. Out of line, because small code is more important than a call
//! where words are used.

use core::cmp::Ordering;

use super::product_sum::ProductSum;
use super::word::{WholeWord, Word};

/// a × b.
#[inline(never)]
pub(crate) fn cross_words<W: Word>(a: &[W; 3], b: &[W; 3]) -> [W::Sum; 3] {
    [minor(a, b, 1, 2), minor(a, b, 2, 0), minor(a, b, 0, 1)]
}

/// a·b.
#[inline(never)]
pub(crate) fn dot_words<W: WholeWord>(a: &[W::Sum; 3], b: &[W; 3]) -> W::Whole {
    let mut volume = W::Sum::ZERO;
    for (&a, &b) in a.iter().zip(b) {
        volume = W::Sum::sum(volume, a, b);
    }
    W::whole(volume)
}

/// The sign of the first nonzero component of a × b.
#[inline(never)]
pub(crate) fn first_sign<W: Word>(a: &[W; 3], b: &[W; 3]) -> Ordering {
    for (there, back) in cross_words(a, b).into_iter().zip(cross_words(b, a)) {
        let is = |area: W::Sum| area.sign() < W::ZERO;
        if is(there) || is(back) {
            return if is(there) { Ordering::Less } else { Ordering::Greater };
        }
    }
    Ordering::Equal
}

#[inline(always)]
fn minor<W: Word>(a: &[W; 3], b: &[W; 3], j: usize, k: usize) -> W::Sum {
    W::Sum::new(a[j], b[k], W::ZERO - a[k], b[j])
}
