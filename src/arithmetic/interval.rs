//! Numbers with a bound on their own error: a value in `f64`, and how far it may be off.
//!
//! Kernels with products of many degrees take these in place of error bounds derived by hand. Each
//! operation adds its own rounding, so that a bound holds by construction: `interval.g` proves the
//! sums. Zero is exact, and remains so.

use core::cmp::Ordering;
use core::ops::{Add, Mul, Neg, Sub};

use super::float::Float;
use super::number::Number;
use super::soft::Soft;
use super::system::Factor;

/// A number within `error` of `value`. Infinity and NaN are within any error.
#[derive(Clone, Copy, Debug)]
pub struct Interval {
    value: f64,
    error: f64,
}

/// Roundoffs of a result that count as its error. One is enough for a normal number; a smaller one
/// has none in a sum, and [`LOST`] in a product.
const ROUNDED: u16 = 2;
/// Roundoffs by which an error is raised, for the roundings of up to four sums and products in it.
const RAISED: u16 = 8;

/// At least as much as underflow loses in a product and its error.
const LOST: f64 = f64::MIN_POSITIVE;

/// Raises an error for its own roundings.
#[inline(always)]
fn raised(error: f64) -> f64 {
    error * (1.0 + 1.0_f64.error(RAISED))
}

impl Interval {
    /// A number without error.
    #[inline(always)]
    pub(crate) fn exactly(value: f64) -> Self {
        Self { value, error: 0.0 }
    }

    /// A number to the nearest.
    #[inline(always)]
    pub(crate) fn nearest(value: f64) -> Self {
        Self { value, error: value.abs().error(ROUNDED) }
    }

    #[inline(always)]
    fn sign(self) -> Option<Ordering> {
        if self.value > self.error {
            Some(Ordering::Greater)
        } else if self.value < -self.error {
            Some(Ordering::Less)
        } else {
            // Zero without error.
            (self.value == 0.0 && self.error == 0.0).then_some(Ordering::Equal)
        }
    }

    /// The magnitude with a bound on the part missing; `None` if that is more than
    /// [`between`](Soft::between) lets it be, or near the ends of the range.
    pub(super) fn soft(self) -> Option<Soft> {
        let size = self.value.abs();
        let low = (size - self.error) * (1.0 - 1.0_f64.error(RAISED));
        let high = raised(size + self.error);
        let is_normal = low > f64::MIN_POSITIVE && high < f64::MAX;
        if is_normal { Soft::between(low, high) } else { None }
    }
}

impl Neg for Interval {
    type Output = Self;
    #[inline(always)]
    fn neg(self) -> Self {
        Self { value: -self.value, ..self }
    }
}

impl Add for Interval {
    type Output = Self;
    #[inline(always)]
    fn add(self, other: Self) -> Self {
        let value = self.value + other.value;
        let is_exact = self.value == 0.0 || other.value == 0.0 || value == 0.0;
        let rounded = if is_exact { 0.0 } else { value.abs().error(ROUNDED) };
        Self { value, error: raised(self.error + other.error + rounded) }
    }
}

impl Sub for Interval {
    type Output = Self;
    #[inline(always)]
    fn sub(self, other: Self) -> Self {
        self + -other
    }
}

impl Mul for Interval {
    type Output = Self;
    #[inline(always)]
    fn mul(self, other: Self) -> Self {
        let value = self.value * other.value;
        let (a, b) = (self.value.abs(), other.value.abs());
        let most = (a + self.error) * other.error + b * self.error + value.abs().error(ROUNDED);
        let is_zero = |x: Self| x.value == 0.0 && x.error == 0.0;
        if is_zero(self) || is_zero(other) {
            return Self::ZERO;
        }
        Self { value, error: raised(most) + LOST }
    }
}

impl PartialEq for Interval {
    fn eq(&self, other: &Self) -> bool {
        self.partial_cmp(other) == Some(Ordering::Equal)
    }
}

/// `None` in doubt.
impl PartialOrd for Interval {
    #[inline(always)]
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        (*self - *other).sign()
    }
}

impl Number for Interval {
    const ZERO: Self = Self { value: 0.0, error: 0.0 };

    #[inline(always)]
    fn magnitude(self) -> Self {
        Self { value: self.value.abs(), ..self }
    }
    #[inline(always)]
    fn half(self) -> Self {
        self * Self::exactly(f64::HALF)
    }
}

impl Factor for Interval {
    const CERTAIN: bool = false;
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::arithmetic::Each;

    /// Sums and products enclose the results of all numbers within the errors.
    #[test]
    fn results_enclose_the_truth() {
        let values = [0.0, 1.0, -1.0, 3.0, -0.1, 1e300, 1e-300, 5e-324, 1.0 + f64::EPSILON];
        // Slightly within, so that rounding does not lead out.
        let ends = |x: Interval| {
            let error = x.error * (1.0 - 1e-6);
            [x.value - error, x.value, x.value + error]
        };
        let all: [Interval; 18] = core::array::from_fn(|k| Interval {
            value: values[k / 2],
            error: if k % 2 == 0 { 0.0 } else { values[k / 2].abs() * 1e-9 },
        });
        for (a, b) in all.iter().flat_map(|a| all.map(|b| (*a, b))) {
            let (sum, product) = (a + b, a * b);
            for (x, y) in ends(a).into_iter().flat_map(|x| ends(b).each(|y| (x, y))) {
                // Rounded once more, hence once more the roundoff.
                let holds = |x: Interval, y: f64| {
                    let off = (x.value - y).abs();
                    off <= x.error * (1.0 + 1e-15) + y.abs() * f64::EPSILON || !y.is_finite()
                };
                assert!(holds(sum, x + y) && holds(product, x * y), "{a:?} {b:?} {x} {y}");
            }
        }
        let third = Interval::nearest(1.0 / 3.0);
        assert_eq!((third + third + third).partial_cmp(&Interval::exactly(1.0)), None);
        assert_eq!((third - third).sign(), None);
        assert_eq!((third * Interval::ZERO).sign(), Some(Ordering::Equal));
        assert!(third < Interval::exactly(0.34) && third > Interval::exactly(0.33));
        let huge = Interval::exactly(1e200);
        assert_eq!((huge * huge).sign(), None);
        assert!((huge * huge).soft().is_none() && (third - third).soft().is_none());
    }
}
