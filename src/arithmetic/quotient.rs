//! Quotients of integers, rounded once.
//!
//! Each number here is a volume or a length of some system in `integer`, and is far enough from the
//! end of its type that a remainder can be doubled.
//! Quotients in `f64` become integers if it is certain to which integer they round.

use core::cmp::Ordering;
use core::num::NonZero;
use core::ops::{Add, Mul, Sub};

use super::big_int::BigInt;
use super::limbs::{Limbs, Wide, divided_by_places};
use super::number::{Number, greatest};
use super::parts::exp2;
use super::platform::REGISTERS_ARE_WIDE;
use super::quad::{OfFour, Quad};
use super::wide::I256;
use crate::arithmetic::Each;

/// An integer that can be divided by another, with a power of two.
pub trait Dividend: Number {
    /// self·2^shift / den to the nearest, ties to even, and at the ends of `i64` if it is beyond;
    /// `den` is not zero.
    fn quotient(self, den: Self, shift: u32) -> i64;

    /// How self·2^shift / den compares with `t`; `den` is above zero.
    fn compare(self, den: Self, shift: u32, t: i64) -> Ordering;
}

/// Applies the sign that the quotient of two numbers has.
#[inline(always)]
fn signed(magnitude: u64, negative: bool) -> i64 {
    if negative {
        0_i64.checked_sub_unsigned(magnitude).unwrap_or(i64::MIN)
    } else {
        i64::try_from(magnitude).unwrap_or(i64::MAX)
    }
}

/// Long division, with as many binary places at a time as the remainder has room for.
macro_rules! long_division {
    ($name:ident: $unsigned:ty) => {
        fn $name(num: $unsigned, den: $unsigned, shift: u32) -> u64 {
            const END: u64 = 1 << 63;
            // The compiler then sees that there is no division by zero.
            let Some(divisor) = NonZero::<$unsigned>::new(den) else { return END };
            if num >> (<$unsigned>::BITS - 1 - shift.min(<$unsigned>::BITS - 1)) == 0 {
                // The whole quotient fits. A shift by all bits occurs only for zero.
                let num = num.wrapping_shl(shift);
                let (q, r) = (num / divisor, num % divisor);
                return u64::try_from(q).map_or(END, |q| nearest(q, r.cmp(&(den - r))));
            }
            let (q, mut r) = (num / divisor, num % divisor);
            if q >> 63 != 0 {
                return END;
            }
            let (mut q, mut left) = (q as u64, shift);
            while left > 0 {
                let places = left.min(den.leading_zeros()).clamp(1, 62);
                if q >> (63 - places) != 0 {
                    return END;
                }
                r <<= places;
                q = (q << places) | (r / divisor) as u64;
                r %= divisor;
                left -= places;
            }
            nearest(q, r.cmp(&(den - r)))
        }
    };
}
long_division! { divide: u64 }
long_division! { divide_wide: u128 }

/// The quotient, given how its remainder compares with half the divisor.
#[inline(always)]
fn nearest(q: u64, remainder: Ordering) -> u64 {
    let up = match remainder {
        Ordering::Less => false,
        Ordering::Equal => q % 2 == 1,
        Ordering::Greater => true,
    };
    q.saturating_add(up.into())
}

/// num·2^shift / den of magnitudes, place by place, for numbers too wide for hardware. The divisor
/// is not zero, and both can be doubled.
#[cold]
#[inline(never)]
fn divide_widest<const L: usize>(mut num: Limbs<L>, mut den: Limbs<L>, shift: u32) -> u64 {
    let (above, below) = (num.width(), den.width());
    // The quotient is below 2^places, and above a quarter of that.
    let Some(places) = (shift + 1 + above).checked_sub(below) else { return 0 };
    if places > 64 {
        return 1 << 63;
    }
    num.shift_up(below.saturating_sub(above));
    den.shift_up(above.saturating_sub(below));
    let (q, rest) = divided_by_places(num, &den, places);
    nearest(q, rest.cmp(&den))
}

/// num·2^`shift` / `den` to the nearest, ties to even, and at the ends of `i64` if it is beyond; the
/// divisor is not zero and leaves one bit free.
pub(crate) fn quotient_of_sums<const L: usize>(
    num: &BigInt<L>,
    den: &BigInt<L>,
    shift: u32,
) -> i64 {
    if let (Some(num), Some(den)) = (in_256_bits(num), in_256_bits(den)) {
        return num.quotient(den, shift);
    }
    let ((is_negative, num), (is_other_negative, den)) =
        (num.sign_magnitude(), den.sign_magnitude());
    signed(divide_widest(Limbs(num), Limbs(den), shift), is_negative != is_other_negative)
}

/// The number in 256 bits, if a few of these are left over. Only products of four numbers of 64
/// bits may take more.
fn in_256_bits<const L: usize>(x: &BigInt<L>) -> Option<I256> {
    let narrow = x.resized::<4>();
    let has_room = L < 5 || {
        let fill = if x.is_negative() { u64::MAX } else { 0 };
        x.0.iter().skip(4).all(|&limb| limb == fill) && (narrow.0[3] ^ fill) >> 58 == 0
    };
    has_room.then_some(I256::from_limbs(narrow.0))
}

/// Adding this rounds to an integer in the last bits of the sum: 1.5·2^52.
pub(super) const WHOLE: f64 = 6_755_399_441_055_744.0;

/// Approximately num·2^shift / den, if that is below 2^40: within slightly more than a half of the
/// true quotient.
#[inline(always)]
fn guess(num: i64, den: i64, shift: u32) -> Option<i64> {
    let unit = exp2(shift as i32);
    let guess = num as f64 / den as f64 * unit;
    let whole = (guess + WHOLE).to_bits().wrapping_sub(WHOLE.to_bits()) as i64;
    (guess.abs() < 1_099_511_627_776.0).then_some(whole)
}

/// The quotient from a guess that the remainder corrects. The remainder is exact although the
/// product may wrap around. This is for machines with fast floats; the answer is the same on all.
macro_rules! by_guess {
    ($num:ident, $den:ident, $shift:ident, $leading:expr) => {
        if REGISTERS_ARE_WIDE {
            let (num, den) = $leading;
            if let Some(q) = guess(num, den, $shift) {
                let r =
                    $num.checked_shl($shift).unwrap_or(0).wrapping_sub($den.wrapping_mul(q.into()));
                let (r, d) = if $den < 0 { (-r, -$den) } else { (r, $den) };
                // From an odd number, a tie leads away too.
                let d = d - Self::from(q as i8 & 1);
                return q + i64::from(2 * r > d) - i64::from(-2 * r > d);
            }
        }
    };
}

impl Dividend for i32 {
    #[inline(always)]
    fn quotient(self, den: Self, shift: u32) -> i64 {
        i64::from(self).quotient(den.into(), shift)
    }
    #[inline(always)]
    fn compare(self, den: Self, shift: u32, t: i64) -> Ordering {
        i64::from(self).compare(den.into(), shift, t)
    }
}

impl Dividend for i64 {
    #[inline(always)]
    fn quotient(self, den: Self, shift: u32) -> i64 {
        by_guess!(self, den, shift, (self, den));
        let magnitude = divide(self.unsigned_abs(), den.unsigned_abs(), shift);
        signed(magnitude, (self < 0) != (den < 0))
    }
    #[inline(always)]
    fn compare(self, den: Self, shift: u32, t: i64) -> Ordering {
        (i128::from(self) << shift).cmp(&(i128::from(den) * i128::from(t)))
    }
}

impl Dividend for i128 {
    #[inline(always)]
    fn quotient(self, den: Self, shift: u32) -> i64 {
        let (num, d) = (self.unsigned_abs(), den.unsigned_abs());
        let excess = 66_u32.saturating_sub((num | d).leading_zeros());
        // A guess must keep enough bits.
        if excess == 0 || (num >> excess >> 42 != 0 && d >> excess >> 42 != 0) {
            by_guess!(self, den, shift, ((self >> excess) as i64, (den >> excess) as i64));
        }
        let magnitude = match (u64::try_from(num), u64::try_from(d)) {
            // A divisor above 2^62 leaves no room for the remainder.
            (Ok(num), Ok(d)) if d >> 62 == 0 => divide(num, d, shift),
            _ => divide_wide(num, d, shift),
        };
        signed(magnitude, (self < 0) != (den < 0))
    }
    fn compare(self, den: Self, shift: u32, t: i64) -> Ordering {
        I256::from(self).compare(I256::from(den), shift, t)
    }
}

impl Dividend for I256 {
    fn quotient(self, den: Self, shift: u32) -> i64 {
        if let (Some(num), Some(den)) = (self.narrowed(), den.narrowed()) {
            return num.quotient(den, shift);
        }
        let ((is_negative, num), (is_other_negative, den)) = (self.limbs(), den.limbs());
        let magnitude = divide_widest(Limbs(num), Limbs(den), shift);
        signed(magnitude, is_negative != is_other_negative)
    }
    fn compare(self, den: Self, shift: u32, t: i64) -> Ordering {
        self.shifted_up(shift).cmp(&den.times(t))
    }
}

impl<const L: usize> Dividend for BigInt<L> {
    fn quotient(self, den: Self, shift: u32) -> i64 {
        quotient_of_sums(&self, &den, shift)
    }
    fn compare(self, den: Self, shift: u32, t: i64) -> Ordering {
        self.shifted_up(shift as usize).cmp(&den.times(&BigInt::<2>::from(i128::from(t))))
    }
}

type Row = <f64 as OfFour>::Quad;

/// The three quotients times `unit`, each rounded to the nearest integer, in its last bits, and
/// whether all are certain. They are if they are below `most` and not so close to a half that they
/// may be wrong.
#[inline(always)]
pub(super) fn nearest_whole(
    num: [f64; 3],
    den: f64,
    errors: [f64; 2],
    unit: f64,
    most: f64,
) -> ([u64; 3], bool) {
    let factors = factors(den, errors, unit);
    let of = |k: usize| {
        let [sum, rest, size] = whole_near(num[k], factors, f64::abs);
        // Ordered so that a NaN is not certain.
        (sum.to_bits(), (rest < 0.5) & (size < most))
    };
    let [(t, t_is_good), (u, u_is_good), (v, v_is_good)] = [of(0), of(1), of(2)];
    ([t, u, v], t_is_good & u_is_good & v_is_good)
}

/// The same quotients, with the divisor first.
#[inline(always)]
pub(super) fn nearest_whole_of_row(
    row @ [den, ..]: [f64; 4],
    errors: [f64; 2],
    unit: f64,
    most: f64,
) -> ([u64; 3], bool) {
    let factors = factors(den, errors, unit).each(Row::splat);
    let [sum, rest, size] = whole_near(Row::new(row), factors, Row::magnitude);
    let are_good = Row::splat(0.5).exceeds(rest) & Row::splat(most).exceeds(size);
    let [_, t, u, v] = sum.to_array();
    ([t.to_bits(), u.to_bits(), v.to_bits()], are_good & 0b1110 == 0b1110)
}

/// The integer to which all numbers between these two round, in its last bits, if it exists and
/// they are below `most`.
#[inline(always)]
pub(super) fn nearest_of_all([low, high]: [f64; 2], most: f64) -> Option<u64> {
    let (bits, last) = ((low + WHOLE).to_bits(), (high + WHOLE).to_bits());
    ((bits == last) & (low > -most) & (high < most)).then_some(bits)
}

/// The factor of the numerators, the error of a quotient, relative and absolute, and the number
/// that rounds it.
#[inline(always)]
fn factors(den: f64, errors: [f64; 2], unit: f64) -> [f64; 4] {
    let inverse = unit / den;
    // Twice the errors of the numerators, twice that of the divisor, and all roundings from here
    // on.
    let relative = inverse.abs() * (2.0 * errors[1] / unit) + 4.0 * f64::EPSILON;
    [inverse, relative, inverse.abs() * (2.0 * greatest(errors[0], errors[1])), WHOLE]
}

/// The rounded quotient plus the last factor, its distance from the quotient, and its magnitude.
#[inline(always)]
fn whole_near<T>(
    num: T,
    [inverse, relative, absolute, whole]: [T; 4],
    magnitude: impl Fn(T) -> T,
) -> [T; 3]
where
    T: Copy + Add<Output = T> + Sub<Output = T> + Mul<Output = T>,
{
    let quotient = num * inverse;
    let sum = quotient + whole;
    let size = magnitude(quotient);
    [sum, magnitude(quotient - (sum - whole)) + (size * relative + absolute), size]
}

#[cfg(test)]
mod tests;
