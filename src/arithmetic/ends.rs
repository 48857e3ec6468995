//! Intervals of floats around quotients of numbers with errors. `ends.g` proves that they hold what
//! they are said to hold.

use super::float::Float;
use super::index::three;
use super::number::Number;
use super::quad::Quad;

/// Roundoffs of a quotient, and of the ends of an interval around it.
const ENDS: u16 = 8;

/// Roundoffs of a + v·t, and of the ends of an interval around it.
const ENDS_ON_LINE: u16 = 24;

/// num/den, and a bound on its error, if the divisor is known to a quarter.
#[inline(always)]
fn quotient<F: Float>(num: F, den: F, [error, other]: [F; 2]) -> Option<[F; 2]> {
    let two = F::from(2);
    // One division, which takes as long as all else.
    let inverse = F::from(1) / den;
    let q = num * inverse;
    let bound = two * (error + q.magnitude() * other) * inverse;
    (two * two * other <= den).then_some([q, bound])
}

/// Two numbers that enclose num/den, if the divisor is known to a quarter.
#[inline(always)]
pub(crate) fn enclosed<F: Float>(num: F, den: F, errors: [F; 2]) -> Option<[F; 2]> {
    let [q, bound] = quotient(num, den, errors)?;
    let bound = bound + (bound + q.magnitude()).error(ENDS);
    Some([q - bound, q + bound])
}

/// The error of quotients of at most `size`, and of the ends of an interval around them, given one over the
/// divisors: for those whose divisor is known to a quarter, and that err by up to four roundoffs of `size`.
#[inline(always)]
pub(crate) fn lost_in_row<Q: Quad<Lane = f64>>(size: Q, inverse: Q, [error, other]: [f64; 2]) -> Q {
    let twice = inverse.magnitude() * Q::splat(2.0);
    let bound = (Q::splat(error) + size * Q::splat(other)) * twice;
    bound + (bound + size) * Q::splat(1.0.error(ENDS))
}

/// Pairs of numbers that enclose the coordinates of a + v·num/den, likewise. The components of v err
/// by a roundoff of themselves and `of_v`.
#[inline(always)]
pub(super) fn enclosed_on_line<F: Float>(
    a: &[F; 3],
    v: &[F; 3],
    num: F,
    den: F,
    (of_v, error, other): (F, F, F),
) -> Option<[[F; 2]; 3]> {
    let [t, bound] = quotient(num, den, [error, other])?;
    let of_v = of_v * (t.magnitude() + bound);
    Some(three(|i| {
        let step = v[i] * t;
        let x = a[i] + step;
        let error = v[i].magnitude() * bound + of_v;
        let error = error + (error + step.magnitude() + x.magnitude()).error(ENDS_ON_LINE);
        [x - error, x + error]
    }))
}
