//! Quotients between zero and one, rounded down to 64 digits.
//!
//! Rounded down again to the fewer digits of a scalar, a quotient is what it would be had it
//! been rounded once: each number of a scalar from zero to one is among those of 64 digits. And
//! rounding keeps order, so the greatest of rounded quotients is the greatest quotient, rounded.

use super::limbs::{Limbs, Wide, divided_by_places};

/// A quotient, `mantissa`·2^(`exponent` − 64) with the mantissa's highest bit set, or zero.
/// The exponent comes first, so that the derived order is the order of numbers.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct Portion {
    exponent: i32,
    mantissa: u64,
}

impl Portion {
    /// Zero.
    pub(crate) const ZERO: Self = Self { exponent: i32::MIN, mantissa: 0 };
    /// One, or anything beyond.
    pub(crate) const ONE: Self = Self { exponent: 1, mantissa: 1 << 63 };

    /// A float that is normal, above zero and not above one.
    #[inline(always)]
    pub(crate) fn of(x: f64) -> Self {
        of_normal(x)
    }

    /// A number that is above zero, as a whole one times two to the power `exponent`.
    #[inline(always)]
    fn of_whole(magnitude: u64, exponent: i32) -> Self {
        let zeros = magnitude.leading_zeros();
        if zeros == 64 {
            return Self::ZERO;
        }
        Self { exponent: exponent + 64 - zeros as i32, mantissa: magnitude << zeros }
    }

    /// The quotient, in whole multiples of 2^`places` rounded down, of which there are less than
    /// 2^64; and to so many digits as given. The first is what a fixed-point number has, and a
    /// float below its least normal number; the second is any float.
    #[inline(always)]
    pub(crate) fn whole(self, digits: u32, least: i32) -> (u64, i32) {
        let unit = self.exponent.saturating_sub(digits as i32);
        let unit = if unit > least { unit } else { least };
        let shift = i64::from(unit) + 64 - i64::from(self.exponent);
        let shift = u32::try_from(shift).unwrap_or(0);
        (self.mantissa.checked_shr(shift).unwrap_or(0), unit)
    }
}

/// Two numbers that enclose num/den, given how far from the truth the two may be.
///
/// Either carries the roundings of a difference, a sum and a quotient: 3u of itself, to first
/// order. 8u are allowed for; so 5 are left for the roundings of that and for second orders.
#[inline(always)]
pub(super) fn enclosing(num: f64, den: f64, [num_error, den_error]: [f64; 2]) -> [Portion; 2] {
    const ROUNDINGS: f64 = 4.0 * f64::EPSILON;
    let lower = (num - num_error) / (den + den_error) * (1.0 - ROUNDINGS);
    let least = den - den_error;
    let upper = (num + num_error) / least * (1.0 + ROUNDINGS);
    let lower = if lower > f64::MIN_POSITIVE { of_normal(lower) } else { Portion::ZERO };
    // A NaN is beyond.
    let is_known = (least > 0.0) & (upper < 1.0);
    let upper = if upper < f64::MIN_POSITIVE { f64::MIN_POSITIVE } else { upper };
    [lower, if is_known { of_normal(upper) } else { Portion::ONE }]
}

/// A float above zero that is normal.
#[inline(always)]
fn of_normal(x: f64) -> Portion {
    const HIDDEN: u64 = 1 << (f64::MANTISSA_DIGITS - 1);
    let bits = x.to_bits();
    Portion::of_whole(bits & (HIDDEN - 1) | HIDDEN, (bits / HIDDEN) as i32 - 1075)
}

/// The quotient of two numbers above zero, the first not the greater, that a register holds.
#[inline(always)]
pub(super) fn divided_short(num: u64, den: u64) -> Portion {
    let places = num.leading_zeros() - den.leading_zeros();
    let rest = num << places;
    let is_less = rest < den;
    let wide = u128::from(rest) << if is_less { 64 } else { 63 };
    // At least 2^63 and below 2^64; the divisor is above zero.
    let mantissa = wide.checked_div(den.into()).unwrap_or(0) as u64;
    Portion { exponent: i32::from(!is_less) - places as i32, mantissa }
}

/// The same of longer ones.
#[inline(never)]
pub(super) fn divided(num: u128, den: u128) -> Portion {
    if let (Ok(num), Ok(den)) = (u64::try_from(num), u64::try_from(den)) {
        return divided_short(num, den);
    }
    by_places(num, &den)
}

/// The quotient of two numbers above zero, the first not the greater. Both can be doubled.
#[inline(always)]
fn by_places<W: Wide>(mut num: W, den: &W) -> Portion {
    let places = den.width().saturating_sub(num.width());
    num.shift_up(places);
    // Where the first place is zero there are 65, of which the word drops the first.
    let is_less = num < *den;
    let (mantissa, _) = divided_by_places(num, den, 64 + u32::from(is_less));
    Portion { exponent: i32::from(!is_less) - places as i32, mantissa }
}

/// The same of numbers in limbs.
#[cold]
#[inline(never)]
pub(crate) fn divided_limbs<const L: usize>(num: Limbs<L>, den: &Limbs<L>) -> Portion {
    by_places(num, den)
}

#[cfg(test)]
mod tests {
    use super::{Limbs, Portion, divided_limbs};
    use crate::arithmetic::{Number, wide::I256};

    const ZERO: [i64; 2] = [0; 2];

    /// All widths divide alike, and as long division on paper does.
    #[test]
    fn all_widths_agree() {
        let numbers = [1_i64, 2, 3, 5, 7, 11, 1 << 20, (1 << 20) + 1, 0x1234_5678_9abc, 1 << 55];
        for den in numbers {
            for num in numbers.into_iter().filter(|&num| num <= den) {
                let [short, upper] = num.portion(den, ZERO);
                assert_eq!(short, upper);
                let (whole, unit) = short.whole(64, -2000);
                // whole·2^unit ≤ num/den < (whole + 1)·2^unit, all below 2^120.
                let scaled = u128::from(num.unsigned_abs()) << -unit;
                let (whole, divisor) = (u128::from(whole), u128::from(den.unsigned_abs()));
                assert!(whole >> 63 == 1 && whole * divisor <= scaled, "{num}/{den}");
                assert!(scaled < (whole + 1) * divisor, "{num}/{den}");

                for shift in [0, 60] {
                    let (n, d) = (i128::from(num) << shift, i128::from(den) << shift);
                    assert_eq!(n.portion(d, [0; 2])[0], short, "{num}/{den}");
                }
                let (n, d) = (I256::product(1 << 90, num), I256::product(1 << 90, den));
                assert_eq!(n.portion(d, [d; 2])[0], short, "{num}/{den}");
                for (i, k) in [(0, 0), (1, 1), (2, 2)] {
                    let (mut n, mut d) = ([0; 4], [0; 4]);
                    (n[i], d[k]) = (num as u64, den as u64);
                    assert_eq!(divided_limbs(Limbs(n), &Limbs(d)), short, "{num}/{den}");
                }
                let (mut n, mut d) = ([0; 4], [0; 4]);
                (n[0], d[2]) = (num as u64, den as u64);
                let far = divided_limbs(Limbs(n), &Limbs(d));
                assert_eq!((far.mantissa, far.exponent), (short.mantissa, short.exponent - 128));
            }
        }
    }

    #[test]
    fn floats_enclose_the_quotient() {
        for (num, den) in [(1.0, 3.0), (1e-200, 7.0), (0.9999999, 1.0), (5.0, 5.0)] {
            let [low, high] = f64::portion(num, den, [0.0; 2]);
            assert!(low < high, "{num}/{den}");
            let [lower, higher] = f64::portion(num, den, [num * 1e-10, den * 1e-10]);
            assert!(lower < low && high <= higher);
        }
        assert_eq!(
            f64::portion(1.0, 0.5, [0.0, 1.0]),
            [f64::portion(1.0, 1.5, [0.0; 2])[0], Portion::ONE]
        );
        assert_eq!(f64::portion(-1.0, 0.5, [0.0; 2])[0], Portion::ZERO);
    }
}
