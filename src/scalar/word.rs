//! Machine words, for kernels on cores whose registers have 32 bits.

use core::fmt::Debug;
use core::ops::{Add, BitAnd, BitOr, BitXor, Mul, Shr, Sub};

use super::area::{Area, Pair};

/// A signed machine word, in which a kernel keeps lengths.
///
/// Lengths are measured from the least corner of the box. With lengths up to 2^R, the
/// reach, and S for SPLIT, where [`Pair`] cuts a word in two,
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
/// and the carries add less than 2^-8 of that. Where `i64` holds the areas of `i32`,
/// the reach is 29: a normal is up to 2^61, its upper word up to 2^29, three products of
/// that and a length up to 3·2^59, and of its lower word and a length up to 3·2^61.
pub trait Word:
    Copy
    + Ord
    + Debug
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Shr<u32, Output = Self>
    + BitAnd<Output = Self>
    + BitOr<Output = Self>
    + BitXor<Output = Self>
{
    /// What holds an area on the core at hand.
    type Area: Area<Self>;

    /// Nought.
    const ZERO: Self;
    /// How many bits the lower part has.
    const SPLIT: u32;
    /// A mask for the lower part.
    const LOWER: Self;

    /// Whether a word is wider than a narrow register: an operation takes many
    /// instructions then, or a call.
    const IS_WIDE: bool;

    /// The sum, wrapped.
    fn plus(self, other: Self) -> Self;
    /// The difference, wrapped.
    fn minus(self, other: Self) -> Self;

    /// The word where `other` is negative, and otherwise nought.
    fn where_negative(self, other: Self) -> Self;
    /// The word where `other` is not negative, and otherwise nought.
    fn unless_negative(self, other: Self) -> Self;

    /// The word, or if it is negative all its bits flipped.
    fn folded(self) -> Self;
    /// Whether a length lies within the reach.
    fn is_near(self) -> bool;
    /// Whether a difference from this word that is within the reach cannot be wrapped:
    /// in the middle half of the range, wrapped differences are long.
    fn is_central(self) -> bool;
}

macro_rules! word {
    ($($word:ident, $unsigned:ident, $area:ty: $reach:literal, $split:literal;)*) => {$(
        impl Word for $word {
            type Area = $area;

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
                (self as $unsigned) >> $reach == 0
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
#[cfg(any(
    all(target_arch = "arm", target_has_atomic = "32"),
    all(target_arch = "riscv32", target_feature = "m"),
))]
word! { i32, u32, i64: 29, 10; }
#[cfg(not(any(
    all(target_arch = "arm", target_has_atomic = "32"),
    all(target_arch = "riscv32", target_feature = "m"),
)))]
word! { i32, u32, Pair<i32>: 18, 10; }
word! {
    i64, u64, Pair<i64>: 34, 20;
    i128, u128, Pair<i128>: 66, 40;
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
