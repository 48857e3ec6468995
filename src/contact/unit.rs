//! The unit vector of a translation from double words, with the bits that exact numbers give.

use super::body::{Vec64, flipped};
use super::exact::length;
use super::measures::unit_of;
use crate::arithmetic::{Double, Each, compare, exp2, pick, three, turn};

/// Units of 2^-80 in a coordinate in two words, of itself.
const LOST: u16 = 16;

/// The relative error of such a coordinate.
const ROUNDED: f64 = LOST as f64 * exp2(-80);

/// Added to a number up to 2^25 and taken away, it leaves a multiple of 2^-26.
const GRID: f64 = 1.5 * exp2(26);

/// How much less the quotient of exact numbers may be, of itself.
const LACK: f64 = 20.0 * exp2(-63);

/// The unit vector along a direction that is [`settled`](super::settled::settled), if double words
/// leave no doubt. It equals [`Lengths::unit`](super::measures::Lengths::unit).
///
/// # The error
///
/// Sides are exact, in one word; products of two words would lose digits that matter where a
/// coordinate cancels. So products are exact, and a sum errs by 5·2^-106 of itself at most.
/// `inverse`, one over the length, errs by f of itself, at most 25·u. Each coordinate times `inverse` is
/// kept in two words, h + r, and the three squares add up to (1 + f)². The sum less one is computed
/// from leading parts of h, which are multiples of 2^-26 with exact squares, and from rests below
/// 2^-27. Half of it is f + f²/2. A coordinate of the unit vector is (h + r)/(1 + f). It differs
/// from h + (r − h·f) by squares of f. `unit.g` proves that all errors together are below
/// [`LOST`]·2^-80, with room for the rounding of the end that is compared.
///
/// Exact numbers round a quotient down at v = 2^-63. Of itself, its coordinate is up to v too low. The
/// slack of its length is 17·v at most: v of a coordinate, 4·v of its square, 16·v of the sum of
/// squares, and v more of the root. So the quotient is up to 19·v too low: less than [`LACK`].
#[inline(always)] // A vector returned through memory would wait for its stores.
pub(super) fn unit([x, y]: [&Vec64; 2], is_along: bool, inverse: f64) -> Option<Vec64> {
    // Products of numbers of 24 bits are exact.
    let is_short = |x: &Vec64| three(|i| f64::from(x[i] as f32) == x[i]) == [true; 3];
    let are_short = is_short(x) && is_short(y);
    let a = if are_short {
        let product = |j: usize, k: usize| pick(x, j) * pick(y, k);
        three(|i| {
            let (_, j, k) = turn(i);
            Double::difference(product(j, k), product(k, j))
        })
    } else {
        Double::cross(&x.each(Double::of), &y.each(Double::of))
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
    let (mut high, mut low, mut square, mut rest) = ([0.0; 3], [0.0; 3], -1.0, 0.0);
    for i in 0..3 {
        let Double { high: h, low: r } = a[i].product(Double::of(inverse));
        let lead = (h + GRID) - GRID;
        let tail = h - lead;
        square += lead * lead;
        rest += (2.0 * lead + tail) * tail + 2.0 * h * r;
        (high[i], low[i]) = (h, r);
    }
    let off = 0.5 * (square + rest);
    let [Some(x), Some(y), Some(z)] = three(|i| {
        let (high, low) = (high[i], low[i] - high[i] * off);
        let unit = high + (low + high * ROUNDED);
        let is_certain = unit == high + (low - high * LACK);
        is_certain.then(|| flipped(unit, !is_along))
    }) else {
        if !are_short {
            return None;
        }
        let [x, y, z] = by_integers(&a, is_along)?;
        return Some([x, y, z]);
    };
    Some([x, y, z])
}

/// The same for an exact direction, by the operations of exact numbers; `None` if 64 bits do not hold a
/// coordinate.
#[cold]
#[inline(never)]
fn by_integers(a: &[Double; 3], is_along: bool) -> Option<Vec64> {
    let mut coordinates = [None; 3];
    for (to, x) in coordinates.iter_mut().zip(a).filter(|(_, x)| x.high != 0.0) {
        *to = Some((compare(x.high, 0.0), x.in_soft()?));
    }
    let (length, _) = length(&coordinates)?;
    let ratios = coordinates.each(|coordinate| coordinate.map(|(_, size)| size.over(length)));
    Some(unit_of(&coordinates, is_along, ratios))
}
