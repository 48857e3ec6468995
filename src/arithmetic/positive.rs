//! Positive numbers to 64 bits, with what is not known of them: for quotients and roots of sums
//! that were exact. By whole numbers alone, so that neither range nor machine matters.

/// A number of which is known that low·2^exponent ≤ x ≤ (low + slack)·2^exponent.
///
/// The top bit of `low` is set. A slack of zero says that the number is known exactly. No
/// operation makes more of two slacks than four times their sum and four, so that after a few a
/// number is still known to 2^-55 of itself.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Positive {
    low: u64,
    slack: u32,
    exponent: i32,
}

impl Positive {
    /// The whole number of these limbs, least first, with no sign; `None` of zero.
    pub(crate) fn of_limbs(limbs: &[u64]) -> Option<Self> {
        let top = limbs.iter().rposition(|&limb| limb != 0)?;
        let limb = |k: usize| u128::from(limbs.get(k).copied().unwrap_or(0));
        let below = if top == 0 { 0 } else { limb(top - 1) };
        let lost = limbs.iter().take(top.saturating_sub(1)).any(|&limb| limb != 0);
        Some(Self::of(limb(top) << 64 | below, lost.into(), 64 * (top as i32 - 1)))
    }

    /// A number between value·2^exponent and (value + slack)·2^exponent, with a value above zero.
    fn of(value: u128, slack: u128, exponent: i32) -> Self {
        let zeros = value.leading_zeros();
        if zeros > 64 {
            let up = zeros - 64;
            let (low, slack) = ((value << up) as u64, (slack << up) as u32);
            return Self { low, slack, exponent: exponent - up as i32 };
        }
        let down = 64 - zeros;
        let mask = (1_u128 << down) - 1;
        let slack = ((value & mask) + slack + mask) >> down;
        let low = (value >> down) as u64;
        Self { low, slack: slack as u32, exponent: exponent + down as i32 }
    }

    /// The number times 2^n.
    pub(crate) fn scaled(self, n: i32) -> Self {
        Self { exponent: self.exponent + n, ..self }
    }

    /// What the number is not above: m·2^exponent, with m at most 2^65.
    pub(crate) fn upper(self) -> (u128, i32) {
        (u128::from(self.low) + u128::from(self.slack), self.exponent)
    }

    /// Whether the number is less for certain.
    pub(crate) fn is_less_than(self, other: Self) -> bool {
        let by = other.exponent.saturating_sub(self.exponent);
        by > 1 || by >= 0 && self.upper().0 < u128::from(other.low) << by
    }

    /// About the number, as a float.
    pub(crate) fn in_double(self) -> f64 {
        <f64 as super::Float>::scaled(self.low, self.exponent)
    }

    fn parts(self) -> (u128, u128) {
        (self.low.into(), self.slack.into())
    }

    // Called from many places, and sixteen products where words have 32 bits.
    #[inline(never)]
    pub(crate) fn times(self, other: Self) -> Self {
        let ((a, s), (b, t)) = (self.parts(), other.parts());
        Self::of(a * b, a * t + b * s + s * t, self.exponent + other.exponent)
    }

    pub(crate) fn plus(self, other: Self) -> Self {
        let (a, b) = if self.exponent < other.exponent { (other, self) } else { (self, other) };
        let down = (a.exponent - b.exponent) as u32;
        let ((low, slack), (less, loss)) = (a.parts(), b.parts());
        let shifted = (less << 63).checked_shr(down).unwrap_or(0);
        // One for what is cut off the lesser number, and one for what is cut off its slack.
        let is_whole = shifted.checked_shl(down) == Some(less << 63) && loss == 0;
        let loss = (loss << 63).checked_shr(down).unwrap_or(0) + if is_whole { 0 } else { 2 };
        Self::of((low << 63) + shifted, (slack << 63) + loss, a.exponent - 63)
    }

    pub(crate) fn over(self, other: Self) -> Self {
        let ((a, s), (b, t)) = (self.parts(), other.parts());
        // Its top bit is set: the compiler sees that it is not zero, and links no panic.
        let b = b | 1 << 63;
        let least = (a << 63) / (b + t);
        // Rounded up, without a remainder: what is divided is not zero.
        let most = (((a + s) << 63) - 1) / b + 1;
        Self::of(least, most - least, self.exponent - other.exponent - 63)
    }

    pub(crate) fn root(self) -> Self {
        let (a, s) = self.parts();
        let up = 64 - (self.exponent & 1) as u32;
        let square = a << up;
        let root = square.isqrt();
        // The root is at least 2^63: what is added to the square, s·2^up, adds less than s to it.
        let slack = s + u128::from(root * root != square);
        Self::of(root, slack, (self.exponent - up as i32) / 2)
    }
}

/// m·2^exponent as a whole number, rounded up or to the nearest; at most what `u128` holds.
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
    // Without overflow: m is far below the greatest number wherever this is called.
    m.saturating_add(add) >> down
}

#[cfg(test)]
mod tests {
    use super::{Positive, whole};

    fn number(x: u64) -> Positive {
        Positive::of_limbs(&[x]).unwrap()
    }

    /// Whether it is known exactly, and is x.
    fn is(number: Positive, x: u64) -> bool {
        let (m, exponent) = number.upper();
        number.slack == 0 && whole(m, exponent, true) == u128::from(x)
    }

    #[test]
    fn short_numbers_stay_exact() {
        for a in [1, 2, 3, 5, 12, 1 << 20, 99_999] {
            for b in [1, 4, 7, 1 << 31, 65_537] {
                assert!(is(number(a).times(number(b)), a * b));
                assert!(is(number(a).plus(number(b)), a + b));
                assert!(is(number(a * b).over(number(b)), a));
                assert!(is(number(a * a).root(), a));
            }
        }
        assert!(number(2).root().slack == 1 && number(1).over(number(3)).slack > 0);
    }

    #[test]
    fn bounds_hold_where_bits_are_lost() {
        let long = Positive::of_limbs(&[1, 0, 7]).unwrap();
        assert!(long.slack == 1);
        let near = Positive::of_limbs(&[0, 0, 7]).unwrap();
        assert!(!near.is_less_than(long) && !long.is_less_than(near));
        let sum = near.plus(number(1));
        assert!(sum.slack > 0 && sum.low == near.low);
        assert!(number(6).is_less_than(number(7)) && !number(7).is_less_than(number(7)));
        assert!(number(1).is_less_than(near) && !near.is_less_than(number(1)));
        assert!(number(u64::MAX).is_less_than(Positive::of_limbs(&[0, 1]).unwrap()));
        // Three thirds are one, for all that is known.
        let third = number(1).over(number(3));
        let one = third.plus(third).plus(third);
        assert!(!one.is_less_than(number(1)) && !number(1).is_less_than(one) && one.slack < 64);
        let (square, two) = (number(2).root().times(number(2).root()), number(2));
        assert!(!square.is_less_than(two) && !two.is_less_than(square));
    }
}
