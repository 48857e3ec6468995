//! Sums of products of two words, of which only signs are used, and products of vectors of words.
//! A sum in two words serves cores whose products have the width of a word.

use core::cmp::Ordering;
use core::ops::{Add, Shl};

use super::word::{ProductSum, WholeWord, Word};
use crate::arithmetic::out_of_line_if_wide;

// Out of line, because small code is more important than a call where words are used.

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

/// The sum upper·2^SPLIT + lower, for products of the width of a word.
///
/// A word x is its upper part x >> SPLIT times 2^SPLIT plus its lower part x & LOWER, which is
/// never negative.
#[derive(Clone, Copy, Debug)]
pub struct SplitSum<W> {
    upper: W,
    lower: W,
}

impl<W: Word> ProductSum<W> for SplitSum<W> {
    #[inline(always)]
    fn new(a: W, b: W, c: W, d: W) -> Self {
        out_of_line_if_wide!(
            W,
            Self {
                upper: (a >> W::SPLIT) * b + (c >> W::SPLIT) * d,
                lower: (a & W::LOWER) * b + (c & W::LOWER) * d,
            }
        )
    }

    #[inline(always)]
    fn with_product(self, a: W, b: W) -> Self {
        Self { upper: self.upper + (a >> W::SPLIT) * b, lower: self.lower + (a & W::LOWER) * b }
    }

    /// The sum without its lower part, and so rounded down.
    #[inline(always)]
    fn sign(self) -> W {
        self.scaled()
    }
    #[inline(always)]
    fn scaled(self) -> W {
        self.upper + (self.lower >> W::SPLIT)
    }
    #[inline(always)]
    fn scaled_by(self, places: u32) -> W {
        self.scaled() >> places
    }

    /// In four words; the two in the middle have the same weight.
    type Volume = [W; 4];
    const ZERO: [W; 4] = [W::ZERO; 4];
    #[inline(always)]
    fn volume(self) -> [W; 4] {
        [self.lower, self.upper, W::ZERO, W::ZERO]
    }
    #[inline(always)]
    fn sum([s0, s1, s2, s3]: [W; 4], area: Self, z: W) -> [W; 4] {
        let upper = area.sign();
        [
            s0 + (area.lower & W::LOWER) * z,
            s1 + (upper & W::LOWER) * z,
            s2 + (upper >> W::SPLIT) * (z & W::LOWER),
            s3 + (upper >> W::SPLIT) * (z >> W::SPLIT),
        ]
    }
    #[inline(always)]
    fn is_negative([s0, s1, s2, s3]: [W; 4]) -> bool {
        let carry = s1 + (s0 >> W::SPLIT);
        let carry = s2 + (carry >> W::SPLIT);
        s3 + (carry >> W::SPLIT) < W::ZERO
    }

    type Part = W;
    #[inline(always)]
    fn whole<T>([s0, s1, s2, s3]: [W; 4]) -> T
    where
        T: From<W> + Add<Output = T> + Shl<u32, Output = T>,
    {
        let above = |sum: T, word| (sum << W::SPLIT) + T::from(word);
        above(above(above(T::from(s3), s2), s1), s0)
    }
}
