//! The direction of a normal in floats, right however thin the triangle.
//!
//! Three stages, the next only where the last is in doubt: the plain cross product,
//! the same in pairs of floats, and exact sums.

use core::cmp::Ordering;

use crate::linear::pick;
use crate::robust::ExactTriangle;
use crate::scalar::{ExactSum, Scalar};
use crate::shape::Triangle;

/// A number as the unevaluated sum of a float and a much smaller one.
type Pair = (f64, f64);

/// Coordinates in this range, or nought, multiply without overflow and without
/// underflow, the lowest bits of products of their differences included. Every
/// `f32` is in it.
const RANGE: (f64, f64) = (f64::from_bits((1023 - 400) << 52), f64::from_bits((1023 + 250) << 52));

/// A vector along the normal; `None` if the triangle is degenerate.
///
/// Each component is within 1.01 roundoffs of the truth, relative to itself, or within
/// 5·`enough` where the plain cross product is no smaller than its terms by more than
/// that factor, and is taken; with `enough` nought it never is.
/// Its squares neither overflow nor, but where they do not matter, underflow.
pub(crate) fn direction(t: &Triangle<f64>, enough: f64) -> Option<[f64; 3]> {
    let points = t.points();
    let tame = |x: f64| x == 0.0 || (x.abs() > RANGE.0 && x.abs() < RANGE.1);
    if points.as_flattened().iter().all(|&x| tame(x)) {
        let [a, b, c] = points;
        let n = |j: usize, k: usize| component([a[j], b[j], c[j]], [a[k], b[k], c[k]], enough);
        if let (Some(x), Some(y), Some(z)) = (n(1, 2), n(2, 0), n(0, 1)) {
            let size = x.abs() + y.abs() + z.abs();
            if size == 0.0 {
                return None;
            }
            if size > RANGE.0 {
                return Some([x, y, z]);
            }
        }
    }
    by_sums(t)
}

/// (b₀ − a₀)·(c₁ − a₁) − (b₁ − a₁)·(c₀ − a₀), if floats can vouch for it.
#[inline]
fn component([a0, b0, c0]: [f64; 3], [a1, b1, c1]: [f64; 3], enough: f64) -> Option<f64> {
    let (p, q) = ((b0 - a0) * (c1 - a1), (b1 - a1) * (c0 - a0));
    let size = p.abs() + q.abs();
    let n = p - q;
    // Nothing underflows: a product of nought is nought. Otherwise each product is
    // off by up to 3 roundoffs, and the difference by one.
    if size == 0.0 || n.abs() * enough >= size {
        return Some(n);
    }
    let (e, f) = (difference(b0, a0), difference(c1, a1));
    let (g, h) = (difference(b1, a1), difference(c0, a0));
    let (p, q) = (product(e, f), product(g, h));
    let (high, low) = difference(p.0, q.0);
    let n = high + (low + (p.1 - q.1));
    // What a pair leaves out is below 16 squared roundoffs, 2^-102, of p and q: not
    // 2^-8 roundoffs of n if cancellation took no more than 40 places. Nought is nought
    // if nothing is left out, as when the differences needed no second float.
    let exact = e.1 == 0.0 && f.1 == 0.0 && g.1 == 0.0 && h.1 == 0.0;
    (n.abs() >= size * TWO_TO_THE_MINUS_40 || (exact && p == q)).then_some(n)
}

const TWO_TO_THE_MINUS_40: f64 = f64::from_bits((1023 - 40) << 52);

/// a − b, exactly (D. E. Knuth, *The Art of Computer Programming* 2, 4.2.2).
#[inline]
fn difference(a: f64, b: f64) -> Pair {
    let d = a - b;
    let of_b = a - d;
    let of_a = d + of_b;
    (d, (a - of_a) + (of_b - b))
}

/// The product of two pairs, but for what is far below the last place; exactly if
/// the smaller parts are nought (T. J. Dekker, "A floating-point technique for
/// extending the available precision", 1971).
#[inline]
fn product(a: Pair, b: Pair) -> Pair {
    let p = a.0 * b.0;
    let ((a1, a2), (b1, b2)) = (halves(a.0), halves(b.0));
    let rest = ((a1 * b1 - p) + a1 * b2 + a2 * b1) + a2 * b2;
    (p, rest + (a.0 * b.1 + a.1 * b.0))
}

/// The upper and the lower half of the digits.
#[inline]
fn halves(x: f64) -> Pair {
    let shifted = x * 134_217_729.0; // 2^27 + 1
    let high = shifted - (shifted - x);
    (high, x - high)
}

/// The same by exact sums, for any input: the components over the greatest of them.
#[cold]
#[inline(never)]
fn by_sums(t: &Triangle<f64>) -> Option<[f64; 3]> {
    let exact = ExactTriangle::new(&t.points());
    let sums = [0, 1, 2].map(|i| exact.normal_sum::<f64>(i));
    let sign = |i: usize| pick(&sums, i).sign();
    let ratio = |i: usize, k: usize| f64::quotient(pick(&sums, i), pick(&sums, k));
    let mut greatest = (0..3).find(|&i| sign(i) != Ordering::Equal)?;
    for i in greatest + 1..3 {
        if ratio(i, greatest).abs() > 1.0 {
            greatest = i;
        }
    }
    let mut n = [ratio(0, greatest), ratio(1, greatest), ratio(2, greatest)];
    if sign(greatest) == Ordering::Less {
        n = [-n[0], -n[1], -n[2]];
    }
    Some(n)
}
