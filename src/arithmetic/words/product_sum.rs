//! Sums of products of two words, asked only for their sign.

use core::ops::{Add, Shl};

use super::word::Word;

/// A sum of products of two lengths: see the table at [`Word`](super::Word).
pub trait ProductSum<W>: Copy {
    /// a·b + c·d.
    fn new(a: W, b: W, c: W, d: W) -> Self;

    /// The sum with one more product, a·b.
    fn with_product(self, a: W, b: W) -> Self;

    /// A word that is negative exactly if the area is.
    fn sign(self) -> W;

    /// The sum over 2^[`SPLIT`](super::Word::SPLIT), rounded down, where a word holds that.
    fn scaled(self) -> W;

    /// A sum of products of an area and a length.
    type Volume: Copy;
    /// Nothing yet.
    const ZERO: Self::Volume;
    /// The sum with one more product.
    fn sum(volume: Self::Volume, area: Self, length: W) -> Self::Volume;
    /// Whether the sum is negative.
    fn is_negative(volume: Self::Volume) -> bool;
    /// What the sum is kept in.
    type Part;
    /// The sum as one number, for a `T` that holds it.
    fn whole<T>(volume: Self::Volume) -> T
    where
        T: From<Self::Part> + Add<Output = T> + Shl<u32, Output = T>;
}

/// For lengths so short that nothing is split.
impl ProductSum<i16> for i32 {
    #[inline(always)]
    fn new(a: i16, b: i16, c: i16, d: i16) -> Self {
        Self::from(a) * Self::from(b) + Self::from(c) * Self::from(d)
    }
    #[inline(always)]
    fn with_product(self, a: i16, b: i16) -> Self {
        self + Self::from(a) * Self::from(b)
    }
    #[inline(always)]
    fn sign(self) -> i16 {
        (self >> i16::BITS) as i16
    }
    #[inline(always)]
    fn scaled(self) -> i16 {
        (self >> i16::SPLIT) as i16
    }

    type Volume = Self;
    const ZERO: Self = 0;
    #[inline(always)]
    fn sum(volume: Self, area: Self, length: i16) -> Self {
        volume + area * Self::from(length)
    }
    #[inline(always)]
    fn is_negative(volume: Self) -> bool {
        volume < 0
    }

    type Part = Self;
    #[inline(always)]
    fn whole<T>(volume: Self) -> T
    where
        T: From<Self> + Add<Output = T> + Shl<u32, Output = T>,
    {
        volume.into()
    }
}

/// Where one instruction, or two, multiply words in full.
impl ProductSum<i32> for i64 {
    #[inline(always)]
    fn new(a: i32, b: i32, c: i32, d: i32) -> Self {
        Self::from(a) * Self::from(b) + Self::from(c) * Self::from(d)
    }
    #[inline(always)]
    fn with_product(self, a: i32, b: i32) -> Self {
        self + Self::from(a) * Self::from(b)
    }
    #[inline(always)]
    fn sign(self) -> i32 {
        (self >> i32::BITS) as i32
    }
    #[inline(always)]
    fn scaled(self) -> i32 {
        (self >> i32::SPLIT) as i32
    }

    /// By the upper word of an area, rounded to the nearest, and by what is left of it.
    type Volume = (i64, i64);
    const ZERO: (i64, i64) = (0, 0);
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

    type Part = Self;
    #[inline(always)]
    fn whole<T>((upper, lower): (i64, i64)) -> T
    where
        T: From<i64> + Add<Output = T> + Shl<u32, Output = T>,
    {
        (T::from(upper) << i32::BITS) + T::from(lower)
    }
}
