//! The operations of a machine word in a kernel, and raw bits of fixed point, cut to few bits.

use core::cmp::Ordering;
use core::fmt::Debug;
use core::ops::{Add, BitAnd, BitOr, BitXor, Mul, Not, Shl, Shr, Sub};

use super::places::WholeVolume;

/// A signed machine word in which a kernel stores lengths.
///
/// Lengths are measured from the least corner of the box. With lengths up to 2^R, the range, and S
/// for SPLIT, where [`SplitSum`](super::product_sum::SplitSum) cuts a word in two,
///
/// | quantity | magnitude | `i32` | `i64` | `i128` |
/// | --- | --- | --- | --- | --- |
/// | range, SPLIT | R, S | 18, 10 | 34, 20 | 66, 40 |
/// | edge, vertex to face | 2^(R+1) | 2^19 | 2^35 | 2^67 |
/// | two products with a lower part | 2^(R+2+S) | 2^30 | 2^56 | 2^108 |
/// | two products with an upper part | 2^(2R+3−S) | 2^29 | 2^51 | 2^95 |
/// | upper part of a normal's upper part, a | 2^(2R+3−2S) | 2^19 | 2^31 | 2^55 |
/// | a·(upper part of a length), three | 3·2^(3R+4−3S) | 2^29.6 | 2^47.6 | 2^83.6 |
/// | a·(lower part of a length), three | 3·2^(2R+3−S) | 2^30.6 | 2^52.6 | 2^96.6 |
/// | (lower part of a normal)·length, three | 3·2^(R+1+S) | 2^30.6 | 2^56.6 | 2^108.6 |
///
/// and the carries add less than 2^-8 of that. If `i64` holds the areas of `i32`, the range is 29.
/// A normal is then up to 2^61 and its upper word up to 2^29. Three products of that with a length
/// are up to 3·2^59, and three of its lower word with a length up to 3·2^61. `i16` is for lengths
/// up to 2^6, whose normals are up to 2^15.
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
    + Not<Output = Self>
{
    /// The type of a sum of products on this core.
    type Sum: ProductSum<Self>;

    /// Zero.
    const ZERO: Self;
    /// The number of bits.
    const BITS: u32;
    /// Lengths within the range are below two to this power.
    const RANGE: u32;
    /// The number of bits of the lower part.
    const SPLIT: u32;
    /// A mask for the lower part.
    const LOWER: Self;

    /// Whether a word is wider than a narrow register. An operation then takes many instructions,
    /// or a call.
    const IS_WIDE: bool = Self::BITS > 32;

    /// The last bits of a number, or all bits and copies of the sign.
    fn last_of(x: i64) -> Self;

    /// The sum, wrapped.
    fn plus(self, other: Self) -> Self;
    /// The difference, wrapped.
    fn minus(self, other: Self) -> Self;

    /// The word if `other` is negative, and otherwise zero.
    #[inline(always)]
    fn where_negative(self, other: Self) -> Self {
        self & (other >> (Self::BITS - 1))
    }
    /// The word if `other` is not negative, and otherwise zero.
    #[inline(always)]
    fn unless_negative(self, other: Self) -> Self {
        self & !(other >> (Self::BITS - 1))
    }

    /// The word; if it is negative, with all its bits flipped.
    #[inline(always)]
    fn folded(self) -> Self {
        self ^ (self >> (Self::BITS - 1))
    }
    /// Whether a length lies within the range.
    #[inline(always)]
    fn is_near(self) -> bool {
        self >> Self::RANGE == Self::ZERO
    }
    /// Whether no difference from this word within the range can be wrapped. From the middle half
    /// of the range, wrapped differences are long.
    #[inline(always)]
    fn is_central(self) -> bool {
        self ^ self.plus(self) >= Self::ZERO
    }

    /// The number of bits that hold the word, which is not below zero.
    fn bits(self) -> i32;
    /// The word over 2^`down`, to the nearest, where `down` is at most its bits: 31 bits hold it.
    fn nearest_over(self, down: i32) -> i32;
}

/// A sum of products of two lengths: see the table at [`Word`].
pub trait ProductSum<W>: Copy {
    /// a·b + c·d.
    fn new(a: W, b: W, c: W, d: W) -> Self;

    /// The sum with one more product, a·b.
    fn with_product(self, a: W, b: W) -> Self;

    /// A word that is negative exactly if the area is.
    fn sign(self) -> W;

    /// The sum over 2^[`SPLIT`](super::Word::SPLIT), rounded down, if a word holds it.
    #[inline(always)]
    fn scaled(self) -> W {
        self.scaled_by(0)
    }

    /// [`scaled`](Self::scaled) over 2^`places`, rounded down.
    fn scaled_by(self, places: u32) -> W;

    /// A sum of products of an area and a length.
    type Volume: Copy;
    /// The area times one.
    fn volume(self) -> Self::Volume;
    /// The empty sum.
    const ZERO: Self::Volume;
    /// The sum with one more product.
    fn sum(volume: Self::Volume, area: Self, length: W) -> Self::Volume;
    /// Whether the sum is negative.
    fn is_negative(volume: Self::Volume) -> bool;
    /// The type of the parts of a sum.
    type Part;
    /// The sum as one number, for a `T` that can hold it.
    fn whole<T>(volume: Self::Volume) -> T
    where
        T: From<Self::Part> + Add<Output = T> + Shl<u32, Output = T>;
}

/// A word with a wider type for whole sums of products of three lengths.
///
/// With lengths up to 2^R, SPLIT as in [`Word`], and an unsplit operand of an area up to 2^(R+1),
///
/// | quantity | magnitude | `i32` | `i64` |
/// | --- | --- | --- | --- |
/// | range | R | 19 | 34 |
/// | two products with a lower part | 2^(R+2+S) − 2^(R+2) | 2^31 − 2^21 | 2^56 |
/// | two products with an upper part | 2^(2R+2−S) | 2^30 | 2^50 |
/// | (lower part of an area)·length, three | 3·2^(R+S) | 2^30.6 | 2^55.6 |
/// | (upper part of its upper part)·(part of a length), three | 3·2^(2R+1−S) | 2^30.6 | 2^50.6 |
/// | determinant | 4·2^(3R) | 2^59 | 2^104 |
///
/// For `i16` the range is 8, nothing is split, and three products of areas are below 3·2^25.
pub trait WholeWord: Word {
    /// The type of the whole sums.
    type Whole: WholeVolume
        + From<Self>
        + From<<Self::Sum as ProductSum<Self>>::Part>
        + Shl<u32, Output = Self::Whole>;

    /// Lengths within the range are below two to this power.
    const VOLUME_RANGE: u32;

    /// 2^n, if the word holds it and leaves one bit to spare.
    #[inline(always)]
    fn power_of_two(n: u32) -> Option<Self> {
        (n + 2 <= Self::BITS).then(|| Self::last_of(1 << n))
    }

    /// Whether a length lies within the range.
    #[inline(always)]
    fn has_volumes(self) -> bool {
        self >> Self::VOLUME_RANGE == Self::ZERO
    }

    /// The sum as one number.
    #[inline(always)]
    fn whole(volume: <Self::Sum as ProductSum<Self>>::Volume) -> Self::Whole {
        <Self::Sum as ProductSum<Self>>::whole(volume)
    }
}

/// A word of raw bits, and the number of last places in a unit.
pub trait RawOffset: Sized {
    /// The limit of coordinates.
    const OFFSET_LIMIT: Self;
    /// The bits that a coordinate plus the limit has only outside of the limit.
    const OUTSIDE: Self;

    /// A mask for the places below a unit.
    fn below_unit(unit: f32) -> Self;

    /// The difference in units.
    fn in_offset(self) -> f32;
}

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

    /// The raw bits, in a word that holds them.
    #[inline(always)]
    fn in_word<W: Word>(self) -> W {
        const { assert!(Self::BITS <= W::BITS) }
        W::last_of(self.raw().into())
    }

    /// Whether two points and a box around a third are always within the range of each other in a word.
    #[must_use]
    fn is_always_near<W: Word>() -> bool {
        Self::BITS < W::BITS
    }

    /// One, if the word holds it and leaves one bit to spare.
    #[inline(always)]
    fn one_in<W: WholeWord>() -> Option<W> {
        W::power_of_two(Self::FRACTION_BITS as u32)
    }

    /// The places of one. It takes one place more than the numbers below it, if the type has that many.
    #[inline(always)]
    fn places_of_one() -> u32 {
        let fraction = Self::FRACTION_BITS as u32;
        if fraction < Self::BITS { fraction + 1 } else { fraction }
    }

    /// num/den to the nearest, ties to even, or the end of the type, place by place; `den` is above zero.
    #[inline(always)]
    fn divided<V: WholeVolume>(num: V, den: V) -> Self {
        let q = num.magnitude().nearest(den, Self::FRACTION_BITS as u32, Self::BITS);
        Self::clamped(if num < V::ZERO { -i64::from(q) } else { q.into() })
    }

    /// num/den likewise, if it is from zero to one.
    #[inline(always)]
    fn share<V: WholeVolume>(num: V, den: V) -> Self {
        let q = num.nearest(den, Self::FRACTION_BITS as u32, Self::places_of_one());
        Self::clamped(q.into())
    }

    /// num/den rounded down, or the end of the type, if it is above zero and at most one.
    #[inline(always)]
    fn portion<V: WholeVolume>(num: V, den: V) -> Self {
        let quotient = num.places(den, Self::FRACTION_BITS as u32, Self::places_of_one());
        Self::clamped(quotient.map_or(Self::GREATEST, |(q, _)| q.into()))
    }

    /// How num/den compares with `t`; `den` is above zero.
    #[inline(always)]
    fn compare_quotient<V: WholeVolume>(num: V, den: V, t: Self) -> Ordering {
        let fraction = Self::FRACTION_BITS as u32;
        WholeVolume::compare_quotient(num, den, fraction, Self::BITS, t.raw().into())
    }
}
