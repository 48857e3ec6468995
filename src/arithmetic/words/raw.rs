//! Raw bits of fixed point, cut to few bits.

use super::word::Word;
use crate::arithmetic::offset::RawOffset;

/// The raw bits of a fixed-point number, in a word.
pub trait Raw: Word + Into<i64> + RawOffset {
    /// Each number over 2^`down`, to the nearest. Numbers far below half of that become zero; 30
    /// bits hold the results.
    #[inline(always)]
    fn cut<const K: usize>(numbers: [[Self; 3]; K], down: i32) -> [[i32; 3]; K] {
        let mut cut = [[0; 3]; K];
        let each = cut.as_flattened_mut().iter_mut().zip(numbers.as_flattened());
        // The two kinds of shift apart, so that no loop asks which it is.
        if down <= 0 {
            each.for_each(|(cut, x)| *cut = x.nearest_over(down));
        } else if down < Self::BITS as i32 {
            each.for_each(|(cut, x)| *cut = x.nearest_over(down));
        }
        cut
    }
}

impl<W: Word + Into<i64> + RawOffset> Raw for W {}

/// A fixed-point scalar, by its raw bits.
pub trait InRaw: Copy {
    /// The type of the raw bits.
    type Raw: Raw;

    /// The number of bits of the type, including the sign.
    const BITS: u32 = i64::BITS - Self::GREATEST.leading_zeros() + 1;

    /// Whether a word always holds the difference of two numbers.
    const ALWAYS_NEAR: bool = Self::BITS < <Self::Raw as Word>::BITS;

    /// The number of fraction bits.
    const FRACTION_BITS: i32;

    /// The raw bits of the greatest number.
    const GREATEST: i64;

    /// The raw bits.
    fn raw(self) -> Self::Raw;

    /// The number with the last of these raw bits.
    fn from_raw(raw: i64) -> Self;

    /// The number with these raw bits, or the end of the type.
    #[inline(always)]
    fn clamped(raw: i64) -> Self {
        Self::from_raw(raw.clamp(-Self::GREATEST - 1, Self::GREATEST))
    }

    /// The number with these raw bits, if the type has it.
    #[inline(always)]
    fn held(raw: i128) -> Option<Self> {
        let raw = i64::try_from(raw).ok()?;
        (-Self::GREATEST - 1..=Self::GREATEST).contains(&raw).then(|| Self::from_raw(raw))
    }
}
