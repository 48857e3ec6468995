//! Floats as whole multiples of one power of two.

use core::cmp::Ordering;

use super::float::{Float, quotient};
use super::integer::Int64;
use super::parts::Parts;
use super::system::{Embeds, convert};
use super::wide::I256;

/// The exponents of the lowest and highest bit of any coordinate, as powers of
/// two in units of the least number; `None` if all are zero.
fn span<F: Float>(all: &[[F; 3]]) -> Option<(i32, i32)> {
    let mut span = None;
    for x in all.as_flattened() {
        let Parts { magnitude, shift, .. } = x.parts();
        if magnitude != 0 {
            let low = i32::from(shift) + magnitude.trailing_zeros() as i32;
            let high = i32::from(shift) + 64 - magnitude.leading_zeros() as i32;
            let (l, h) = span.unwrap_or((low, high));
            span = Some((low.min(l), high.max(h)));
        }
    }
    span
}

/// `x` in units of two to the power `low`; the unit divides `x`.
fn in_units<F: Float>(x: F, low: i32) -> i64 {
    let Parts { negative, magnitude, shift } = x.parts();
    let up = i32::from(shift) - low;
    // Zero may have any exponent; nothing else shifts by more than 60.
    let whole = if magnitude == 0 {
        0
    } else if up >= 0 {
        magnitude.wrapping_shl(up as u32)
    } else {
        magnitude.wrapping_shr(up.unsigned_abs())
    } as i64;
    if negative { -whole } else { whole }
}

/// Floats as whole multiples of one power of two, if 60 bits hold them all:
/// grids, and most scenes that were once in a coarser format. One has no place
/// among them: the unit is the scene's, not the scalar's.
impl<F: Float> Embeds<F> for Int64 {
    fn holds<const K: usize>(coordinates: &[[F; 3]; K]) -> bool {
        span(coordinates).is_none_or(|(low, high)| high - low <= 60)
    }

    fn embed_held<const K: usize>(coordinates: &[[F; 3]; K]) -> [[i64; 3]; K] {
        let (low, _) = span(coordinates).unwrap_or_default();
        convert(coordinates, 0, |x| in_units(x, low))
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
