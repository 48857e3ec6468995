//! Software floats above or equal to zero: a mantissa of 64 bits, an exponent, and a bound on the
//! missing part. They use only integers, so that neither range nor machine matters.
//!
//! They serve to round quotients of exact sums, to round times of contact down
//! ([`portion`](super::portion)), and to compute the lengths, quotients and roots of a least
//! translation.

use super::limbs::{
    divided, divided_by_places, divided_by_reciprocal, inverse, limb_by_word, limb_product, normal,
    word_product,
};
use super::parts::scaled;
use super::platform::{REGISTERS_ARE_WIDE, Slack, out_of_line};

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

/// A divisor of several numbers: where long division takes a function, with the inverse of its upper word.
#[derive(Clone, Copy)]
pub(crate) struct Divisor {
    of: Soft,
    inverse: u32,
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
    pub(crate) fn of(value: u128, slack: u128, exponent: i32) -> Self {
        let (value, up) = normal(value);
        Self::cut(value, slack.wrapping_shl(up), exponent - up as i32)
    }

    /// The same for a value of at least 2^126.
    #[inline(always)]
    fn of_leading(value: u128, slack: u128, exponent: i32) -> Self {
        let up = u32::from(value >> 127 == 0);
        Self::cut(value << up, slack << up, exponent - up as i32)
    }

    /// The same for a value of at least 2^127: its upper half, and what is missing, rounded up.
    #[inline(always)]
    fn cut(value: u128, slack: u128, exponent: i32) -> Self {
        let (rest, carry) = (value as u64).overflowing_add(slack as u64);
        let slack = (slack >> 64) as Slack + Slack::from(carry) + Slack::from(rest != 0);
        Self { exponent: exponent + 64, mantissa: (value >> 64) as u64, slack }
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
        let (s, t) = (self.slack, other.slack);
        let slack = slack_product(self.mantissa, t)
            + slack_product(other.mantissa, s)
            + slack_product(u128::from(s) as u64, t);
        let value = limb_product(self.mantissa, other.mantissa);
        Self::of_leading(value, slack, self.exponent + other.exponent)
    }

    pub(crate) fn plus(self, other: Self) -> Self {
        let (a, b) = if self.exponent < other.exponent { (other, self) } else { (self, other) };
        let down = (a.exponent - b.exponent) as u32;
        // x·2^63 over 2^down.
        let shifted = |x: u64| {
            if down < 64 {
                u128::from(x >> 1 >> down) << 64 | u128::from(x << (63 - down))
            } else {
                x.checked_shr(down - 63).unwrap_or(0).into()
            }
        };
        // One for the bits cut off the lesser number, and one for those cut off its slack.
        let is_whole = down < 128 && b.mantissa.trailing_zeros() + 63 >= down && b.slack == 0;
        let loss = shifted(u128::from(b.slack) as u64) + if is_whole { 0 } else { 2 };
        let value = (u128::from(a.mantissa) << 63) + shifted(b.mantissa);
        Self::of_leading(value, (u128::from(a.slack) << 63) + loss, a.exponent - 63)
    }

    /// The quotient by an exact power of two.
    #[inline(always)]
    pub(crate) fn over_power(self, power: Self) -> Self {
        self.scaled(-63 - power.exponent)
    }

    pub(crate) fn over(self, other: Self) -> Self {
        self.over_by(&other.divisor())
    }

    /// The number as a divisor of several numbers.
    pub(crate) fn divisor(self) -> Divisor {
        Divisor { of: self, inverse: if REGISTERS_ARE_WIDE { 0 } else { inverse(self.mantissa) } }
    }

    pub(crate) fn over_by(self, other: &Divisor) -> Self {
        if !REGISTERS_ARE_WIDE {
            return self.over_by_inverse(other);
        }
        let other = other.of;
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
    fn over_by_inverse(self, &Divisor { of: other, inverse }: &Divisor) -> Self {
        let ((_, s), (b, t)) = (self.parts(), other.parts());
        let (quotient, rest) = divided(self.mantissa, other.mantissa, inverse);
        let (b, rest) = (b | 1 << 63, u128::from(rest));
        let lack = slack_product(quotient, other.slack).saturating_sub(rest);
        let less = small_quotient(lack, b + t, other.slack);
        let more = small_quotient(rest + (s << 63), b, self.slack);
        let (mut mantissa, mut slack) = (quotient.wrapping_sub(less), less.wrapping_add(more));
        let mut exponent = self.exponent - other.exponent - 63;
        // The quotient of two mantissas is above 2^62, less the slack.
        for _ in 0..2 {
            if mantissa >> 63 == 0 {
                (mantissa, slack, exponent) = (mantissa << 1, slack << 1, exponent - 1);
            }
        }
        Self { exponent, mantissa, slack: slack as Slack }
    }

    pub(crate) fn root(self) -> Self {
        let up = 64 - (self.exponent & 1) as u32;
        let square = u128::from(self.mantissa) << up;
        let (root, is_exact) = if REGISTERS_ARE_WIDE {
            let root = square.isqrt();
            (root as u64, root * root == square)
        } else {
            root_by_reciprocal(square)
        };
        // The root is at least 2^63, so the term s·2^up in the square adds less than s to it.
        let slack = self.slack + Slack::from(!is_exact);
        Self { exponent: (self.exponent - up as i32) / 2, mantissa: root, slack }
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
/// divisions of `isqrt`: the upper half from its reciprocal, the lower half as the quotient of the remainder
/// and twice the upper half. That leaves out the square of the lower half, and is at most one too great.
///
/// With d = h/2^32 and y·2^-31 an estimate of 1/√d, a step of Newton's method gives y·(3 − d·y²)/2, which
/// is never above 1/√d, and of a relative error e makes 3/2·e² and e³/2: 2^-5 at first, 2^-34 after three
/// steps. The product d·y² is too low by less than two. The root of d is up to 2^-31 of itself below that
/// of the number, so y less two is not above its reciprocal.
#[inline(never)]
fn root_by_reciprocal(square: u128) -> (u64, bool) {
    let (high, low) = ((square >> 64) as u64, square as u64);
    let upper = |a: u32, b: u32| (word_product(a, b) >> 32) as u32;
    let h = (high >> 32) as u32;
    // In units of 2^-31, modulo 2^32: 1.788 − 0.8125·d, or 2.526 − 2.28·d below 1/2.
    let mut y = if h >> 31 == 1 {
        0xe4d4_0000_u32.wrapping_sub((h >> 1) - (h >> 4) - (h >> 5))
    } else {
        0x4354_0000_u32.wrapping_sub(h + (h >> 3) + (h >> 6))
    };
    for _ in 0..3 {
        y = upper(y, (3 << 30) - 2 - upper(h, upper(y, y))) << 1;
    }
    y -= 2;
    // From below.
    let mut root = (word_product(h, y) >> 31) as u32;
    let twice = |root: u32| u64::from(root) << 1;
    let mut rest = high - word_product(root, root);
    while rest > twice(root) {
        rest -= twice(root) | 1;
        root += 1;
    }
    // The remainder is at most twice the root. If it is that, the lower half has ones only.
    let mut lower = (word_product((rest >> 1) as u32, y) >> 31) as u32;
    // Modulo 2^64.
    let mut rest = (rest << 32 | low >> 32).wrapping_sub(word_product(root, lower) << 1);
    while rest >= twice(root) && lower != u32::MAX {
        rest -= twice(root);
        lower += 1;
    }
    let (square, rest) =
        (word_product(lower, lower), u128::from(rest) << 32 | u128::from(low as u32));
    // An exact root is not too great: the square that is left out is below twice the upper half's places.
    let root = u64::from(root) << 32 | u64::from(lower);
    (root - u64::from(u128::from(square) > rest), u128::from(square) == rest)
}

/// A mantissa times a slack, which is mostly zero.
fn slack_product(mantissa: u64, slack: Slack) -> u128 {
    if REGISTERS_ARE_WIDE {
        u128::from(mantissa) * u128::from(slack)
    } else if slack == 0 {
        0
    } else {
        limb_by_word(mantissa, u128::from(slack) as u32)
    }
}

/// num/den, rounded up. The quotient is at most twice the slack and one.
fn small_quotient(num: u128, den: u128, slack: Slack) -> u64 {
    if num <= den {
        return (num != 0).into();
    }
    out_of_line(move || {
        let places = Slack::BITS + 1 - slack.leading_zeros();
        let (quotient, rest) = divided_by_places(num, &(den << places), places + 1);
        quotient + u64::from(rest != 0)
    })
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
