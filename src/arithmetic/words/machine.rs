//! The words of the machines: `i32` where one multiplication holds a product, wider ones made of
//! several, and `i16`, for which one multiplication holds a product on every core.

use super::word::{WholeWord, Word};
use super::{ProductSum, SplitSum};

macro_rules! word {
    ($($word:ident, $unsigned:ident, $sum:ty: $range:literal, $split:literal;)*) => {$(
        impl Word for $word {
            type Sum = $sum;

            const ZERO: Self = 0;
            const SPLIT: u32 = $split;
            const LOWER: Self = (1 << $split) - 1;

            const IS_WIDE: bool = $word::BITS > 32;

            #[inline(always)]
            fn plus(self, other: Self) -> Self {
                self.wrapping_add(other)
            }
            #[inline(always)]
            fn minus(self, other: Self) -> Self {
                self.wrapping_sub(other)
            }
            #[inline(always)]
            fn where_negative(self, other: Self) -> Self {
                self & (other >> ($word::BITS - 1))
            }
            #[inline(always)]
            fn unless_negative(self, other: Self) -> Self {
                self & !(other >> ($word::BITS - 1))
            }
            #[inline(always)]
            fn folded(self) -> Self {
                self ^ (self >> ($word::BITS - 1))
            }
            #[inline(always)]
            fn is_near(self) -> bool {
                (self as $unsigned) >> $range == 0
            }
            #[inline(always)]
            fn is_central(self) -> bool {
                self ^ (self << 1) >= 0
            }
        }
    )*};
}

// ARMv6-M has neither long products nor atomics, ARMv7-M both. Only the latter can be
// asked for in stable Rust. RISC-V has long products where it has any.
// Where registers hold 64 bits there is nothing to choose, but for tests of the other way.
#[cfg(any(
    all(target_arch = "arm", target_has_atomic = "32"),
    all(target_arch = "riscv32", target_feature = "m"),
    all(any(target_pointer_width = "64", target_arch = "wasm32"), not(septum_narrow)),
))]
word! { i32, u32, i64: 29, 10; }
#[cfg(not(any(
    all(target_arch = "arm", target_has_atomic = "32"),
    all(target_arch = "riscv32", target_feature = "m"),
    all(any(target_pointer_width = "64", target_arch = "wasm32"), not(septum_narrow)),
)))]
word! { i32, u32, SplitSum<i32>: 18, 10; }
/// The range of lengths, and how a sum becomes one number.
macro_rules! whole_word {
    ($($word:ident, $unsigned:ident, $whole:ident: $range:literal;)*) => {$(
        impl WholeWord for $word {
            type Whole = $whole;

            #[inline(always)]
            fn has_volumes(self) -> bool {
                (self as $unsigned) >> $range == 0
            }
            #[inline(always)]
            fn whole(volume: <Self::Sum as ProductSum<Self>>::Volume) -> $whole {
                <Self::Sum as ProductSum<Self>>::whole::<$whole>(volume)
            }
        }
    )*};
}
whole_word! {
    i16, u16, i32: 8;
    i32, u32, i64: 19;
    i64, u64, i128: 34;
}
word! {
    i16, u16, i32: 6, 5;
    i64, u64, SplitSum<i64>: 34, 20;
    i128, u128, SplitSum<i128>: 66, 40;
}
