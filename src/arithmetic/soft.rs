//! Software floats above or equal to zero: a mantissa of 64 bits, an exponent, and a bound on the
//! missing part. They use only integers, so that neither range nor machine matters.
//!
//! They serve to round quotients of exact sums, to round times of contact down
//! ([`portion`](super::portion)), and to compute the lengths, quotients and roots of a least
//! translation.

use super::limbs::{divided_by_places, divided_by_reciprocal, full_product};
use super::parts::scaled;
use super::platform::{REGISTERS_ARE_WIDE, Slack};

/// A number x with mantissa·2^exponent ≤ x ≤ (mantissa + slack)·2^exponent.
///
/// The top bit of the mantissa is set, except in [`ZERO`](Self::ZERO). The number is exact if the
/// slack is zero. An operation on two numbers has a slack of at most four times their sum and four,
/// so after a few operations on exact numbers a number is still known to 2^-55 of itself.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Soft {
    pub(super) exponent: i32,
    pub(super) mantissa: u64,
    pub(super) slack: Slack,
}

impl Soft {
    /// Zero, with an exponent below the exponents of all numbers of any scalar.
    pub(crate) const ZERO: Self = Self { exponent: i32::MIN / 2, mantissa: 0, slack: 0 };
    /// One.
    pub(crate) const ONE: Self = Self { exponent: -63, mantissa: 1 << 63, slack: 0 };

    /// A number rounded down, with less than one unit missing.
    #[inline(always)]
    pub(super) fn rounded_down(mantissa: u64, exponent: i32) -> Self {
        Self { exponent, mantissa, slack: 1 }
    }

    /// From a float that is normal and above zero.
    #[inline(always)]
    pub(crate) fn of_normal(x: f64) -> Self {
        const DIGITS: u32 = f64::MANTISSA_DIGITS;
        let bits = x.to_bits();
        // The sign and the exponent are shifted out, and the leading bit becomes the highest.
        let mantissa = (bits | 1 << (DIGITS - 1)) << (64 - DIGITS);
        Self { exponent: (bits >> (DIGITS - 1)) as i32 - 1086, mantissa, slack: 0 }
    }

    /// A number between two floats, which are normal and above zero; `None` if they are more than
    /// 2^-30 apart, or 2^-40 with a short slack. The slack leaves room for a few operations.
    pub(super) fn between(low: f64, high: f64) -> Option<Self> {
        let (low, high) = (Self::of_normal(low), Self::of_normal(high));
        let up = u32::try_from(high.exponent - low.exponent).ok().filter(|&up| up < 2)?;
        let slack = (u128::from(high.mantissa) << up).checked_sub(low.mantissa.into())?;
        // Four operations multiply a slack by less than 2^8.
        (slack < 1 << (Slack::BITS - 9).min(33)).then_some(Self { slack: slack as Slack, ..low })
    }

    /// Whether nothing is missing.
    pub(crate) fn is_exact(self) -> bool {
        self.slack == 0
    }

    /// The upper bound, to 64 digits, as a number.
    pub(crate) fn above(self) -> Self {
        let (most, exponent) = self.upper();
        match u64::try_from(most) {
            Ok(mantissa) => Self { exponent, mantissa, slack: 0 },
            Err(_) => Self { exponent: exponent + 1, mantissa: most.div_ceil(2) as u64, slack: 0 },
        }
    }

    /// A number below this one by one place of the mantissa, which is not zero.
    pub(crate) fn below(self) -> Self {
        Self { mantissa: self.mantissa.saturating_sub(1), ..self }
    }

    /// The unsigned integer with these limbs, least first; `None` for zero.
    pub(crate) fn of_limbs(limbs: &[u64]) -> Option<Self> {
        let top = limbs.iter().rposition(|&limb| limb != 0)?;
        let limb = |k: usize| u128::from(limbs.get(k).copied().unwrap_or(0));
        let below = if top == 0 { 0 } else { limb(top - 1) };
        let lost = limbs.iter().take(top.saturating_sub(1)).any(|&limb| limb != 0);
        Some(Self::of(limb(top) << 64 | below, lost.into(), 64 * (top as i32 - 1)))
    }

    /// A number between value·2^exponent and (value + slack)·2^exponent, with a value above zero.
    pub(super) fn of(value: u128, slack: u128, exponent: i32) -> Self {
        let zeros = value.leading_zeros();
        if zeros > 64 {
            let up = zeros - 64;
            let (mantissa, slack) = ((value << up) as u64, (slack << up) as Slack);
            return Self { exponent: exponent - up as i32, mantissa, slack };
        }
        let down = 64 - zeros;
        let mask = (1_u128 << down) - 1;
        let slack = ((value & mask) + slack + mask) >> down;
        let mantissa = (value >> down) as u64;
        Self { exponent: exponent + down as i32, mantissa, slack: slack as Slack }
    }

    /// The number times 2^n.
    pub(crate) fn scaled(self, n: i32) -> Self {
        Self { exponent: self.exponent + n, ..self }
    }

    /// An upper bound of the number: m·2^exponent, with m at most 2^65.
    pub(crate) fn upper(self) -> (u128, i32) {
        (u128::from(self.mantissa) + u128::from(self.slack), self.exponent)
    }

    /// Whether the number is certainly less.
    pub(crate) fn is_less_than(self, other: Self) -> bool {
        let by = other.exponent.saturating_sub(self.exponent);
        by > 1 || by >= 0 && self.upper().0 < u128::from(other.mantissa) << by
    }

    /// The number as a float, to a few roundings.
    pub(crate) fn in_double(self) -> f64 {
        scaled(self.mantissa, self.exponent)
    }

    fn parts(self) -> (u128, u128) {
        (self.mantissa.into(), self.slack.into())
    }

    // Out of line: called from many places, with sixteen products where words have 32 bits.
    #[inline(never)]
    pub(crate) fn times(self, other: Self) -> Self {
        let ((a, s), (b, t)) = (self.parts(), other.parts());
        let slack = if self.is_exact() && other.is_exact() { 0 } else { a * t + b * s + s * t };
        Self::of(a * b, slack, self.exponent + other.exponent)
    }

    pub(crate) fn plus(self, other: Self) -> Self {
        let (a, b) = if self.exponent < other.exponent { (other, self) } else { (self, other) };
        let down = (a.exponent - b.exponent) as u32;
        let ((low, slack), (less, loss)) = (a.parts(), b.parts());
        let shifted = |x: u128| (x << 63).checked_shr(down).unwrap_or(0);
        // One for the bits cut off the lesser number, and one for those cut off its slack.
        let is_whole = down < 128 && less.trailing_zeros() + 63 >= down && loss == 0;
        let loss = shifted(loss) + if is_whole { 0 } else { 2 };
        Self::of((low << 63) + shifted(less), (slack << 63) + loss, a.exponent - 63)
    }

    pub(crate) fn over(self, other: Self) -> Self {
        if !REGISTERS_ARE_WIDE {
            return self.over_by_reciprocal(other);
        }
        let ((a, s), (b, t)) = (self.parts(), other.parts());
        // Its top bit is set, so the compiler sees that it is not zero and links no panic.
        let b = b | 1 << 63;
        let least = (a << 63) / (b + t);
        // Rounded up, without a remainder; the dividend is not zero.
        let most = (((a + s) << 63) - 1) / b + 1;
        Self::of(least, most - least, self.exponent - other.exponent - 63)
    }

    /// The quotient where long division takes a function: one quotient for both bounds.
    ///
    /// With a·2^63 = q·b + r, the lower bound is q less what q·t exceeds r by, in multiples of b + t,
    /// and the upper bound is q and what r + s·2^63 adds, in multiples of b. Both are a few units.
    #[inline(never)]
    fn over_by_reciprocal(self, other: Self) -> Self {
        let ((_, s), (b, t)) = (self.parts(), other.parts());
        let (quotient, rest) = divided_by_reciprocal(self.mantissa, other.mantissa);
        let (b, rest) = (b | 1 << 63, u128::from(rest));
        let (lack, more) = ((u128::from(quotient) * t).saturating_sub(rest), rest + (s << 63));
        let least = quotient.wrapping_sub(small_quotient(lack, b + t, other.slack));
        let most = quotient.wrapping_add(small_quotient(more, b, self.slack));
        let slack = most.wrapping_sub(least);
        Self::of(least.into(), slack.into(), self.exponent - other.exponent - 63)
    }

    pub(crate) fn root(self) -> Self {
        let (a, s) = self.parts();
        let up = 64 - (self.exponent & 1) as u32;
        let square = a << up;
        let (root, is_exact) = if REGISTERS_ARE_WIDE {
            let root = square.isqrt();
            (root, root * root == square)
        } else {
            let (root, is_exact) = root_by_places(square);
            (root.into(), is_exact)
        };
        // The root is at least 2^63, so the term s·2^up in the square adds less than s to it.
        Self::of(root, s + u128::from(!is_exact), (self.exponent - up as i32) / 2)
    }

    /// The quotient of the two mantissas, rounded down, as m·2^e with m in [2^62, 2^64) or zero. If
    /// the slacks are at most one, it is less than 2^-61 of itself from the quotient of the
    /// numbers. The divisor is not zero.
    pub(crate) fn quotient(self, den: Self) -> (u64, i32) {
        let quotient = if REGISTERS_ARE_WIDE {
            // Its top bit is set, so the compiler sees that it is not zero and links no panic.
            ((u128::from(self.mantissa) << 63) / u128::from(den.mantissa | 1 << 63)) as u64
        } else {
            divided_by_reciprocal(self.mantissa, den.mantissa).0
        };
        (quotient, self.exponent - den.exponent - 63)
    }

    /// The mantissa in integer multiples of a unit 2^e, rounded down, and e. The unit is the
    /// greatest for which `digits` bits hold the mantissa, or 2^`least` if that is greater. The
    /// second applies to fixed-point numbers, and to floats below the least normal number; the
    /// first to all other floats.
    #[inline(always)]
    pub(crate) fn floor(self, digits: u32, least: i32) -> (u64, i32) {
        let unit = self.exponent + 64 - digits as i32;
        let unit = if unit > least { unit } else { least };
        (self.mantissa.checked_shr((unit - self.exponent) as u32).unwrap_or(0), unit)
    }
}

/// The root of a whole number of at least 2^126, rounded down, and whether it is exact, without the
/// divisions of `isqrt`: the upper half place by place, the lower half as the quotient of the remainder and
/// twice the upper half. That leaves out the square of the lower half, and is at most one too great.
#[inline(never)]
fn root_by_places(square: u128) -> (u64, bool) {
    let (mut upper, mut root, mut rest) = ((square >> 64) as u64, 0_u64, 0_u64);
    for _ in 0..32 {
        rest = rest << 2 | upper >> 62;
        upper <<= 2;
        let next = root << 2 | 1;
        root <<= 1;
        if rest >= next {
            rest -= next;
            root |= 1;
        }
    }
    let (twice, mut lower) = (2 * root, (square >> 32) as u32);
    // The remainder is at most twice the root. If it is that, the lower half has ones only.
    rest = rest.min(twice - 1);
    for _ in 0..32 {
        // Digits leave at the top, and those of the quotient enter at the bottom.
        rest = rest << 1 | u64::from(lower >> 31);
        lower <<= 1;
        if rest >= twice {
            rest -= twice;
            lower |= 1;
        }
    }
    let root = root << 32 | u64::from(lower);
    let product = full_product(root, root);
    // An exact root is not too great: the square that is left out is below twice the upper half's places.
    (root - u64::from(product > square), product == square)
}

/// num/den, rounded up. The quotient is at most twice the slack and one.
fn small_quotient(num: u128, den: u128, slack: Slack) -> u64 {
    if num <= den {
        return (num != 0).into();
    }
    let places = Slack::BITS + 1 - slack.leading_zeros();
    let (quotient, rest) = divided_by_places(num, &(den << places), places + 1);
    quotient + u64::from(rest != 0)
}

/// Unit roundoffs in [`root`].
#[cfg(test)]
const ROOT_ROUNDOFFS: u16 = 2;

/// The square root of a normal float above zero, within two unit roundoffs. `core` has none.
///
/// The integer root is below the true one by less than 2^-31 of it, and a step of Newton's method
/// leaves half the square of that, and the roundings of a quotient and a sum: `soft.g`.
pub(crate) fn root(x: f64) -> f64 {
    let Soft { exponent, mantissa, .. } = Soft::of_normal(x);
    let odd = exponent & 1;
    let first = scaled((mantissa >> odd).isqrt(), (exponent + odd) / 2);
    0.5 * (first + x / first)
}

/// m·2^exponent as an integer, rounded up or to the nearest, and at most the greatest `u128`.
pub(crate) fn whole(m: u128, exponent: i32, is_up: bool) -> u128 {
    if exponent >= 0 {
        let fits = m.leading_zeros() >= exponent.unsigned_abs();
        return if m == 0 {
            0
        } else if fits {
            m << exponent
        } else {
            u128::MAX
        };
    }
    let down = exponent.unsigned_abs();
    if down > 127 {
        return u128::from(is_up && m != 0);
    }
    let add = if is_up { (1 << down) - 1 } else { 1 << (down - 1) };
    // No overflow: all callers pass an m far below the greatest number.
    m.saturating_add(add) >> down
}

#[cfg(test)]
mod tests;
