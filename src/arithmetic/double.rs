//! Double-word floats: sums without loss, and numbers of two `f64`, the second below the last place
//! of the first.
//!
//! M. Joldes, J.-M. Muller, V. Popescu, "Tight and Rigorous Error Bounds for Basic Building Blocks
//! of Double-Word Arithmetic", *ACM Transactions on Mathematical Software* 44(2), 2017. With u =
//! 2^-53, a sum (their algorithm 6) errs by at most 3·u² + 13·u³ of itself, and a product
//! (algorithm 10) by 5·u², if nothing underflows or overflows.

use core::ops::{Add, Mul, Sub};

use super::index::three;
use super::parts::{exp2, scaled};
use super::quad::Quad;
use super::soft::Soft;

/// a − b without loss: the rounded difference, and its rounding error.
///
/// D. E. Knuth, *The Art of Computer Programming*, volume 2, 4.2.2, theorem B.
#[inline(always)]
pub(crate) fn two_difference<T>(a: T, b: T) -> [T; 2]
where
    T: Copy + Add<Output = T> + Sub<Output = T>,
{
    let difference = a - b;
    let of_b = a - difference;
    [difference, (a - (difference + of_b)) + (of_b - b)]
}

/// a + b without loss for |a| ≥ |b|: the rounded sum, and its rounding error.
///
/// T. J. Dekker, "A Floating-Point Technique for Extending the Available Precision",
/// *Numerische Mathematik* 18, 1971.
#[inline(always)]
pub(crate) fn fast_two_sum<T>(a: T, b: T) -> [T; 2]
where
    T: Copy + Add<Output = T> + Sub<Output = T>,
{
    let sum = a + b;
    [sum, (a - sum) + b]
}

/// a + b without loss (Knuth, as above).
#[inline(always)]
fn two_sum<T>(a: T, b: T) -> [T; 2]
where
    T: Copy + Add<Output = T> + Sub<Output = T>,
{
    let sum = a + b;
    let of_b = sum - a;
    [sum, (a - (sum - of_b)) + (b - of_b)]
}

/// What doubles are made of: `f64`, alone or side by side.
pub(crate) trait Words:
    Copy + Add<Output = Self> + Sub<Output = Self> + Mul<Output = Self>
{
    /// The same number in all lanes.
    fn all(x: f64) -> Self;
}

impl Words for f64 {
    #[inline(always)]
    fn all(x: f64) -> Self {
        x
    }
}

impl<Q: Quad<Lane = f64>> Words for Q {
    #[inline(always)]
    fn all(x: f64) -> Self {
        Self::splat(x)
    }
}

/// a·b and its rounding error, for numbers below 2^996 (Dekker 1971).
#[inline(always)]
fn two_product<T: Words>(a: T, b: T) -> [T; 2] {
    /// 2^27 + 1.
    const HALF: f64 = 134_217_729.0;
    let split = |x: T| {
        let c = T::all(HALF) * x;
        let high = c - (c - x);
        [high, x - high]
    };
    let ([a1, a2], [b1, b2]) = (split(a), split(b));
    let product = a * b;
    [product, ((a1 * b1 - product) + a1 * b2 + a2 * b1) + a2 * b2]
}

/// high + low, to about 106 binary digits.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Double<T = f64> {
    pub(crate) high: T,
    pub(crate) low: T,
}

impl<T: Words> Double<T> {
    #[inline(always)]
    fn of_two([high, low]: [T; 2]) -> Self {
        Self { high, low }
    }

    /// a·b, exactly.
    #[inline(always)]
    pub(crate) fn of_product(a: T, b: T) -> Self {
        Self::of_two(two_product(a, b))
    }

    #[inline(always)]
    pub(crate) fn plus(self, other: Self) -> Self {
        let [high, rest] = two_sum(self.high, other.high);
        let [low, last] = two_sum(self.low, other.low);
        let [high, low] = fast_two_sum(high, rest + low);
        Self::of_two(fast_two_sum(high, last + low))
    }

    #[inline(always)]
    pub(crate) fn minus(self, other: Self) -> Self {
        let [high, rest] = two_difference(self.high, other.high);
        let [low, last] = two_difference(self.low, other.low);
        let [high, low] = fast_two_sum(high, rest + low);
        Self::of_two(fast_two_sum(high, last + low))
    }

    /// The product, with a `low` that may overlap `high`. Exact if both factors have a `low` of
    /// zero.
    #[inline(always)]
    pub(crate) fn product(self, other: Self) -> Self {
        let [high, rest] = two_product(self.high, other.high);
        let mixed = self.high * other.low + self.low * other.high;
        Self { high, low: rest + mixed }
    }

    #[inline(always)]
    pub(crate) fn times(self, other: Self) -> Self {
        let Self { high, low } = self.product(other);
        Self::of_two(fast_two_sum(high, low))
    }
}

/// Operations whose `low` may overlap `high`. Their errors are bounded by the sizes of the operands, and not
/// by the result, and the next operation waits half as long for them.
impl<T: Words> Double<T> {
    #[inline(always)]
    pub(crate) fn loose_sum(self, other: Self) -> Self {
        let [high, rest] = two_sum(self.high, other.high);
        Self { high, low: rest + (self.low + other.low) }
    }

    #[inline(always)]
    pub(crate) fn loose_difference(self, other: Self) -> Self {
        let [high, rest] = two_difference(self.high, other.high);
        Self { high, low: rest + (self.low - other.low) }
    }

    /// The product with one word.
    #[inline(always)]
    pub(crate) fn scaled(self, x: T) -> Self {
        let [high, rest] = two_product(self.high, x);
        Self { high, low: rest + self.low * x }
    }
}

impl Double {
    pub(crate) const ZERO: Self = Self { high: 0.0, low: 0.0 };

    #[inline(always)]
    pub(crate) fn of(x: f64) -> Self {
        Self { high: x, low: 0.0 }
    }

    /// The same number, with a `low` below the last place of `high`.
    #[inline(always)]
    pub(crate) fn apart(self) -> Self {
        Self::of_two(two_sum(self.high, self.low))
    }

    /// a − b, exactly.
    #[inline(always)]
    pub(crate) fn difference(a: f64, b: f64) -> Self {
        Self::of_two(two_difference(a, b))
    }

    #[inline(always)]
    pub(crate) fn negated(self) -> Self {
        Self { high: -self.high, low: -self.low }
    }

    #[inline(always)]
    pub(crate) fn magnitude(self) -> Self {
        if self.high < 0.0 { self.negated() } else { self }
    }

    /// a × b.
    #[inline(always)]
    pub(crate) fn cross(a: &[Self; 3], b: &[Self; 3]) -> [Self; 3] {
        let minor = |j: usize, k: usize| a[j].times(b[k]).minus(a[k].times(b[j]));
        [minor(1, 2), minor(2, 0), minor(0, 1)]
    }

    /// a·b.
    #[inline(always)]
    pub(crate) fn dot(a: &[Self; 3], b: &[Self; 3]) -> Self {
        a[0].times(b[0]).plus(a[1].times(b[1])).plus(a[2].times(b[2]))
    }

    /// a − b of points, exactly.
    #[inline(always)]
    pub(crate) fn way(a: &[f64; 3], b: &[f64; 3]) -> [Self; 3] {
        three(|i| Self::difference(a[i], b[i]))
    }
}

impl Double {
    /// The first 64 digits of the size of a number that is within `error` of this one: the least that they
    /// may be, and the most. `None` for numbers near zero.
    pub(crate) fn leading(self, error: f64) -> Option<[Soft; 2]> {
        /// Added to the second word in units of the last place. Sums lose less than 2^-39.
        const WHOLE: f64 = 4096.0;
        const LOST: f64 = 1.0 / (1_u64 << 39) as f64;
        let Self { high, low } = self.magnitude();
        let Soft { exponent, mantissa, .. } = Soft::of_normal(high);
        if exponent < -1022 {
            return None;
        }
        let unit = exp2(-exponent);
        let (low, error) = (low * unit + WHOLE, error * unit + LOST);
        let digits = |low: f64, is_most: bool| {
            let more = (low as u64).checked_sub(1)?.wrapping_sub(WHOLE as u64 - 1);
            let digits = mantissa.checked_add_signed(more as i64)?;
            // A number with a leading zero has a digit more.
            Some(if digits >> 63 == 1 {
                Soft { exponent, mantissa: digits, slack: 0 }
            } else {
                Soft {
                    exponent: exponent - 1,
                    mantissa: digits << 1 | u64::from(is_most),
                    slack: 0,
                }
            })
        };
        Some([digits(low - error, false)?, digits(low + error, true)?])
    }

    /// The size of an exact number that is not zero; `None` if 64 digits do not hold it.
    pub(crate) fn in_soft(self) -> Option<Soft> {
        let Self { high, low } = self.magnitude();
        let Soft { exponent, mantissa, .. } = Soft::of_normal(high);
        let low = low * scaled(1, -exponent);
        let whole = low as i64;
        let value = u128::from(mantissa).wrapping_add_signed(whole.into());
        (whole as f64 == low).then(|| Soft::of(value, 0, exponent))
    }
}

#[cfg(test)]
mod tests {
    use super::Double;

    #[test]
    fn what_a_double_loses_is_kept() {
        let third = 1.0 / 3.0;
        let a = Double::difference(third, -1e-20);
        assert_eq!((a.high, a.low), (third, 1e-20));
        // (x + y)·(x − y) − x² + y² is zero, to 104 digits.
        let (x, y) = (Double::of(third), Double::of(1e-9 / 7.0));
        let product = x.plus(y).times(x.minus(y));
        let rest = product.minus(x.times(x)).plus(y.times(y));
        assert!(rest.high.abs() < 1e-31 && product.low != 0.0, "{rest:?}");
        assert_eq!(a.minus(a), Double::ZERO);
        assert_eq!(a.plus(a.negated()), Double::ZERO);
    }
}
