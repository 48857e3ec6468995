//! Sums of products of two words, asked only for their sign.

use super::word::{Word, out_of_line_if_wide};

/// A sum of products of two lengths: see the table at [`Word`].
pub trait Area<W>: Copy {
    /// a·b + c·d.
    fn new(a: W, b: W, c: W, d: W) -> Self;

    /// A word that is negative exactly if the area is.
    fn sign(self) -> W;

    /// A sum of products of an area and a length.
    type Volume: Copy;
    /// Nothing yet.
    const NOUGHT: Self::Volume;
    /// The sum with one more product.
    fn sum(volume: Self::Volume, area: Self, length: W) -> Self::Volume;
    /// Whether the sum is negative.
    fn is_negative(volume: Self::Volume) -> bool;
}

/// Where one instruction, or two, multiply words in full.
impl Area<i32> for i64 {
    #[inline(always)]
    fn new(a: i32, b: i32, c: i32, d: i32) -> Self {
        Self::from(a) * Self::from(b) + Self::from(c) * Self::from(d)
    }
    #[inline(always)]
    fn sign(self) -> i32 {
        (self >> i32::BITS) as i32
    }

    /// By the upper word of an area, rounded to the nearest, and by what is left of it.
    type Volume = (i64, i64);
    const NOUGHT: (i64, i64) = (0, 0);
    #[inline(always)]
    fn sum((upper, lower): (i64, i64), area: i64, length: i32) -> (i64, i64) {
        let rest = area as i32;
        let whole = area.sign() - (rest >> (i32::BITS - 1));
        let product = |word| Self::from(word) * Self::from(length);
        (upper + product(whole), lower + product(rest))
    }
    #[inline(always)]
    fn is_negative((upper, lower): (i64, i64)) -> bool {
        upper + (lower >> i32::BITS) < 0
    }
}

/// The sum upper·2^SPLIT + lower, where a product has no more bits than a word.
///
/// A word x is its upper part x >> SPLIT times 2^SPLIT and its lower part
/// x & LOWER, which is never negative.
#[derive(Clone, Copy, Debug)]
pub struct Pair<W> {
    upper: W,
    lower: W,
}

impl<W: Word> Area<W> for Pair<W> {
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

    /// The sum without its lower part, so rounded down.
    #[inline(always)]
    fn sign(self) -> W {
        self.upper + (self.lower >> W::SPLIT)
    }

    /// In four words, of which the two in the middle have the same weight.
    type Volume = [W; 4];
    const NOUGHT: [W; 4] = [W::ZERO; 4];
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
}
