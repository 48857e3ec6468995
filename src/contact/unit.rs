//! The unit vector of a translation from double words, with the bits that exact numbers give.

use super::body::{Body, Vec64};
use super::directions::Direction;
use super::settled::U;
use crate::arithmetic::{Double, pick, three, turn, two};
use crate::scalar::Scalar;

/// Squares of a roundoff in a quotient in double words.
const LOST: u16 = 32_768;

/// The relative error of such a quotient.
const ROUNDED: f64 = LOST as f64 * (U * U);

/// How much less the quotient of exact numbers may be, of itself.
const LACK: f64 = f64::from_bits((1023 - 58) << 52);

/// The unit vector along a direction that is [`settled`](super::settled::settled), if double words
/// leave no doubt. It equals [`Lengths::unit`](super::measures::Lengths::unit).
///
/// # The error
///
/// Sides are exact, in one word; products of two words would lose digits that matter where a
/// coordinate cancels. So products are exact, and a sum errs by 5·2^-106 of itself at most.
/// `inverse`, one over the length, errs by 25·u, and the first length by twice as much. A step of
/// Newton's method leaves products of these two errors, and so does a quotient by the inverse with its
/// residual. Both residuals are computed in one word: the leading words of their terms agree within a
/// factor of two, so that the difference of these is exact. `unit.g` proves that all of this is below
/// [`LOST`]·u², with room for the rounding of the end that is compared.
///
/// Exact numbers round a quotient down at v = 2^-63. Of itself, its coordinate is up to v too low. The
/// slack of its length is 17·v at most: v of a coordinate, 4·v of its square, 16·v of the sum of
/// squares, and v more of the root. So the quotient is up to 19·v too low: less than [`LACK`].
pub(super) fn unit<S: Scalar>(
    bodies: &[Body<'_, S>; 2],
    direction: Direction,
    is_along: bool,
    inverse: f64,
) -> Option<Vec64> {
    let sides = direction.sides([bodies[0].is_triangle(), bodies[1].is_triangle()]);
    let [x, y] = two(|n| bodies[sides[n].0 % 2].side_in_doubles(sides[n].1));
    if x.iter().chain(&y).any(|coordinate| coordinate.low != 0.0) {
        return None;
    }
    // Products of numbers of 24 bits are exact.
    let are_short = x.iter().chain(&y).all(|x| f64::from(x.high as f32) == x.high);
    let a = if are_short {
        let product = |j: usize, k: usize| pick(&x, j).high * pick(&y, k).high;
        three(|i| {
            let (_, j, k) = turn(i);
            Double::difference(product(j, k), product(k, j))
        })
    } else {
        Double::cross(&x, &y)
    };
    if a.iter().filter(|x| x.high != 0.0).count() == 1 {
        let sign = |x: f64| {
            if x == 0.0 {
                0.0
            } else if (x > 0.0) == is_along {
                1.0
            } else {
                -1.0
            }
        };
        return Some(three(|i| sign(a[i].high)));
    }
    let square = Double::dot(&a, &a);
    let first = square.high * inverse;
    // A step of Newton's method.
    let rest = square.less(Double::of(first).product(Double::of(first)));
    let length = Double { high: first, low: rest * (0.5 * inverse) };
    let mut unit = [0.0; 3];
    for i in 0..3 {
        let high = a[i].high * inverse;
        let low = a[i].less(Double::of(high).product(length)) * inverse;
        unit[i] = high + (low + high * ROUNDED);
        if unit[i] != high + (low - high * LACK) {
            return None;
        }
        if !is_along {
            unit[i] = -unit[i];
        }
    }
    Some(unit)
}
