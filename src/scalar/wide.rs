//! A 256-bit integer: what volumes of 64-bit scalars need, and no more.

use core::ops::{Add, Neg, Sub};

use super::number::Number;

/// A signed integer of 256 bits in two's complement. `high` comes first, so
/// that the derived order is the order of numbers.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct I256 {
    high: i128,
    low: u128,
}

impl I256 {
    /// The product of 128 and 64 bits.
    pub(super) fn product(a: i128, b: i64) -> Self {
        let (m, f) = (a.unsigned_abs(), u128::from(b.unsigned_abs()));
        let lower = (m & u128::from(u64::MAX)) * f;
        let upper = (m >> 64) * f + (lower >> 64);
        let magnitude = Self {
            high: (upper >> 64) as i128,
            low: (upper << 64) | (lower & u128::from(u64::MAX)),
        };
        if (a < 0) != (b < 0) { -magnitude } else { magnitude }
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
        self + -other
    }
}

impl Number for I256 {
    const ZERO: Self = Self { high: 0, low: 0 };
    fn magnitude(self) -> Self {
        if self.high < 0 { -self } else { self }
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
    fn holds_the_largest_volume() {
        let largest = I256::product(i128::MIN, i64::MIN);
        assert_eq!(largest, I256 { high: 1 << 62, low: 0 });
        assert_eq!(-largest, I256::product(i128::MIN, i64::MAX) - I256::product(i128::MIN, -1));
        assert!(-largest < I256::ZERO && (-largest).magnitude() == largest);
    }
}
