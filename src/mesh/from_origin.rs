//! Bounds of the squared distance of a triangle from the origin, in `f64`, at any precision of the
//! closest point.
//!
//! Let x be the vertices as given, each component within a roundoff u of itself, R the greatest of
//! their magnitudes, and q a point computed as Σ w·x, with weights w in [0, 1] of the usual regions.
//! How accurate the weights are does not matter:
//! - No point p of the triangle is nearer than the plane through q at right angles to q: |p|² ≥ 2·q·p
//!   − |q|², for |p − q|² ≥ 0. The right side is least at a vertex. Of three terms of q·x, with Q the
//!   greatest magnitude in q, each errs by 4 roundoffs of Q·R, twice; three of |q|² by 3; the
//!   difference, of up to 9·Q·R, by 1. That makes 42.
//! - With s = Σ w, the point Σ w·x/s lies in the triangle. It is up to |s − 1|·R from Σ w·x. The
//!   three terms of q err by 4 roundoffs of R each, s by 5, and s − 1 by 3. That makes 20.
//!
//! `from_origin.g` proves these two, the last roundings included. Squares and their sums, which are
//! not negative, err by 7 roundoffs of themselves. Underflow is below [`Number::UNDERFLOW`].

use crate::arithmetic::{Number, dot3, greatest, largest, least, three};

/// Roundoffs of Q·R in the lower bound.
const BEYOND: u16 = 56;
/// Roundoffs of R in a component of q.
const AT: u16 = 28;
/// Roundoffs of a sum of squares, of itself, and of the upper bound.
const SQUARES: u16 = 8;

type Vector = [f64; 3];

/// A lower bound of the squared distance, by the bounding box.
#[inline(always)]
pub(super) fn beyond_box([a, b, c]: &[Vector; 3]) -> f64 {
    let gap = three(|i| {
        let low = least(least(a[i], b[i]), c[i]);
        let high = greatest(greatest(a[i], b[i]), c[i]);
        greatest(greatest(low, -high), 0.0)
    });
    let square = dot3(&gap, &gap);
    square - square.error(SQUARES) - f64::UNDERFLOW
}

/// Two numbers that enclose the squared distance; the second may be infinite.
#[inline(always)]
pub(super) fn enclosing([a, b, c]: &[Vector; 3]) -> [f64; 2] {
    let [u, v, w] = weights(a, b, c);
    let q = three(|i| u * a[i] + v * b[i] + w * c[i]);
    let size = greatest(greatest(largest(a), largest(b)), largest(c));
    let sum = q[0].abs() + q[1].abs() + q[2].abs();
    let square = dot3(&q, &q);
    let along = least(least(dot3(&q, a), dot3(&q, b)), dot3(&q, c));
    let low = along + along - square - (largest(&q) * size).error(BEYOND) - f64::UNDERFLOW;
    let off = ((u + v + w) - 1.0).abs() * size + size.error(AT) + f64::UNDERFLOW;
    let high = square + off * (sum + sum + 3.0 * off);
    let high = high + high.error(SQUARES) + f64::UNDERFLOW;
    // After an overflow some number is infinite or NaN.
    if high < f64::INFINITY && low < f64::INFINITY {
        [greatest(low, 0.0), high]
    } else {
        [0.0, f64::INFINITY]
    }
}

/// A number as a weight: from zero to `most`; zero for NaN.
#[inline(always)]
fn weight(x: f64, most: f64) -> f64 {
    least(greatest(x, 0.0), most)
}

/// The weights of the vertices in the point closest to the origin, approximately, with a sum of
/// about one (C. Ericson, *Real-Time Collision Detection*, 2005, section 5.1.5).
#[inline(always)]
fn weights(a: &Vector, b: &Vector, c: &Vector) -> Vector {
    let (e, f) = (three(|i| b[i] - a[i]), three(|i| c[i] - a[i]));
    let (ea, fa) = (-dot3(&e, a), -dot3(&f, a));
    if ea <= 0.0 && fa <= 0.0 {
        return [1.0, 0.0, 0.0];
    }
    let (eb, fb) = (-dot3(&e, b), -dot3(&f, b));
    if eb >= 0.0 && fb <= eb {
        return [0.0, 1.0, 0.0];
    }
    let of_c = ea * fb - eb * fa;
    if of_c <= 0.0 && ea >= 0.0 && eb <= 0.0 {
        let t = weight(ea / (ea - eb), 1.0);
        return [1.0 - t, t, 0.0];
    }
    let (ec, fc) = (-dot3(&e, c), -dot3(&f, c));
    if fc >= 0.0 && ec <= fc {
        return [0.0, 0.0, 1.0];
    }
    let of_b = ec * fa - ea * fc;
    if of_b <= 0.0 && fa >= 0.0 && fc <= 0.0 {
        let t = weight(fa / (fa - fc), 1.0);
        return [1.0 - t, 0.0, t];
    }
    let of_a = eb * fc - ec * fb;
    let (to_c, to_b) = (fb - eb, ec - fc);
    if of_a <= 0.0 && to_c >= 0.0 && to_b >= 0.0 {
        let t = weight(to_c / (to_c + to_b), 1.0);
        return [0.0, 1.0 - t, t];
    }
    let inverse = 1.0 / (of_a + of_b + of_c);
    let v = weight(of_b * inverse, 1.0);
    let w = weight(of_c * inverse, 1.0 - v);
    [1.0 - v - w, v, w]
}
