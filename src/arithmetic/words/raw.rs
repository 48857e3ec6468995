//! Raw bits of fixed point, cut to few bits.

use super::word::Word;
use crate::arithmetic::offset::RawOffset;

/// The raw bits of a fixed-point number, in a word.
pub trait Raw: Word + Into<i64> + RawOffset {
    /// The number of bits, including the sign.
    const BITS: i32;

    /// Each number over 2^`down`, to the nearest. Numbers far below half of that become zero; 30
    /// bits hold the results.
    fn cut<const K: usize>(numbers: [[Self; 3]; K], down: i32) -> [[i32; 3]; K];
}

macro_rules! raw {
    ($($raw:ty)*) => {$(
        impl Raw for $raw {
            const BITS: i32 = <$raw>::BITS as i32;

            #[inline(always)]
            fn cut<const K: usize>(numbers: [[Self; 3]; K], down: i32) -> [[i32; 3]; K] {
                let mut cut = [[0; 3]; K];
                let each = cut.as_flattened_mut().iter_mut().zip(numbers.as_flattened());
                if down <= 0 {
                    each.for_each(|(cut, &x)| *cut = (x as i32) << -down);
                } else if down < <Self as Raw>::BITS {
                    each.for_each(|(cut, &x)| *cut = (((x >> (down - 1)) + 1) >> 1) as i32);
                }
                cut
            }
        }
    )*};
}
raw! { i32 i64 }

/// A fixed-point scalar, by its raw bits.
pub trait InRaw: Copy {
    /// The type of the raw bits.
    type Raw: Raw;

    /// Whether the type always holds the difference of two of its numbers.
    const ALWAYS_NEAR: bool;

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
