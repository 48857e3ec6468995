//! Numbers that are enclosed: in an interval, or without any rounding.

use core::cmp::Ordering;

use super::big_int::BigInt;
use super::interval::Interval;
use super::number::{Limbed, Number};
use super::soft::Soft;

/// A number with a bound on its error, or an exact one.
pub trait Enclosed: Number {
    /// The magnitude; `None` if the bound is too wide, or the number is zero.
    fn soft(self) -> Option<Soft>;

    /// The number in two's complement, the least limb first, if it is exact.
    fn exact_limbs(&self) -> Option<&[u64]>;

    /// Adds the number times `factor`·2^`shift` to a sum, or subtracts it; `None` if it is not exact.
    fn add_to<const R: usize>(
        &self,
        sum: &mut BigInt<R>,
        factor: u64,
        shift: usize,
        is_minus: bool,
    ) -> Option<()>;
}

impl Enclosed for Interval {
    fn soft(self) -> Option<Soft> {
        Self::soft(self)
    }
    fn exact_limbs(&self) -> Option<&[u64]> {
        None
    }
    fn add_to<const R: usize>(&self, _: &mut BigInt<R>, _: u64, _: usize, _: bool) -> Option<()> {
        None
    }
}

impl<const L: usize> Enclosed for BigInt<L> {
    fn soft(self) -> Option<Soft> {
        Soft::of_limbs(self.magnitude().limbs())
    }
    fn exact_limbs(&self) -> Option<&[u64]> {
        Some(self.limbs())
    }
    fn add_to<const R: usize>(
        &self,
        sum: &mut BigInt<R>,
        factor: u64,
        shift: usize,
        is_minus: bool,
    ) -> Option<()> {
        sum.add_multiple(self, factor, shift, is_minus);
        Some(())
    }
}

/// The sign of a number; `None` in doubt.
#[inline(always)]
pub(crate) fn sign_of<T: Number>(x: T) -> Option<Ordering> {
    x.partial_cmp(&T::ZERO)
}

/// [`Enclosed::add_to`] with a factor of two words.
pub(crate) fn sum_of<const R: usize, T: Enclosed>(
    sum: &mut BigInt<R>,
    x: T,
    factor: u128,
    shift: u32,
    is_minus: bool,
) -> Option<()> {
    let shift = shift as usize;
    x.add_to(sum, factor as u64, shift, is_minus)?;
    match (factor >> 64) as u64 {
        0 => Some(()),
        high => x.add_to(sum, high, shift + 64, is_minus),
    }
}

/// How a·b compares with c·d, of numbers that are not negative; `None` in doubt.
pub(crate) fn compare_products<A: Enclosed, B: Enclosed>(
    [a, c]: [A; 2],
    [b, d]: [B; 2],
) -> Option<Ordering> {
    let is_zero = |x: Option<Ordering>| Some(x? == Ordering::Equal);
    let none = [
        is_zero(sign_of(a))? || is_zero(sign_of(b))?,
        is_zero(sign_of(c))? || is_zero(sign_of(d))?,
    ];
    if none[0] || none[1] {
        return Some(none[1].cmp(&none[0]));
    }
    let (left, right) = (a.soft()?.times(b.soft()?), c.soft()?.times(d.soft()?));
    if left.is_less_than(right) {
        return Some(Ordering::Less);
    } else if right.is_less_than(left) {
        return Some(Ordering::Greater);
    }
    Some(order_of_products(
        [a.exact_limbs()?, b.exact_limbs()?],
        [c.exact_limbs()?, d.exact_limbs()?],
    ))
}

/// How a·b compares with c·d, of unsigned integers.
pub(crate) fn order_of_products([a, b]: [&[u64]; 2], [c, d]: [&[u64]; 2]) -> Ordering {
    let (mut of_ab, mut of_cd, mut order) = ([0; 2], [0; 2], Ordering::Equal);
    for k in 0..a.len() + b.len() {
        let (ab, cd);
        (ab, of_ab) = limb_of_product(a, b, k, of_ab);
        (cd, of_cd) = limb_of_product(c, d, k, of_cd);
        // A higher limb outweighs all lower ones.
        order = ab.cmp(&cd).then(order);
    }
    order
}

/// Limb `k` of a product, given the carry of the limbs below it, and its own carry.
fn limb_of_product(a: &[u64], b: &[u64], k: usize, [low, high]: [u64; 2]) -> (u64, [u64; 2]) {
    let (mut sum, mut over) = (u128::from(high) << 64 | u128::from(low), 0);
    for (i, &x) in a.iter().take(k + 1).enumerate().filter(|(_, x)| **x != 0) {
        let product = u128::from(x) * b.get(k - i).map_or(0, |&y| y.into());
        let (more, carried) = sum.overflowing_add(product);
        (sum, over) = (more, over + u64::from(carried));
    }
    (sum as u64, [(sum >> 64) as u64, over])
}
