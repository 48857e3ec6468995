//! Integers for the numbers of shapes, where registers hold 64 bits.

use crate::arithmetic::{BigInt, I256, Number, Parts};

/// Integers for the numbers of shapes, their products, and products of these.
pub(super) trait Integers {
    /// The numbers of the shapes.
    type Length: Number;
    /// Products of two lengths.
    type Area: Number;
    /// Products of an area and a length.
    type Volume: Number;
    /// Products of two areas.
    type Fourth: Number;

    /// The most bits of a length.
    const WIDTH: i32;
    /// The most bits of twice the reach of a shape beyond another.
    const REACH: i32;

    /// The number in units of 2^`low`.
    fn length(x: Parts, low: i32) -> Self::Length;
    fn widened(x: Self::Length) -> Self::Area;
    fn area(x: Self::Length, y: Self::Length) -> Self::Area;
    /// x·2^up.
    fn raised(x: Self::Area, up: u32) -> Self::Area;
    fn volume(x: Self::Area, y: Self::Length) -> Self::Volume;
    fn fourth(x: Self::Area, y: Self::Area) -> Self::Fourth;
}

/// Lengths in one word.
///
/// A side is below 2^61 and a coordinate of a cross product below 2^123. Its product with a reach
/// is below 2^249, and a sum of three such products below 2^251.
pub(super) struct Short;

impl Integers for Short {
    type Length = i64;
    type Area = i128;
    type Volume = I256;
    type Fourth = I256;

    const WIDTH: i32 = 60;
    const REACH: i32 = 126;

    fn length(x: Parts, low: i32) -> i64 {
        x.in_units(low)
    }
    fn widened(x: i64) -> i128 {
        x.into()
    }
    #[inline(always)]
    fn area(x: i64, y: i64) -> i128 {
        i128::from(x) * i128::from(y)
    }
    #[inline(always)]
    fn raised(x: i128, up: u32) -> i128 {
        x << up
    }
    fn volume(x: i128, y: i64) -> I256 {
        I256::product(x, y)
    }
    #[inline(always)]
    fn fourth(x: i128, y: i128) -> I256 {
        I256::of_two(x, y)
    }
}

/// Lengths in four words.
///
/// A side is below 2^251 and a coordinate of a cross product below 2^503. Its product with a reach
/// is below 2^1011, and a sum of three such products below 2^1013.
pub(super) struct Long;

impl Integers for Long {
    type Length = BigInt<4>;
    type Area = BigInt<8>;
    type Volume = BigInt<12>;
    type Fourth = BigInt<16>;

    const WIDTH: i32 = 250;
    const REACH: i32 = 508;

    fn length(x: Parts, low: i32) -> BigInt<4> {
        let mut length = BigInt::ZERO;
        if x.magnitude != 0 {
            let up = (i32::from(x.shift) - low) as usize;
            // Trailing zeros may lie below the unit.
            let down = x.magnitude.trailing_zeros();
            let words = core::iter::once(x.magnitude >> down);
            length.accumulate(words, up.wrapping_add(down as usize), x.negative);
        }
        length
    }
    fn widened(x: BigInt<4>) -> BigInt<8> {
        x.resized()
    }
    #[inline(never)]
    fn area(x: BigInt<4>, y: BigInt<4>) -> BigInt<8> {
        if x == BigInt::ZERO || y == BigInt::ZERO { BigInt::ZERO } else { x.times(&y) }
    }
    fn raised(x: BigInt<8>, up: u32) -> BigInt<8> {
        if up == 0 { x } else { x.shifted_up(up as usize) }
    }
    fn volume(x: BigInt<8>, y: BigInt<4>) -> BigInt<12> {
        x.times(&y)
    }
    #[inline(never)]
    fn fourth(x: BigInt<8>, y: BigInt<8>) -> BigInt<16> {
        x.times(&y)
    }
}
