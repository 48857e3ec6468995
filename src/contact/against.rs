//! The face of a box that is turned against a direction, in half words: for cores where floats are
//! functions. It is certain or in doubt, and then floats decide.

use super::body::Vec64;
use crate::arithmetic::{Each, cross3, cut, dot3, exponent, pick, product, turn};

/// How far n·u may be off.
const ALONG: u32 = 1_048_576;

/// A vector over a power of two, cut toward zero, below 2^15 in size. `None` if all numbers are zero or very
/// small.
fn half_words(v: &Vec64) -> Option<[i32; 3]> {
    let unit = v.each(exponent).into_iter().fold(0, i32::max) - 14;
    (unit > 2).then(|| in_units(v, unit))
}

/// In multiples of 2^(`unit` − 1023), cut toward zero.
fn in_units(v: &Vec64, unit: i32) -> [i32; 3] {
    v.each(|x| cut(x, unit))
}

/// The face of a box most nearly antiparallel to a unit vector, among those of the axes in `of`, each on the
/// side that `upper` has; both as bits. `None` in doubt.
///
/// # The error
///
/// A number of a side is off by less than one, and a coordinate of the normal w of two sides by less than
/// 2^17 + 2. If w has 28 bits or more, the sine between the sides is above 2^-5, and w, cut to 14 bits, is n,
/// off by less than 10 in each coordinate, which is 2.2e-3 of its length. A coordinate of the unit vector is
/// off by less than 2^-15. So the sign of w·u of the third side is certain if n·u is above 2^20, and the
/// cosine between n and the unit vector is off by less than 2.5e-3, where n·v is cut too. A cosine above a
/// half whose square is 16/15 of another's, where n·n loses 2^-10 of itself, is above the other by more.
///
/// `against.g` proves it.
pub(super) fn face_against(sides: &[Vec64; 3], outward: &Vec64, of: u8, upper: u8) -> Option<u8> {
    let mut axes = [[0; 3]; 3];
    for (to, side) in axes.iter_mut().zip(sides) {
        *to = half_words(side)?;
    }
    let to = in_units(outward, 1023 - 15);
    let mut best: Option<(u8, i32, i32)> = None;
    for k in (0..3_u8).filter(|k| of >> k & 1 == 1) {
        let (k, i, j) = turn(k.into());
        let w = cross3(pick(&axes, i), pick(&axes, j));
        let width = 32 - w.iter().fold(0, |all, x| all | x ^ x >> 31).leading_zeros() as i32;
        if width < 28 {
            return None;
        }
        let n = w.each(|x| x >> (width - 14));
        let along = dot3(&n, pick(&axes, k));
        let number = 2 * k as u8 + (upper >> k & 1);
        if of.is_power_of_two() {
            return Some(number);
        }
        if along.unsigned_abs() <= ALONG {
            return None;
        }
        let cosine = dot3(&n, &to) >> 16;
        let is_outward = (along > 0) == (number % 2 == 1);
        let against = if is_outward { -cosine } else { cosine }.max(0);
        let here = (number, against * against, dot3(&n, &n) >> 16);
        let is_above =
            |a: (u8, i32, i32), b: (u8, i32, i32)| 15 * product(a.1, b.2) >= 16 * product(b.1, a.2);
        match best {
            Some(best) if is_above(best, here) => {}
            Some(other) if !is_above(here, other) => return None,
            _ => best = Some(here),
        }
    }
    best.filter(|&(_, square, length)| square >> 12 > length).map(|(number, ..)| number)
}
