//! The words that hold the bits of a grid.

/// A word of a grid of bits: `u32` or `u64`.
pub trait Word: sealed::Word {}

impl Word for u32 {}
impl Word for u64 {}

mod sealed {
    use core::ops::{BitAnd, BitOr, BitOrAssign, BitXor, BitXorAssign, Shl, Shr};

    pub trait Word:
        Copy
        + BitAnd<Output = Self>
        + BitOr<Output = Self>
        + BitOrAssign
        + BitXor<Output = Self>
        + BitXorAssign
        + Shl<u32, Output = Self>
        + Shr<u32, Output = Self>
        + PartialEq
    {
        const BITS: u32;
        const ZERO: Self;
        const ONE: Self;
        const ALL: Self;
        fn of(bits: u32) -> Self;
        /// A word with the `count` least bits set, `count` below `BITS`.
        fn first(count: u32) -> Self;
        fn ones(self) -> u32;
        /// The number of zeros below the least bit.
        fn zeros(self) -> u32;
    }

    macro_rules! word {
        ($($word:ident)*) => {$(
            impl Word for $word {
                const BITS: u32 = $word::BITS;
                const ZERO: Self = 0;
                const ONE: Self = 1;
                const ALL: Self = $word::MAX;
                #[inline(always)]
                fn of(bits: u32) -> Self {
                    bits.into()
                }
                #[inline(always)]
                fn first(count: u32) -> Self {
                    !(Self::ALL << count)
                }
                #[inline(always)]
                fn ones(self) -> u32 {
                    self.count_ones()
                }
                #[inline(always)]
                fn zeros(self) -> u32 {
                    self.trailing_zeros()
                }
            }
        )*};
    }
    word! { u32 u64 }
}
