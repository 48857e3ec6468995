//! Sums of products of two words, of which only signs are used, and products of vectors of words.

use core::cmp::Ordering;
use core::ops::{Add, Shl};

use super::word::{WholeWord, Word};

/// A sum of products of two lengths: see the table at [`Word`](super::Word).
pub trait ProductSum<W>: Copy {
    /// Whether one multiplication gives a whole product.
    const IS_WHOLE: bool;

    /// a·b + c·d.
    fn new(a: W, b: W, c: W, d: W) -> Self;

    /// The sum with one more product, a·b.
    fn with_product(self, a: W, b: W) -> Self;

    /// A word that is negative exactly if the area is.
    fn sign(self) -> W;

    /// The sum over 2^[`SPLIT`](super::Word::SPLIT), rounded down, if a word holds it.
    fn scaled(self) -> W;

    /// [`scaled`](Self::scaled) over 2^`places`, rounded down.
    fn scaled_by(self, places: u32) -> W;

    /// A sum of products of an area and a length.
    type Volume: Copy;
    /// The area times one.
    fn volume(self) -> Self::Volume;
    /// The empty sum.
    const ZERO: Self::Volume;
    /// The sum with one more product.
    fn sum(volume: Self::Volume, area: Self, length: W) -> Self::Volume;
    /// Whether the sum is negative.
    fn is_negative(volume: Self::Volume) -> bool;
    /// The type of the parts of a sum.
    type Part;
    /// The sum as one number, for a `T` that can hold it.
    fn whole<T>(volume: Self::Volume) -> T
    where
        T: From<Self::Part> + Add<Output = T> + Shl<u32, Output = T>;
}

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
