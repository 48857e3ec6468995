//! The direction of a normal in floats, right for the thinnest triangles too.
//!
//! Three stages, the next only where the last is in doubt: the plain cross product,
//! the same in double-word floats, and integers.

use core::cmp::Ordering;

use crate::arithmetic::{Double, Embeds, FullF64, cross, exp2, pick, quotient, three};
use crate::shape::Triangle;

/// Coordinates that are zero or in this range multiply without overflow and without underflow; so
/// do their differences, including the lowest bits of the products. Every `f32` is in the range.
const RANGE: (f64, f64) = (exp2(-400), exp2(250));

/// A vector along the normal; `None` if the triangle is degenerate.
///
/// Each component is within 1.01 roundoffs of the truth, relative to itself. If cancellation makes
/// a plain cross product smaller than its terms by at most the factor `enough`, the plain one is
/// returned and is within 5·`enough` roundoffs; with `enough` zero it never is. The squares of the
/// components do not overflow, and they underflow only if they do not matter.
pub(crate) fn direction(t: &Triangle<f64>, enough: f64) -> Option<[f64; 3]> {
    let points = t.points();
    if points.as_flattened().iter().all(|&x| is_in_range(x)) {
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
    by_integers(t)
}

fn is_in_range(x: f64) -> bool {
    x == 0.0 || (x.abs() > RANGE.0 && x.abs() < RANGE.1)
}

/// (b₀ − a₀)·(c₁ − a₁) − (b₁ − a₁)·(c₀ − a₀), if floats are certain of it.
#[inline]
fn component([a0, b0, c0]: [f64; 3], [a1, b1, c1]: [f64; 3], enough: f64) -> Option<f64> {
    let (p, q) = ((b0 - a0) * (c1 - a1), (b1 - a1) * (c0 - a0));
    let size = p.abs() + q.abs();
    let n = p - q;
    // Nothing underflows: a product of zero is zero. In all other cases each product is off by up
    // to 3 roundoffs, and the difference by one.
    if size == 0.0 || n.abs() * enough >= size {
        return Some(n);
    }
    let (e, f) = (Double::difference(b0, a0), Double::difference(c1, a1));
    let (g, h) = (Double::difference(b1, a1), Double::difference(c0, a0));
    let (p, q) = (e.product(f), g.product(h));
    let Double { high, low } = Double::difference(p.high, q.high);
    let n = high + (low + (p.low - q.low));
    // Double words leave out less than 16 squared roundoffs, 2^-102, of p and q. If cancellation
    // takes at most `PLACES`, that is below 2^-8 roundoffs of n. A zero is certain if nothing is
    // left out, which is so if the differences needed no second float.
    let exact = [e, f, g, h].iter().all(|x| x.low == 0.0);
    (n.abs() >= size * LEFT || (exact && p == q)).then_some(n)
}

/// The places that cancellation may take. `direction.g` proves it.
const PLACES: i32 = 40;

/// The relative size that then remains.
const LEFT: f64 = exp2(-PLACES);

/// The same by integers, for any input: the components over the greatest component.
#[cold]
#[inline(never)]
fn by_integers(t: &Triangle<f64>) -> Option<[f64; 3]> {
    let [a, b, c] = FullF64::embed_held(&t.points());
    let (e, f) = (three(|i| b[i] - a[i]), three(|i| c[i] - a[i]));
    let components = cross::<FullF64>(&e, &f);
    let sign = |i: usize| pick(&components, i).sign();
    let ratio = |i: usize, k: usize| -> f64 {
        quotient(pick(&components, i).sign_magnitude(), pick(&components, k).sign_magnitude())
    };
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

#[cfg(test)]
mod tests {
    use super::{component, is_in_range};
    use crate::arithmetic::Each;

    /// 2^e.
    fn two_to(e: i32) -> f64 {
        (0..e.unsigned_abs()).fold(1.0, |x, _| if e < 0 { x / 2.0 } else { x * 2.0 })
    }

    // A doubt of floats goes to the last stage: as right, and slow.

    #[test]
    fn floats_take_what_is_neither_vast_nor_tiny() {
        for x in [0.0, 1.0, -3.5, two_to(-399), -two_to(249), f32::MAX.into()] {
            assert!(is_in_range(x), "{x}");
        }
        for x in [two_to(-400), -two_to(-401), two_to(250), -f64::MAX, f64::MIN_POSITIVE] {
            assert!(!is_in_range(x), "{x}");
        }
    }

    /// The component for the points (0, 0), (x, y) and (1, s).
    fn of(x: f64, y: f64, s: f64) -> Option<f64> {
        component([0.0, x, 1.0], [0.0, y, s], 0.0)
    }

    #[test]
    fn floats_vouch_for_what_forty_places_of_cancellation_leave() {
        let slope = 1.0 / 3.0;
        assert_eq!(of(1.0, slope, slope + two_to(-30)), Some(two_to(-30)));
        assert_eq!(of(1.0, slope, slope + two_to(-45)), None);
        // Zero is certain if nothing was left out: whole numbers on a line.
        assert_eq!(of(3.0, 6.0, 2.0), Some(0.0));
        // Each of the four differences in turn does not fit a float, so a zero is in doubt.
        for k in 0..4 {
            let (mut a, mut b, mut c) = ([0.0; 2], [1.0; 2], [1.0; 2]);
            let tiny = two_to(-80);
            match k {
                0 => (a[0], b[0]) = (tiny, 1.0),
                1 => (a[1], c[1]) = (tiny, 1.0),
                2 => (b[1], a[1]) = (1.0, -tiny),
                _ => (c[0], a[0]) = (1.0, -tiny),
            }
            let [x, y] = [0, 1].each(|i| [a[i], b[i], c[i]]);
            assert_eq!(component(x, y, 0.0), None, "{x:?}, {y:?}");
        }
    }
}
