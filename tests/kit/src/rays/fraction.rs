//! Exact fractions, and the distance of a scalar from one.

use core::cmp::Ordering;

use dashu_int::IBig;
use dashu_int::ops::BitTest;

use crate::{Each, Parts, Sample};

/// num / den · 2^exponent, with den above zero.
#[derive(Clone, Debug)]
pub struct Fraction {
    num: IBig,
    den: IBig,
    exponent: i32,
}

impl Fraction {
    pub(crate) fn new(num: IBig, den: IBig, exponent: i32) -> Self {
        match den.sign() {
            dashu_int::Sign::Positive => Self { num, den, exponent },
            dashu_int::Sign::Negative => Self { num: -num, den: -den, exponent },
        }
    }

    /// The numerators of the fraction and of a scalar over a common denominator, den times a power
    /// of two.
    fn beside(&self, (mantissa, exponent): Parts) -> (IBig, IBig, i32) {
        let other = IBig::from(mantissa) * &self.den;
        // Zero has no exponent of its own.
        let exponent = if mantissa == 0 { self.exponent } else { exponent };
        let unit = exponent.min(self.exponent);
        let mine = self.num.clone() << (self.exponent - unit) as usize;
        (mine, other << (exponent - unit) as usize, unit)
    }

    /// Compares the fraction with the scalar.
    pub fn compare<S: Sample>(&self, x: S) -> Ordering {
        self.compare_parts(x.mantissa_exponent())
    }

    pub(super) fn compare_parts(&self, x: Parts) -> Ordering {
        let (mine, other, _) = self.beside(x);
        mine.cmp(&other)
    }

    /// How the fraction compares with another.
    pub fn compare_with(&self, other: &Self) -> Ordering {
        let unit = self.exponent.min(other.exponent);
        let shifted = |x: &Self| x.num.clone() << (x.exponent - unit) as usize;
        (shifted(self) * &other.den).cmp(&(shifted(other) * &self.den))
    }

    pub fn is_zero(&self) -> bool {
        self.num == IBig::ZERO
    }

    /// An approximation of the value.
    pub fn approximate(&self) -> f64 {
        ratio(&self.num, &self.den, self.exponent)
    }

    /// The distance of the scalar from the fraction, in units in the last place of the scalar
    /// nearest to the fraction.
    pub fn error_in_ulp<S: Sample>(&self, x: S) -> f64 {
        let (mine, other, unit) = self.beside(x.mantissa_exponent());
        let (_, last_place) = S::nearest(self.approximate()).mantissa_exponent();
        ratio(&(mine - other), &self.den, unit - last_place).abs()
    }

    /// Whether the scalar is the nearest of its type, or the even one of two.
    pub fn is_nearest<S: Sample>(&self, x: S) -> bool {
        let neighbours = [-1, 0, 1].each(|steps| x.moved(steps).mantissa_exponent());
        self.is_nearest_of(neighbours, x.ordinal() % 2 == 0)
    }

    fn is_nearest_of(&self, [down, x, up]: [Parts; 3], is_even: bool) -> bool {
        let on_the_side = |neighbour: Parts, farther: Ordering| {
            // Compares the fraction with the midpoint of the scalar and its neighbour.
            let doubled = Self { exponent: self.exponent + 1, ..self.clone() };
            let (p, q, unit) = doubled.beside(x);
            let (r, s, other) = doubled.beside(neighbour);
            let shift = |n: IBig, from: i32| n << (from - unit.min(other)) as usize;
            debug_assert_eq!(shift(p.clone(), unit), shift(r, other));
            let middle = shift(q, unit) + shift(s, other);
            match shift(p, unit).cmp(&middle) {
                Ordering::Equal => is_even,
                side => side != farther,
            }
        };
        (up == x || on_the_side(up, Ordering::Greater))
            && (down == x || on_the_side(down, Ordering::Less))
    }

    /// Whether the scalar's range ends before the fraction.
    pub fn is_beyond<S: Sample>(&self) -> bool {
        self.compare(S::GREATEST) == Ordering::Greater || self.compare(S::LEAST) == Ordering::Less
    }
}

/// num / den · 2^exponent, within a few units in the last place.
fn ratio(num: &IBig, den: &IBig, exponent: i32) -> f64 {
    let bits = |n: &IBig| n.bit_len() as i32;
    if num == &IBig::ZERO {
        return 0.0;
    }
    let shift = 64 + bits(den) - bits(num);
    let quotient = if shift >= 0 {
        (num.clone() << shift as usize) / den
    } else {
        num / (den.clone() << -shift as usize)
    };
    let exponent = exponent - shift;
    // As three factors, because a single power of two might overflow or underflow.
    let (a, b) = (exponent / 3, exponent / 3);
    let parts = [a, b, exponent - a - b].each(|e| 2_f64.powi(e));
    i128::try_from(quotient).expect("65 bits") as f64 * parts[0] * parts[1] * parts[2]
}
