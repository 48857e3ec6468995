//! The side of an edge on which a point lies, seen along the normal, in words of 32 bits: for cores
//! where floats are functions. It is certain or in doubt, and then floats decide.

use core::mem::size_of;

use crate::arithmetic::{Each, REGISTERS_ARE_WIDE, cut, exponent, product};
use crate::scalar::Scalar;

/// Two coordinates across the normal, in multiples of the unit, rounded toward zero.
pub(super) type Flat = [i32; 2];

/// The unit of words: a power of two between 2^-28 and 2^-27 of the size of the shapes. Coordinates are
/// below √3 times the size.
#[derive(Clone, Copy)]
pub(super) struct Unit(i32);

impl Unit {
    /// The unit for shapes of this size, if all numbers of the scalar are within the range of `f64` by
    /// far, and the core computes them by functions.
    pub(super) fn new<S: Scalar>(size: f64) -> Option<Self> {
        let is_short = size_of::<S>() < size_of::<f64>();
        (!REGISTERS_ARE_WIDE && is_short && size > 0.0).then(|| Self::of(size))
    }

    /// The same on any machine.
    pub(super) fn of(size: f64) -> Self {
        Self(exponent(size) - 27)
    }

    /// In units, rounded toward zero.
    #[inline(never)]
    pub(super) fn flat(self, x: &[f64; 2]) -> Flat {
        x.each(|x| cut(x, self.0))
    }
}

/// One if the point is to the left of the edge from p to q, minus one if it is to the right, and zero
/// in doubt.
///
/// A coordinate errs by less than one, and so each difference by less than two. The two products err
/// by less than twice the sum of all differences, and eight. A side is certain above three times that sum, and
/// eight. The truth is then above the sum, and the sum is above the edge's length: the point is off the line
/// by more than one, 2^-28 of the size. A point that is closer to the edge's line than the tolerance, 2^-17 units, or than floats
/// know, is in doubt by far.
pub(super) fn side(p: &Flat, q: &Flat, to: &Flat) -> i8 {
    let [a, b] = [q[0] - p[0], q[1] - p[1]];
    let [c, d] = [to[0] - p[0], to[1] - p[1]];
    // Nearly always half words suffice. Each difference is below 2^30, and errs by less than two units and,
    // cut to 2^15 units, by less than two of these; products differ by less than 2^31.
    let [e, f, g, h] = [a, b, c, d].each(|x| x >> 15);
    let (short, sizes) = (e * h - f * g, e.abs() + f.abs() + g.abs() + h.abs());
    if short.abs() > 2 * sizes + 8 {
        return if short > 0 { 1 } else { -1 };
    }
    let side = product(a, d) - product(b, c);
    let sizes = [a, b, c, d].each(|x| i64::from(x.unsigned_abs()));
    let margin = 3 * (sizes[0] + sizes[1] + sizes[2] + sizes[3]) + 8;
    i8::from(side > margin) - i8::from(side < -margin)
}

#[cfg(test)]
mod tests {
    use super::{Flat, Unit, side};
    use crate::arithmetic::Each;
    use crate::random::Random;

    /// Against whole numbers of 2^-10 units, half of them near the line.
    #[test]
    fn a_certain_side_is_right() {
        let mut random = Random(0x51de);
        let mut coordinate = || (random.bits() as i64) >> 25;
        let cut = |x: [i64; 2]| -> Flat { x.each(|x| (x / 1024) as i32) };
        let mut certain = 0;
        for n in 0..20_000 {
            let [p, q, mut to] = [(); 3].each(|()| [coordinate(), coordinate()]);
            if n % 2 == 0 {
                let s = coordinate();
                to = [0, 1].each(|i| {
                    let way = (i128::from(q[i] - p[i]) * i128::from(s)) >> 38;
                    p[i] + way as i64 + (coordinate() >> (20 + n % 19))
                });
            }
            let [a, b] = [q, to].each(|x| [0, 1].each(|i| i128::from(x[i] - p[i])));
            let area = a[0] * b[1] - a[1] * b[0];
            let truth = area.signum() as i8;
            let length = ((a[0] * a[0] + a[1] * a[1]) as f64).sqrt();
            let found = side(&cut(p), &cut(q), &cut(to));
            let is_off = area.abs() as f64 > 1024.0 * length;
            assert!(found == 0 || (found == truth && is_off), "{p:?} {q:?} {to:?}");
            certain += u32::from(found != 0);
        }
        assert!((10_000..18_000).contains(&certain), "{certain}");
    }

    #[test]
    fn numbers_are_cut_toward_zero() {
        let unit = Unit(1023 - 27);
        for x in [0.0, -0.0, 1.0, -1.0, 1.7, 1e-9, -1e-300, f64::MIN_POSITIVE / 4.0] {
            assert_eq!(unit.flat(&[x, -x]), [1.0, -1.0].each(|s| (s * x * 2_f64.powi(27)) as i32));
        }
    }
}
