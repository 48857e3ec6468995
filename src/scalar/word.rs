//! Machine words, for kernels on cores whose registers have 32 bits.

use core::fmt::Debug;
use core::ops::{Add, BitAnd, BitOr, Mul, Neg, Shr, Sub};

/// A signed machine word, and how a kernel cuts one in two to keep products in
/// words of the same size.
///
/// A word x is its upper part x >> SPLIT times 2^SPLIT and its lower part
/// x & LOWER, which is never negative. With lengths up to 2^R and S for SPLIT,
///
/// | quantity | magnitude | `i32` | `i64` | `i128` |
/// | --- | --- | --- | --- | --- |
/// | reach, SPLIT | R, S | 18, 10 | 34, 20 | 66, 40 |
/// | edge, vertex to face | 2^(R+1) | 2^19 | 2^35 | 2^67 |
/// | two products with a lower part | 2^(R+2+S) | 2^30 | 2^56 | 2^108 |
/// | two products with an upper part | 2^(2R+3−S) | 2^29 | 2^51 | 2^95 |
/// | upper part of a normal's upper part, a | 2^(2R+3−2S) | 2^19 | 2^31 | 2^55 |
/// | a·(upper part of a length), three | 3·2^(3R+4−3S) | 2^29.6 | 2^47.6 | 2^83.6 |
/// | a·(lower part of a length), three | 3·2^(2R+3−S) | 2^30.6 | 2^52.6 | 2^96.6 |
/// | (lower part of a normal)·length, three | 3·2^(R+1+S) | 2^30.6 | 2^56.6 | 2^108.6 |
///
/// and the carries add less than 2^-8 of that.
pub trait Word:
    Copy
    + Ord
    + Debug
    + Add<Output = Self>
    + Sub<Output = Self>
    + Neg<Output = Self>
    + Mul<Output = Self>
    + Shr<u32, Output = Self>
    + BitAnd<Output = Self>
    + BitOr<Output = Self>
{
    /// Nought.
    const ZERO: Self;
    /// How many bits the lower part has.
    const SPLIT: u32;
    /// A mask for the lower part.
    const LOWER: Self;

    /// Whether a word is wider than a narrow register: an operation takes many
    /// instructions then, or a call.
    const IS_WIDE: bool;

    /// Whether a·b < c·d, on a core with one instruction for the product of two
    /// words in full; elsewhere `None`.
    fn is_less(a: Self, b: Self, c: Self, d: Self) -> Option<bool>;

    /// The sum, wrapped.
    fn plus(self, other: Self) -> Self;
    /// The difference, wrapped.
    fn minus(self, other: Self) -> Self;

    /// Whether all numbers lie within the reach of the first, even where their
    /// differences would overflow.
    fn are_near(first: Self, others: impl Iterator<Item = Self>) -> bool;
}

macro_rules! word {
    ($($word:ident, $unsigned:ident: $reach:literal, $split:literal;)*) => {$(
        impl Word for $word {
            const ZERO: Self = 0;
            const SPLIT: u32 = $split;
            const LOWER: Self = (1 << $split) - 1;

            const IS_WIDE: bool = $word::BITS > 32;

            #[inline(always)]
            fn is_less(a: Self, b: Self, c: Self, d: Self) -> Option<bool> {
                // ARMv6-M has neither long products nor atomics, ARMv7-M both. Only
                // the latter can be asked for in stable Rust.
                let is_long = !Self::IS_WIDE && cfg!(all(target_arch = "arm", target_has_atomic = "32"));
                is_long.then(|| (a as i64) * (b as i64) < (c as i64) * (d as i64))
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
            fn are_near(first: Self, others: impl Iterator<Item = Self>) -> bool {
                // Of halves, whose differences fit.
                let from = (first >> 1) - (1 << ($reach - 1));
                others.fold(0, |all, x| all | (x >> 1).wrapping_sub(from) as $unsigned)
                    >> $reach == 0
            }
        }
    )*};
}
word! {
    i32, u32: 18, 10;
    i64, u64: 34, 20;
    i128, u128: 66, 40;
}

/// A scalar whose raw bits fit a word.
pub trait InWord<W: Word> {
    /// Whether two points and a box around a third are always in reach of each
    /// other.
    const ALWAYS_NEAR: bool;

    /// The raw bits.
    fn in_word(self) -> W;
}

/// What `f` says, by a call.
#[inline(never)]
pub(crate) fn out_of_line<T>(f: impl FnOnce() -> T) -> T {
    f()
}

/// The expression, and in wide words a call of it, so that there is one copy.
/// A closure alone will not do: where it is used twice it is not inlined for narrow
/// words either.
macro_rules! out_of_line_if_wide {
    ($word:ident, $value:expr) => {
        if $word::IS_WIDE { $crate::scalar::out_of_line(move || $value) } else { $value }
    };
}
pub(crate) use out_of_line_if_wide;
