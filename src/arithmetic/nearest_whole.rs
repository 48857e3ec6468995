//! Quotients in `f64` as integers, if it is certain to which integer they round.

use crate::arithmetic::Each;
use core::ops::{Add, Mul, Sub};

use super::number::greatest;
use super::quad::{OfFour, Quad};
use super::quotient::WHOLE;

type Row = <f64 as OfFour>::Quad;

/// The three quotients times `unit`, each rounded to the nearest integer, in its last bits, and
/// whether all are certain. They are if they are below `most` and not so close to a half that they
/// may be wrong.
#[inline(always)]
pub(super) fn nearest_whole(
    num: [f64; 3],
    den: f64,
    errors: [f64; 2],
    unit: f64,
    most: f64,
) -> ([u64; 3], bool) {
    let factors = factors(den, errors, unit);
    let of = |k: usize| {
        let [sum, rest, size] = whole_near(num[k], factors, f64::abs);
        // Ordered so that a NaN is not certain.
        (sum.to_bits(), (rest < 0.5) & (size < most))
    };
    let [(t, t_is_good), (u, u_is_good), (v, v_is_good)] = [of(0), of(1), of(2)];
    ([t, u, v], t_is_good & u_is_good & v_is_good)
}

/// The same quotients, with the divisor first.
#[inline(always)]
pub(super) fn nearest_whole_of_row(
    row @ [den, ..]: [f64; 4],
    errors: [f64; 2],
    unit: f64,
    most: f64,
) -> ([u64; 3], bool) {
    let factors = factors(den, errors, unit).each(Row::splat);
    let [sum, rest, size] = whole_near(Row::new(row), factors, Row::magnitude);
    let are_good = Row::splat(0.5).exceeds(rest) & Row::splat(most).exceeds(size);
    let [_, t, u, v] = sum.to_array();
    ([t.to_bits(), u.to_bits(), v.to_bits()], are_good & 0b1110 == 0b1110)
}

/// The integer to which all numbers between these two round, in its last bits, if it exists and
/// they are below `most`.
#[inline(always)]
pub(super) fn nearest_of_all([low, high]: [f64; 2], most: f64) -> Option<u64> {
    let (bits, last) = ((low + WHOLE).to_bits(), (high + WHOLE).to_bits());
    ((bits == last) & (low > -most) & (high < most)).then_some(bits)
}

/// The factor of the numerators, the error of a quotient, relative and absolute, and the number
/// that rounds it.
#[inline(always)]
fn factors(den: f64, errors: [f64; 2], unit: f64) -> [f64; 4] {
    let inverse = unit / den;
    // Twice the errors of the numerators, twice that of the divisor, and all roundings from here
    // on.
    let relative = inverse.abs() * (2.0 * errors[1] / unit) + 4.0 * f64::EPSILON;
    [inverse, relative, inverse.abs() * (2.0 * greatest(errors[0], errors[1])), WHOLE]
}

/// The rounded quotient plus the last factor, its distance from the quotient, and its magnitude.
#[inline(always)]
fn whole_near<T>(
    num: T,
    [inverse, relative, absolute, whole]: [T; 4],
    magnitude: impl Fn(T) -> T,
) -> [T; 3]
where
    T: Copy + Add<Output = T> + Sub<Output = T> + Mul<Output = T>,
{
    let quotient = num * inverse;
    let sum = quotient + whole;
    let size = magnitude(quotient);
    [sum, magnitude(quotient - (sum - whole)) + (size * relative + absolute), size]
}
