//! The quotient of an integer and a root, digit by digit: no float, no division, and correct to the
//! last place.

use core::ops::Add;

use super::big_int::BigInt;
use super::limbs::{Limbs, Wide};

/// An unsigned integer for [`over_root`]; its default is zero. Sums fit.
pub trait Square: Wide + Default + Add<Output = Self> {
    /// A narrower type for small numbers, or the type itself.
    type Narrow: Square;
    /// The number in a narrower type, if it leaves `room` bits there.
    fn narrowed(self, room: u32) -> Option<Self::Narrow>;
}

impl Square for u64 {
    type Narrow = Self;

    #[inline(always)]
    fn narrowed(self, _: u32) -> Option<Self> {
        None
    }
}

impl Square for u128 {
    type Narrow = u64;

    #[inline(always)]
    fn narrowed(self, room: u32) -> Option<u64> {
        (self.leading_zeros() >= 64 + room).then_some(self as u64)
    }
}

impl<const L: usize> Limbs<L> {
    /// The number x·2^(64·k) with the halves of x as its limbs.
    #[inline(always)]
    pub(crate) fn new(x: u128, k: usize) -> Self {
        let mut limbs = [0; L];
        for (limb, word) in limbs.iter_mut().skip(k).zip([x as u64, (x >> 64) as u64]) {
            *limb = word;
        }
        Self(limbs)
    }
}

impl<const L: usize> Default for Limbs<L> {
    fn default() -> Self {
        Self([0; L])
    }
}

impl<const L: usize> Add for Limbs<L> {
    type Output = Self;

    #[inline(always)]
    fn add(self, other: Self) -> Self {
        let BigInt(sum) = BigInt(self.0) + BigInt(other.0);
        Self(sum)
    }
}

impl<const L: usize> Square for Limbs<L> {
    type Narrow = u128;

    #[inline(always)]
    fn narrowed(self, room: u32) -> Option<u128> {
        let (low, high) = self.0.split_first_chunk::<2>()?;
        let low = u128::from(low[1]) << 64 | u128::from(low[0]);
        (high.iter().all(|&x| x == 0) && low.leading_zeros() >= room).then_some(low)
    }
}

/// √(x / sum)·2^`places` for each x of `squares` and their sum, which is not zero. The result is
/// the nearest integer, at most the greatest `u64`. `W` has room for the sum times 2^(`places` +
/// 3).
pub(crate) fn over_roots<W: Square>(squares: [W; 3], places: u32) -> [u64; 3] {
    let [x, y, z] = squares;
    let norm = x + y + z;
    if norm.narrowed(places + 3).is_some() {
        if let (Some(x), Some(y), Some(z)) = (x.narrowed(0), y.narrowed(0), z.narrowed(0)) {
            return over_roots([x, y, z], places);
        }
    }
    let mut roots = [0; 3];
    for (root, square) in roots.iter_mut().zip(squares) {
        *root = over_root(square, norm, places);
    }
    roots
}

/// √(`square` / `norm`)·2^`places` to the nearest integer.
///
/// The digit-by-digit square root of a quotient that is never divided out. After j places, p =
/// ⌊√(square/norm)·2^j⌋ is stored as `root` = 2·p·norm, with the remainder `rest` = square·4^j −
/// p²·norm. The next place is 1 if 4·rest ≥ (2p + 1)²·norm − (2p)²·norm = 2·root + norm.
#[inline(always)]
fn over_root<W: Square>(square: W, norm: W, places: u32) -> u64 {
    if square == norm {
        return 1_u64.checked_shl(places).unwrap_or(u64::MAX);
    }
    let (mut rest, mut root, mut p) = (square, W::default(), 0_u64);
    for _ in 0..places {
        rest.double();
        rest.double();
        root.double();
        p <<= 1;
        let step = root + norm;
        if rest >= step {
            rest.subtract(&step);
            root = step + norm;
            p |= 1;
        }
    }
    // The place after the last decides the rounding. There are no ties: if the root is a fraction,
    // its denominator is odd. In a² + b² + c² = d² without a common factor d is odd, because
    // otherwise all four squares would be divisible by 4.
    rest.double();
    rest.double();
    root.double();
    let up = rest >= root + norm;
    p.saturating_add(up.into())
}

/// An integer as sign and magnitude. It has one bit more than two's complement of the same width,
/// and normals need that bit.
#[derive(Clone, Copy, Debug)]
pub struct Signed<M> {
    pub(crate) negative: bool,
    pub(crate) magnitude: M,
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::arithmetic::Each;

    #[test]
    fn every_width_agrees_with_the_definition() {
        for norm in 1_u64..=60 {
            for square in 0..=norm {
                for places in 0..12 {
                    let p = over_root(square, norm, places);
                    // (2p − 1)²·norm < 4·square·4^places < (2p + 1)²·norm
                    let four = square << (2 * places + 2);
                    let odd = |x: u64| x * x * norm;
                    // Only squares of rationals may lie halfway, and they round up.
                    assert!(four < odd(2 * p + 1), "{square} {norm} {places}");
                    assert!(p == 0 || four >= odd(2 * p - 1), "{square} {norm} {places}");
                    let wide = |x: u64| Limbs::<6>::new(u128::from(x) << 40, 2);
                    assert_eq!(p, over_root(u128::from(square), norm.into(), places));
                    assert_eq!(p, over_root(wide(square), wide(norm), places));
                    let squares = [square, norm - square, 0].each(wide);
                    assert_eq!(p, over_roots(squares, places)[0]);
                }
            }
        }
    }

    #[test]
    fn limbs_carry() {
        let all = Limbs([u64::MAX, u64::MAX, u64::MAX, 0]);
        let one = Limbs([1, 0, 0, 0]);
        let next = Limbs([0, 0, 0, 1]);
        let mut twice = all;
        twice.double();
        assert_eq!((all + one, all + all), (next, twice));
        assert_eq!((all.narrowed(0), next.narrowed(0)), (None, None));
        assert_eq!((one.narrowed(127), one.narrowed(128)), (Some(1), None));
    }
}
