//! Integers for the numbers of two shapes, by their length and the machine.

use core::cmp::Ordering;
use core::mem::size_of;

use super::exact::Size;
use crate::arithmetic::{
    BigInt, Each, I256, Number, Parts, REGISTERS_ARE_WIDE, SMALL_CODE, Soft, compare, of_four,
    product, three,
};
use crate::scalar::Scalar;

/// Whether [`Words`] may hold the numbers of a scalar, on a core that computes `f64` by functions. Such a
/// contact has its direction without `f64` and without long sums. A contact in floats links both; in small code
/// it has the long sums alone.
pub(super) const fn has_words<S: Scalar>() -> bool {
    let is_served = S::FLOAT.is_none() || !SMALL_CODE;
    !REGISTERS_ARE_WIDE && size_of::<S>() <= size_of::<u32>() && is_served
}

/// Whether they hold all numbers of a scalar.
pub(super) const fn is_whole<S: Scalar>() -> bool {
    size_of::<S>() <= size_of::<u32>() && S::FLOAT.is_none()
}

/// Integers for the numbers of shapes and for their products.
pub(super) trait Integers {
    /// The numbers of the shapes.
    type Length: Number;
    /// Products of two lengths.
    type Area: Number;

    /// The number in units of 2^`low`.
    fn length(x: Parts, low: i32) -> Self::Length;
    fn area(x: Self::Length, y: Self::Length) -> Self::Area;
    /// x·2^up, as an area.
    fn placed(x: Self::Length, up: u32) -> Self::Area;
    /// x·2^up.
    fn raised(x: Self::Area, up: u32) -> Self::Area;
    /// The sign of a·v.
    fn side(a: &[Self::Area; 3], v: &[Self::Length; 3]) -> Ordering;
    /// a·v, if it is above zero.
    fn size(a: &[Self::Area; 3], v: &[Self::Area; 3]) -> Size;
}

fn above_zero<T: Number>(x: T) -> Size {
    let (sign, size) = x.sign_and_size()?;
    sign.is_gt().then_some(size)
}

/// Lengths in one word, where registers hold 64 bits.
///
/// A side is below 2^61 and a coordinate of a cross product below 2^123. Its product with a reach
/// is below 2^249, and a sum of three such products below 2^251.
pub(super) struct Short;

impl Short {
    /// The most bits of a length.
    pub(super) const WIDTH: i32 = 60;
    /// The most bits of twice the reach of a shape beyond another.
    pub(super) const REACH: i32 = 126;
}

impl Integers for Short {
    type Length = i64;
    type Area = i128;

    fn length(x: Parts, low: i32) -> i64 {
        x.in_units(low)
    }
    #[inline(always)]
    fn area(x: i64, y: i64) -> i128 {
        i128::from(x) * i128::from(y)
    }
    #[inline(always)]
    fn placed(x: i64, up: u32) -> i128 {
        i128::from(x) << up
    }
    #[inline(always)]
    fn raised(x: i128, up: u32) -> i128 {
        x << up
    }
    fn side(a: &[i128; 3], v: &[i64; 3]) -> Ordering {
        let [x, y, z] = three(|i| I256::product(a[i], v[i]));
        compare(x + y + z, I256::ZERO)
    }
    fn size(a: &[i128; 3], v: &[i128; 3]) -> Size {
        let [x, y, z] = three(|i| I256::of_two(a[i], v[i]));
        above_zero(x + y + z)
    }
}

/// Lengths in four words, where registers hold 64 bits.
///
/// A side is below 2^251 and a coordinate of a cross product below 2^503. Its product with a reach
/// is below 2^1011, and a sum of three such products below 2^1013.
pub(super) struct Long;

impl Long {
    pub(super) const WIDTH: i32 = 250;
    pub(super) const REACH: i32 = 508;
}

impl Integers for Long {
    type Length = BigInt<4>;
    type Area = BigInt<8>;

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
    #[inline(never)]
    fn area(x: BigInt<4>, y: BigInt<4>) -> BigInt<8> {
        if x == BigInt::ZERO || y == BigInt::ZERO { BigInt::ZERO } else { x.times(&y) }
    }
    fn placed(x: BigInt<4>, up: u32) -> BigInt<8> {
        Self::raised(x.resized(), up)
    }
    fn raised(x: BigInt<8>, up: u32) -> BigInt<8> {
        if up == 0 { x } else { x.shifted_up(up as usize) }
    }
    fn side(a: &[BigInt<8>; 3], v: &[BigInt<4>; 3]) -> Ordering {
        let [x, y, z]: [BigInt<12>; 3] = three(|i| a[i].times(&v[i]));
        (x + y + z).sign()
    }
    fn size(a: &[BigInt<8>; 3], v: &[BigInt<8>; 3]) -> Size {
        let [x, y, z]: [BigInt<16>; 3] = three(|i| a[i].product(&v[i]));
        above_zero(x + y + z)
    }
}

/// The numbers of a scalar that [`has_words`], in fixed point in units of its least number: lengths of up to 33
/// bits, whose products take one instruction where that suffices.
pub(super) struct Words;

impl Integers for Words {
    type Length = i64;
    type Area = i128;

    fn length(x: Parts, low: i32) -> i64 {
        // Cores without such a shift call a function.
        let is_in_units = i32::from(x.shift) == low;
        let size = if is_in_units { x.magnitude as i64 } else { x.in_units(low) };
        if is_in_units && x.negative { -size } else { size }
    }
    #[inline(never)]
    fn area(x: i64, y: i64) -> i128 {
        let (a, b) = (x as i32, y as i32);
        if i64::from(a) == x && i64::from(b) == y {
            return product(a, b).into();
        }
        of_four(x, y)
    }
    fn placed(x: i64, up: u32) -> i128 {
        Self::area(x, 1 << up)
    }
    fn raised(x: i128, up: u32) -> i128 {
        if up == 0 { x } else { x << up }
    }
    fn side(a: &[i128; 3], v: &[i64; 3]) -> Ordering {
        in_parts(a, &three(|i| v[i].into())).cmp(&(0, 0))
    }
    fn size(a: &[i128; 3], v: &[i128; 3]) -> Size {
        let (upper, lower) = in_parts(a, v);
        if upper < 0 || (upper, lower) == (0, 0) {
            return None;
        }
        let (upper, lower) = (upper as u128, u128::from(lower));
        Some(if upper >> 96 == 0 {
            Soft::of(upper << 32 | lower, 0, 0)
        } else {
            Soft::of(upper, u128::from(lower != 0), 32)
        })
    }
}

/// Whether 62 bits and a sign hold the number.
pub(super) fn is_short(x: i128) -> bool {
    x >> 62 == x >> 127
}

/// The product of a vector below 2^66 and one below 2^90: a multiple of 2^32, and the rest.
#[inline(never)]
fn in_parts(a: &[i128; 3], v: &[i128; 3]) -> (i128, u32) {
    let (mut upper, mut lower) = (0, 0);
    for (&a, &b) in a.iter().zip(v) {
        // Three products are below 2^126.
        if is_short(a) && is_short(b) {
            lower += Words::area(a as i64, b as i64);
        } else {
            let [[a1, a0], [b1, b0]] = [a, b].each(|x| [(x >> 32) as i64, i64::from(x as u32)]);
            upper += (Words::area(a1, b1) << 32) + Words::area(a1, b0) + Words::area(a0, b1);
            lower += Words::area(a0, b0);
        }
    }
    (upper + (lower >> 32), lower as u32)
}
