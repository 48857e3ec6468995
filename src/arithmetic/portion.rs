//! Quotients between zero and one, rounded down to 64 digits.
//!
//! Each number of a scalar from zero to one has at most 64 digits. A quotient that is rounded down
//! again, to the scalar, therefore equals one that was rounded once. Rounding also keeps order: the
//! greatest rounded quotient is the greatest quotient, rounded.

use super::limbs::{Limbs, Wide, divided_by_places};
use super::soft::Soft;

/// The quotient of two numbers above zero in a register. The first is not the greater.
#[inline(always)]
pub(super) fn divided_short(num: u64, den: u64) -> Soft {
    let places = num.leading_zeros() - den.leading_zeros();
    let rest = num << places;
    let is_less = rest < den;
    let wide = u128::from(rest) << if is_less { 64 } else { 63 };
    // At least 2^63 and below 2^64; the divisor is above zero.
    let mantissa = wide.checked_div(den.into()).unwrap_or(0) as u64;
    Soft::rounded_down(mantissa, -63 - i32::from(is_less) - places as i32)
}

/// The quotient for longer numbers.
#[inline(never)]
pub(super) fn divided(num: u128, den: u128) -> Soft {
    if let (Ok(num), Ok(den)) = (u64::try_from(num), u64::try_from(den)) {
        return divided_short(num, den);
    }
    by_places(num, &den)
}

/// The quotient of two numbers above zero that can be doubled. The first is not the greater.
#[inline(always)]
fn by_places<W: Wide>(mut num: W, den: &W) -> Soft {
    let places = den.width().saturating_sub(num.width());
    num.shift_up(places);
    // If the first place is zero, there are 65 places, and the word drops that one.
    let is_less = num < *den;
    let (mantissa, _) = divided_by_places(num, den, 64 + u32::from(is_less));
    Soft::rounded_down(mantissa, -63 - i32::from(is_less) - places as i32)
}

/// The quotient of numbers in limbs.
#[cold]
#[inline(never)]
pub(super) fn divided_limbs<const L: usize>(num: Limbs<L>, den: &Limbs<L>) -> Soft {
    by_places(num, den)
}

#[cfg(test)]
mod tests {
    use super::{Limbs, Soft, divided_limbs};
    use crate::arithmetic::Number;
    use crate::arithmetic::wide::I256;

    const ZERO: [i64; 2] = [0; 2];

    /// All widths divide alike, and like long division on paper.
    #[test]
    fn all_widths_agree() {
        let numbers = [1_i64, 2, 3, 5, 7, 11, 1 << 20, (1 << 20) + 1, 0x1234_5678_9abc, 1 << 55];
        for den in numbers {
            for num in numbers.into_iter().filter(|&num| num <= den) {
                let [short, upper] = num.portion(den, ZERO);
                assert_eq!(short, upper);
                let (whole, unit) = short.floor(64, -2000);
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
                assert_eq!(far, short.scaled(-128));
            }
        }
    }

    #[test]
    fn floats_enclose_the_quotient() {
        for (num, den) in [(1.0, 3.0), (1e-200, 7.0), (0.9999999, 1.0), (5.0, 5.0)] {
            let [low, high] = f64::portion(num, den, [0.0; 2]);
            assert!(low.is_less_than(high), "{num}/{den}");
            let [lower, higher] = f64::portion(num, den, [num * 1e-10, den * 1e-10]);
            assert!(lower.is_less_than(low) && !higher.is_less_than(high));
        }
        assert_eq!(
            f64::portion(1.0, 0.5, [0.0, 1.0]),
            [f64::portion(1.0, 1.5, [0.0; 2])[0], Soft::ONE]
        );
        assert_eq!(f64::portion(-1.0, 0.5, [0.0; 2])[0], Soft::ZERO);
    }
}
