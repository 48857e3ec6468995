//! A 256-bit integer, for volumes of 64-bit scalars.

use core::cmp::Ordering;
use core::ops::{Add, Neg, Sub};

use super::limbs::Limbs;
use super::number::{Number, signed};
use super::platform::REGISTERS_ARE_WIDE;
use super::portion::divided_limbs;
use super::soft::Soft;

/// A signed integer of 256 bits in two's complement. `high` comes first, so that the derived order
/// is numeric.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct I256 {
    high: i128,
    low: u128,
}

impl I256 {
    /// The product of 128 and 64 bits.
    #[inline]
    pub(crate) fn product(a: i128, b: i64) -> Self {
        if REGISTERS_ARE_WIDE { Self::halves(a, b) } else { Self::halves_out_of_line(a, b) }
    }

    /// The product, in one function: with narrow registers it takes hundreds of bytes.
    #[inline(never)]
    fn halves_out_of_line(a: i128, b: i64) -> Self {
        Self::halves(a, b)
    }

    #[inline(always)]
    fn halves(a: i128, b: i64) -> Self {
        let (upper, lower) = (a >> 64, i128::from(a as u64));
        let (upper, lower) = (upper * i128::from(b), lower * i128::from(b));
        let (low, carry) = ((upper as u128) << 64).overflowing_add(lower as u128);
        Self { high: (upper >> 64) + (lower >> 127) + i128::from(carry), low }
    }

    /// The product of two 128-bit numbers that are not the least of the type.
    pub(crate) fn of_two(a: i128, b: i128) -> Self {
        let halves = |x: i128| {
            let x = x.unsigned_abs();
            (x >> 64, u128::from(x as u64))
        };
        let ((a_high, a_low), (b_high, b_low)) = (halves(a), halves(b));
        let (middle, carry) = (a_high * b_low).overflowing_add(a_low * b_high);
        let (low, carry_too) = (a_low * b_low).overflowing_add(middle << 64);
        let high = a_high * b_high + (middle >> 64) + (u128::from(carry) << 64);
        let product = Self { high: (high + u128::from(carry_too)) as i128, low };
        if (a < 0) == (b < 0) { product } else { -product }
    }

    /// Sign and magnitude, the latter in limbs, least first.
    pub(crate) fn limbs(self) -> (bool, [u64; 4]) {
        let Self { high, low } = self.magnitude();
        let limbs = [low as u64, (low >> 64) as u64, high as u64, (high >> 64) as u64];
        (self.high < 0, limbs)
    }
}

/// Further operations for quotients.
#[cfg(feature = "fixed")]
impl I256 {
    /// The number these limbs make in two's complement, the least first.
    pub(crate) fn from_limbs([a, b, c, d]: [u64; 4]) -> Self {
        let two = |low: u64, high: u64| u128::from(high) << 64 | u128::from(low);
        Self { high: two(c, d) as i128, low: two(a, b) }
    }

    /// The number in 128 bits, if they hold it and leave one bit to spare.
    pub(crate) fn narrowed(self) -> Option<i128> {
        let sign = self.high >> 127;
        (self.high == sign && (self.low as i128) >> 126 == sign).then_some(self.low as i128)
    }

    /// Times two to the power `shift`, at most 64; the product must fit.
    pub(crate) fn shifted_up(self, shift: u32) -> Self {
        if shift == 0 {
            return self;
        }
        Self {
            high: self.high << shift | (self.low >> (128 - shift)) as i128,
            low: self.low << shift,
        }
    }

    /// Times `factor`; the product must fit.
    pub(crate) fn times(self, factor: i64) -> Self {
        let (negative, limbs) = self.limbs();
        let (mut product, mut carry) = ([0; 4], 0);
        for (to, limb) in product.iter_mut().zip(limbs) {
            let wide = u128::from(limb) * u128::from(factor.unsigned_abs()) + u128::from(carry);
            *to = wide as u64;
            carry = (wide >> 64) as u64;
        }
        let magnitude = Self::from_limbs(product);
        if negative != (factor < 0) { -magnitude } else { magnitude }
    }
}

impl From<i128> for I256 {
    fn from(x: i128) -> Self {
        Self { high: x >> 127, low: x as u128 }
    }
}

impl Add for I256 {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        let (low, carry) = self.low.overflowing_add(other.low);
        Self { high: self.high.wrapping_add(other.high).wrapping_add(carry.into()), low }
    }
}

impl Neg for I256 {
    type Output = Self;
    fn neg(self) -> Self {
        let (low, carry) = (!self.low).overflowing_add(1);
        Self { high: (!self.high).wrapping_add(carry.into()), low }
    }
}

impl Sub for I256 {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        let (low, borrow) = self.low.overflowing_sub(other.low);
        Self { high: self.high.wrapping_sub(other.high).wrapping_sub(borrow.into()), low }
    }
}

impl Number for I256 {
    const ZERO: Self = Self { high: 0, low: 0 };
    fn magnitude(self) -> Self {
        if self.high < 0 { -self } else { self }
    }
    fn portion(self, den: Self, _: [Self; 2]) -> [Soft; 2] {
        [divided_limbs(Limbs(self.limbs().1), &Limbs(den.limbs().1)); 2]
    }
    fn sign_and_size(self) -> Option<(Ordering, Soft)> {
        signed(self.limbs())
    }
    fn half(self) -> Self {
        Self { high: self.high >> 1, low: self.low >> 1 | (self.high as u128) << 127 }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn agrees_with_i128_where_that_suffices() {
        let some = [-(1_i128 << 61), -12345, -1, 0, 1, 77, (1 << 61) - 1];
        for a in some {
            for b in some {
                let product = I256::product(a, b as i64);
                let expected = I256::product(a * b, 1);
                assert_eq!(product, expected);
                assert_eq!(I256::product(a, 1) < I256::product(b, 1), a < b);
                assert_eq!(I256::product(a, 1) + I256::product(b, 1), I256::product(a + b, 1));
                assert_eq!(I256::product(a, 1) - I256::product(b, 1), I256::product(a - b, 1));
            }
        }
    }

    #[test]
    fn products_of_two_agree_with_those_of_one_and_a_half() {
        let some = [-(1_i128 << 126), -(u128::MAX as i128 >> 3) - 99, -1, 0, 1, 7, i128::MAX];
        for a in some {
            for b in [i64::MIN, -12345, -1, 0, 1, 77, i64::MAX] {
                let (b, by_half) = (i128::from(b), I256::product(a, b));
                assert_eq!((I256::of_two(a, b), I256::of_two(b, a)), (by_half, by_half));
                // a·(b·2^60) as 2^60·(a·b), if 256 bits hold that.
                let shifted = (0..60).fold(by_half, |x, _| x + x);
                assert_eq!(I256::of_two(a, b << 60), shifted);
            }
        }
        let greatest = I256::of_two(i128::MAX, i128::MAX);
        assert_eq!(greatest, I256 { high: (1 << 126) - 1, low: 1 });
    }

    #[test]
    fn holds_the_largest_volume() {
        let largest = I256::product(i128::MIN, i64::MIN);
        assert_eq!(largest, I256 { high: 1 << 62, low: 0 });
        assert_eq!(-largest, I256::product(i128::MIN, i64::MAX) - I256::product(i128::MIN, -1));
        assert!(-largest < I256::ZERO && (-largest).magnitude() == largest);
    }
}
