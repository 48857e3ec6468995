//! The words of the machines, and sums of products where one multiplication gives the full product:
//! for `i16` on every core, for `i32` on some.

use core::ops::{Add, Shl};

use super::product_sum::SplitSum;
use super::word::{ProductSum, RawOffset, WholeWord, Word};
use crate::arithmetic::platform::HAS_LONG_PRODUCTS;

macro_rules! word {
    ($($word:ident, $sum:ty: $range:expr, $split:literal;)*) => {$(
        impl Word for $word {
            type Sum = $sum;

            const ZERO: Self = 0;
            const BITS: u32 = $word::BITS;
            const RANGE: u32 = $range;
            const SPLIT: u32 = $split;
            const LOWER: Self = (1 << $split) - 1;

            #[inline(always)]
            fn last_of(x: i64) -> Self {
                x as _
            }
            #[inline(always)]
            fn plus(self, other: Self) -> Self {
                self.wrapping_add(other)
            }
            #[inline(always)]
            fn minus(self, other: Self) -> Self {
                self.wrapping_sub(other)
            }
            #[inline(always)]
            fn bits(self) -> i32 {
                $word::BITS as i32 - self.leading_zeros() as i32
            }
            #[inline(always)]
            fn nearest_over(self, down: i32) -> i32 {
                if down <= 0 { (self as i32) << -down } else { (((self >> (down - 1)) + 1) >> 1) as i32 }
            }
        }
    )*};
}

word! {
    i16, i32: 6, 5;
    i32, <Products<HAS_LONG_PRODUCTS> as OfWords>::Sum: if HAS_LONG_PRODUCTS { 29 } else { 18 }, 10;
    i64, SplitSum<i64>: 34, 20;
    i128, SplitSum<i128>: 66, 40;
}

/// The products of a machine: whether they are long.
pub struct Products<const ARE_LONG: bool>;

/// The sum of products of words on such a machine.
pub trait OfWords {
    /// That sum.
    type Sum;
}

impl OfWords for Products<true> {
    type Sum = i64;
}

impl OfWords for Products<false> {
    type Sum = SplitSum<i32>;
}

impl WholeWord for i16 {
    type Whole = i32;
    const VOLUME_RANGE: u32 = 8;
}

impl WholeWord for i32 {
    type Whole = i64;
    const VOLUME_RANGE: u32 = 19;
}

impl WholeWord for i64 {
    type Whole = i128;
    const VOLUME_RANGE: u32 = 34;
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
    fn scaled_by(self, places: u32) -> i16 {
        (self >> (i16::SPLIT + places)) as i16
    }

    type Volume = Self;
    const ZERO: Self = 0;
    #[inline(always)]
    fn volume(self) -> Self {
        self
    }
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

/// For cores that multiply words in full in one or two instructions.
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
    fn scaled_by(self, places: u32) -> i32 {
        (self >> (i32::SPLIT + places)) as i32
    }

    /// From the upper word of an area, rounded to the nearest, and the remainder.
    type Volume = (i64, i64);
    const ZERO: (i64, i64) = (0, 0);
    #[inline(always)]
    fn volume(self) -> (i64, i64) {
        (0, self)
    }
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

impl RawOffset for i32 {
    const OFFSET_LIMIT: i32 = 1 << 29;
    const OUTSIDE: i32 = !(2 * Self::OFFSET_LIMIT - 1);

    #[inline(always)]
    fn below_unit(unit: f32) -> i32 {
        (unit as i32 - 1).max(0)
    }
    #[inline(always)]
    fn in_offset(self) -> f32 {
        self as f32
    }
}

impl RawOffset for i64 {
    // Below 2^51, adding two numbers converts a whole vector to `f64`; the processor's conversion
    // takes one number at a time.
    const OFFSET_LIMIT: i64 = 1 << 49;
    const OUTSIDE: i64 = !(2 * Self::OFFSET_LIMIT - 1);

    #[inline(always)]
    fn below_unit(unit: f32) -> i64 {
        ((unit * (1_u32 << 24) as f32) as i64 - 1).max(0)
    }
    #[inline(always)]
    fn in_offset(self) -> f32 {
        in_double(self) as f32
    }
}

/// A number below 2^51 in magnitude, divided by 2^24.
#[inline(always)]
fn in_double(x: i64) -> f64 {
    // 1.5·2^52 over 2^24: the last place is 2^-24.
    const SHIFTER: f64 = (3_u64 << (51 - 24)) as f64;
    f64::from_bits(SHIFTER.to_bits().wrapping_add(x as u64)) - SHIFTER
}
