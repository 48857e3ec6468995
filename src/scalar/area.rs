//! Sums of products of two words, asked only for their sign.

use super::word::{Word, out_of_line_if_wide};

/// A sum of products of two lengths: see the table at [`Word`].
pub trait Area<W>: Copy {
    /// a·b + c·d.
    fn new(a: W, b: W, c: W, d: W) -> Self;

    /// A word that is negative exactly if the area is.
    fn sign(self) -> W;

    /// Whether the sum of the areas, each times its length, is negative.
    fn is_negative(areas: &[Self; 3], lengths: [W; 3]) -> bool;
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
    #[inline(always)]
    fn is_negative(areas: &[Self; 3], lengths: [i32; 3]) -> bool {
        // The upper word of an area, rounded to the nearest, and what is left.
        let (mut upper, mut lower) = (0, 0);
        for (&area, length) in areas.iter().zip(lengths) {
            let rest = area as i32;
            upper += (area.sign() - (rest >> (i32::BITS - 1))) * length;
            lower += Self::from(rest) * Self::from(length);
        }
        upper + lower.sign() < 0
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

    #[inline(always)]
    fn is_negative(areas: &[Self; 3], lengths: [W; 3]) -> bool {
        // In four words, of which the two in the middle have the same weight.
        let (mut s0, mut s1, mut s2, mut s3) = (W::ZERO, W::ZERO, W::ZERO, W::ZERO);
        for (area, z) in areas.iter().zip(lengths) {
            let upper = area.sign();
            s0 = s0 + (area.lower & W::LOWER) * z;
            s1 = s1 + (upper & W::LOWER) * z;
            s2 = s2 + (upper >> W::SPLIT) * (z & W::LOWER);
            s3 = s3 + (upper >> W::SPLIT) * (z >> W::SPLIT);
        }
        let carry = s1 + (s0 >> W::SPLIT);
        let carry = s2 + (carry >> W::SPLIT);
        s3 + (carry >> W::SPLIT) < W::ZERO
    }
}
