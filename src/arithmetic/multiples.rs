//! Floats as whole multiples of one power of two.

use core::cmp::Ordering;

use super::float::{Float, quotient};
use super::integer::Int64;
use super::parts::Parts;
use super::system::{Embeds, convert};
use super::wide::I256;

/// The exponents of the lowest and highest bit of any coordinate, as powers of two in
/// units of the least number: without a branch, for whether one is zero is hard to guess.
fn span<F: Float>(all: &[[F; 3]]) -> (i32, i32) {
    let mut span = (i32::MAX, 0);
    for x in all.as_flattened() {
        let Parts { magnitude, shift, .. } = x.parts();
        let low = i32::from(shift) + magnitude.trailing_zeros() as i32;
        let high = i32::from(shift) + 64 - magnitude.leading_zeros() as i32;
        let is_zero = magnitude == 0;
        span.0 = span.0.min(if is_zero { i32::MAX } else { low });
        span.1 = span.1.max(if is_zero { 0 } else { high });
    }
    span
}

/// Whether 60 bits hold all.
fn is_short((low, high): (i32, i32)) -> bool {
    high.saturating_sub(low) <= 60
}

/// `x` in units of two to the power `low`; the unit divides `x`.
#[inline]
fn in_units<F: Float>(x: F, low: i32) -> i64 {
    let Parts { negative, magnitude, shift } = x.parts();
    // Up or down by less than 64, and no bit goes over the end.
    let whole = magnitude.rotate_left(i32::from(shift).wrapping_sub(low) as u32) as i64;
    if negative { -whole } else { whole }
}

/// Floats as whole multiples of one power of two, if 60 bits hold them all:
/// grids, and most scenes that were once in a coarser format. One has no place
/// among them: the unit is the scene's, not the scalar's.
impl<F: Float> Embeds<F> for Int64 {
    fn holds<const K: usize>(coordinates: &[[F; 3]; K]) -> bool {
        is_short(span(coordinates))
    }

    fn embed_held<const K: usize>(coordinates: &[[F; 3]; K]) -> [[i64; 3]; K] {
        let (low, _) = span(coordinates);
        convert(coordinates, 0, |x| in_units(x, low))
    }

    fn embed<const K: usize>(coordinates: &[[F; 3]; K]) -> Option<[[i64; 3]; K]> {
        let span = span(coordinates);
        is_short(span).then(|| convert(coordinates, 0, |x| in_units(x, span.0)))
    }

    const DIVIDES: bool = true;

    fn quotient_of_lengths(num: i64, den: i64) -> F {
        quotient(I256::from(i128::from(num)).into(), I256::from(i128::from(den)).into())
    }

    fn quotients([a, b, c]: [I256; 3], den: I256, _: [I256; 2]) -> ([F; 3], bool) {
        let of = |num: I256| quotient(num.into(), den.into());
        ([of(a), of(b), of(c)], true)
    }

    // Times are not in the scene's unit.
    fn compare_quotient(_: I256, _: I256, _: [I256; 2], _: F) -> Option<Ordering> {
        None
    }
}
