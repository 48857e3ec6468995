//! Roots of quadratic equations, each rounded once, to the next number of the scalar below or above.
//!
//! A root of a·t² − 2·p·t + c, with p at least zero, is (p + √q)/a, or c/(p + √q) for the lesser
//! one: no difference, so nothing cancels but in c and q. The first stage computes it in intervals,
//! and answers if all of these round to one number. The second has exact numbers. It cuts them to
//! 64 digits, and where these are not enough it puts a number of the scalar into the equation.
//! The result is therefore the same in all stages, and on every machine.

use core::cmp::Ordering;

use crate::arithmetic::{
    Arithmetic, BigInt, Embeds, Enclosed, Interval, Number, OneType, Parts, REGISTERS_ARE_WIDE,
    Soft, sign_of, sum_of,
};
use crate::scalar::Scalar;

/// The number of infinity in the order of all values, or of the greatest value of fixed point.
pub(super) fn last_ordinal<S: Scalar>() -> i64 {
    S::at_most(Soft::ONE.scaled(1 << 13)).ordinal()
}

/// A question about `K` vectors in intervals or in exact numbers. Its answer does not depend on which
/// they are.
pub(super) trait Question<S: Scalar, const K: usize> {
    type Answer;

    /// The coordinates. Vectors of zeros may fill up the rest.
    fn numbers(&self) -> [[S; 3]; K];

    /// The answer, given these numbers in one unit; `None` in doubt.
    fn solve<N>(&self, numbers: &[[N::Length; 3]; K]) -> Option<Self::Answer>
    where
        N: Arithmetic<Area: Enclosed, Quartic: Enclosed, Sextic: Enclosed>;

    /// The answer. Exact numbers always have one.
    fn settle(&self) -> Option<Self::Answer> {
        let numbers = self.numbers();
        // Intervals are slow without floats in hardware, but still faster than floats as integers.
        if REGISTERS_ARE_WIDE || S::FLOAT.is_some() {
            let mut given = [[Interval::ZERO; 3]; K];
            for (to, x) in given.as_flattened_mut().iter_mut().zip(numbers.as_flattened()) {
                let x = x.units();
                *to = if S::IS_IN_DOUBLE { Interval::exactly(x) } else { Interval::nearest(x) };
            }
            let answer = self.solve::<OneType<Interval>>(&given);
            if answer.is_some() {
                return answer;
            }
        }
        self.settle_exactly(&numbers)
    }

    #[cold]
    #[inline(never)]
    fn settle_exactly(&self, numbers: &[[S; 3]; K]) -> Option<Self::Answer> {
        // On a small core one width is enough, as in `in_exact_numbers`.
        if REGISTERS_ARE_WIDE {
            if let Some(given) = S::SeptumWindow::embed(numbers) {
                return self.solve::<S::SeptumWindow>(&given);
            }
        }
        self.solve::<S::SeptumFull>(&S::SeptumFull::embed(numbers)?)
    }
}

/// Whether a number is certainly above zero; `None` in doubt.
#[inline(always)]
pub(super) fn is_above<T: Number>(x: T) -> Option<bool> {
    Some(sign_of(x)? == Ordering::Greater)
}

/// The equation a·t² − 2·p·t + c = 0, where a is above zero.
#[derive(Clone, Copy)]
pub(super) struct Equation<T> {
    pub(super) a: T,
    pub(super) p: T,
    pub(super) c: T,
}

impl<T: Number> Equation<T> {
    /// Whether its roots, if it has any, are above zero; `None` in doubt.
    #[inline(always)]
    pub(super) fn is_ahead(&self) -> Option<bool> {
        Some(is_above(self.p)? && is_above(self.c)?)
    }

    /// Its lesser root, given √(p² − a·c), if that is not zero.
    #[inline(always)]
    pub(super) fn lesser(self, root: Option<Soft>) -> Surd<T> {
        Surd { equation: self, root, is_far: false }
    }

    /// The equation of the opposite roots.
    pub(super) fn turned(self) -> Self {
        Self { p: -self.p, ..self }
    }
}

/// A root of an equation: the magnitude alone. Only [`lesser`](Self::lesser) takes a p below zero.
pub(super) struct Surd<T> {
    equation: Equation<T>,
    /// √(p² − a·c), if that is not zero.
    root: Option<Soft>,
    /// Whether it is the greater root, with the sign of p. The lesser root has the sign of c.
    is_far: bool,
}

/// The limbs of all terms of the equation. The longest are six lengths of `f64`, with 197 limbs, times
/// the square of a time with 1,074 binary places, and 132 limbs for a root of any size.
const LIMBS: usize = 240;

/// The magnitude, if it is not zero; `None` in doubt.
pub(super) fn magnitude<T: Enclosed>(x: T) -> Option<Option<Soft>> {
    if sign_of(x)? == Ordering::Equal { Some(None) } else { Some(Some(x.soft()?)) }
}

/// √x, if it is not zero; `None` in doubt.
pub(super) fn root<T: Enclosed>(x: T) -> Option<Option<Soft>> {
    Some(magnitude(x)?.map(Soft::root))
}

impl<T: Enclosed> Surd<T> {
    /// The root, if it is not zero; `None` in doubt.
    fn enclosed(&self) -> Option<Option<Soft>> {
        let Equation { a, p, c } = self.equation;
        let sum = match (magnitude(p)?, self.root) {
            (Some(p), Some(root)) => Some(p.plus(root)),
            (p, root) => p.or(root),
        };
        let Some(sum) = sum else { return Some(None) };
        Some(if self.is_far {
            Some(sum.over(a.soft()?))
        } else {
            magnitude(c)?.map(|c| c.over(sum))
        })
    }

    /// How a number that is not negative compares with the root; `None` without exact numbers.
    fn compare<S: Scalar>(&self, x: S) -> Option<Ordering> {
        self.compare_parts::<S>(x.parts())
    }

    /// Whether the root is above one, which the scalar need not hold; `None` without exact numbers.
    pub(super) fn is_above_one<S: Scalar>(&self) -> Option<bool> {
        Some(self.compare_parts::<S>(S::ONE)? == Ordering::Less)
    }

    #[inline(never)]
    fn compare_parts<S: Scalar>(&self, parts: Parts) -> Option<Ordering> {
        let zeros = if parts.magnitude == 0 { 0 } else { parts.magnitude.trailing_zeros() };
        let m = u128::from(parts.magnitude >> zeros);
        let exponent = i32::from(parts.shift) + zeros as i32 - i32::from(S::ONE.shift);
        let (up, down) = (exponent.max(0).unsigned_abs(), exponent.min(0).unsigned_abs());
        let Equation { a, p, c } = self.equation;
        // The lesser root may be negative. It is then a root for −p.
        let is_below = !self.is_far && c < T::ZERO;
        let mut value = BigInt::<LIMBS>([0; LIMBS]);
        sum_of(&mut value, a, m * m, 2 * up, false)?;
        sum_of(&mut value, p, m, up + down + 1, !is_below)?;
        sum_of(&mut value, c, 1, 2 * down, false)?;
        let value = value.sign();
        if is_below {
            return Some(value);
        }
        // On which side of the least value, at p/a.
        let mut side = BigInt::<LIMBS>([0; LIMBS]);
        sum_of(&mut side, a, m, up, false)?;
        sum_of(&mut side, p, 1, down, true)?;
        let (side, between) =
            (side.sign(), if self.is_far { Ordering::Less } else { Ordering::Greater });
        let is_other = side == between;
        Some(match value {
            Ordering::Less => between,
            Ordering::Greater if is_other == self.is_far => Ordering::Less,
            Ordering::Greater => Ordering::Greater,
            Ordering::Equal if is_other => between,
            Ordering::Equal => Ordering::Equal,
        })
    }

    /// The number of the greatest value of the scalar that is not above the root, in the order of
    /// all values, and whether it is the root; `None` in doubt.
    fn ordinal<S: Scalar>(&self, with_equality: bool) -> Option<(i64, bool)> {
        let Some(soft) = self.enclosed()? else { return Some((0, true)) };
        let floor = |x: Soft| {
            let x = S::at_most(x);
            x.ordinal() - i64::from(!x.is_finite())
        };
        let (mut low, mut high) = (floor(soft), floor(soft.above()));
        if low == high {
            // So is a root beyond the greatest float. Else the lower bound of the root is a number of
            // the scalar.
            let is_above = floor(soft.below()) == low || !S::at_most(soft).is_finite();
            if is_above || soft.is_exact() || !with_equality {
                return Some((low, !is_above && soft.is_exact()));
            }
        }
        while low < high {
            let middle = low + (high - low + 1) / 2;
            if self.compare(S::of_ordinal(middle))? == Ordering::Greater {
                high = middle - 1;
            } else {
                low = middle;
            }
        }
        Some((low, self.compare(S::of_ordinal(low))? == Ordering::Equal))
    }

    /// The lesser root of the equation of the opposite roots.
    pub(super) fn turned(&self) -> Self {
        Self { equation: self.equation.turned(), ..*self }
    }

    /// The greatest number of the scalar that is not above the root; `None` in doubt.
    pub(super) fn floor<S: Scalar>(&self) -> Option<S> {
        Some(S::of_ordinal(self.ordinal::<S>(false)?.0))
    }

    /// The root, or minus the root, to the next number of the scalar above or below; at the ends of
    /// fixed point, and an infinity above all floats. `None` in doubt.
    pub(super) fn rounded<S: Scalar>(&self, is_negative: bool, is_up: bool) -> Option<S> {
        let (low, is_equal) = self.ordinal::<S>(true)?;
        let end = last_ordinal::<S>();
        let mut more = i64::from(!is_equal && is_up != is_negative);
        if S::FLOAT.is_none() && is_negative && is_up && low == end {
            // Fixed point has a number more below zero.
            more = i64::from(self.compare(S::of_ordinal(-end - 1))?.is_le());
        }
        Some(S::of_ordinal(if is_negative {
            -low - more
        } else {
            low.saturating_add(more).min(end)
        }))
    }

    /// The lesser root, or minus that, rounded likewise.
    pub(super) fn lesser<S: Scalar>(self, is_minus: bool, is_up: bool) -> Option<S> {
        // For p below zero, it is minus the greater root for −p.
        let Equation { p, c, .. } = self.equation;
        let is_back = sign_of(p)? == Ordering::Less;
        let is_negative = is_back || sign_of(c)? == Ordering::Less;
        let equation = if is_back { self.equation.turned() } else { self.equation };
        Self { equation, is_far: is_back, ..self }.rounded(is_negative != is_minus, is_up)
    }
}
