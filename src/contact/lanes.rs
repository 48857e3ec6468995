//! A number for each of several directions, in one word or side by side.

use core::ops::{Add, Div, Mul, Sub};

use super::filter::Measure;
use crate::arithmetic::{Quad, greatest, least};

/// A number for each of several directions: a float, or four as hosts have them. Comparisons with NaN
/// are false.
pub(super) trait Lanes:
    Copy + Add<Output = Self> + Sub<Output = Self> + Mul<Output = Self> + Div<Output = Self>
{
    type Lane: Measure;
    /// Numbers of 16 directions or more, against them and along them.
    type All: AsRef<[[Self; 2]]> + AsMut<[[Self; 2]]>;
    /// How many.
    const COUNT: usize;

    fn all(all: [Self; 2]) -> Self::All;
    fn of(lane: impl Fn(usize) -> Self::Lane) -> Self;
    fn lane(self, n: usize) -> Self::Lane;
    fn size(self) -> Self;
    fn most(self, other: Self) -> Self;
    fn least(self, other: Self) -> Self;
    /// The lanes in which this is the greater, as bits.
    fn is_above(self, other: Self) -> u32;
    /// The lanes in which this is at most `other`.
    fn is_within(self, other: Self) -> u32;

    #[inline(always)]
    fn same(x: Self::Lane) -> Self {
        Self::of(|_| x)
    }
}

impl Lanes for f64 {
    type Lane = Self;
    type All = [[Self; 2]; 16];
    const COUNT: usize = 1;

    fn all(all: [Self; 2]) -> Self::All {
        [all; 16]
    }
    #[inline(always)]
    fn of(lane: impl Fn(usize) -> Self) -> Self {
        lane(0)
    }
    #[inline(always)]
    fn lane(self, _: usize) -> Self {
        self
    }
    #[inline(always)]
    fn size(self) -> Self {
        self.abs()
    }
    #[inline(always)]
    fn most(self, other: Self) -> Self {
        greatest(self, other)
    }
    #[inline(always)]
    fn least(self, other: Self) -> Self {
        least(self, other)
    }
    #[inline(always)]
    fn is_above(self, other: Self) -> u32 {
        (self > other).into()
    }
    #[inline(always)]
    fn is_within(self, other: Self) -> u32 {
        (self <= other).into()
    }
}

impl<Q: Quad<Lane: Measure>> Lanes for Q {
    type Lane = Q::Lane;
    type All = [[Self; 2]; 4];
    const COUNT: usize = 4;

    #[inline(always)]
    fn all(all: [Self; 2]) -> Self::All {
        [all; 4]
    }
    #[inline(always)]
    fn of(lane: impl Fn(usize) -> Q::Lane) -> Self {
        Q::new([lane(0), lane(1), lane(2), lane(3)])
    }
    #[inline(always)]
    fn lane(self, n: usize) -> Q::Lane {
        self.to_array()[n % 4]
    }
    #[inline(always)]
    fn size(self) -> Self {
        self.magnitude()
    }
    #[inline(always)]
    fn most(self, other: Self) -> Self {
        self.greatest(other)
    }
    #[inline(always)]
    fn least(self, other: Self) -> Self {
        Quad::least(self, other)
    }
    #[inline(always)]
    fn is_above(self, other: Self) -> u32 {
        self.exceeds(other)
    }
    #[inline(always)]
    fn is_within(self, other: Self) -> u32 {
        self.is_at_most(other)
    }
}

#[cfg(test)]
mod tests {
    use crate::arithmetic::{OfFour, three, two};
    use crate::contact::body::{Rough, cross, dot};
    use crate::contact::filter::{Measure, Ruler};
    use crate::contact::lanes::Lanes;
    use crate::random::Random;

    /// The square of a direction that `f32` knows is that of the sides in `f64`, within its spread: of
    /// sides as nearly parallel as it allows, and of all others.
    #[test]
    fn squares_in_f32_are_within_their_spread() {
        let mut random = Random(0x50ea);
        let mut number = || f64::from(random.bits() as i32) * 2_f64.powi(-31);
        let mut known = [0; 2];
        for n in 0..40_000 {
            let (x, by, off) = (three(|_| number()), number(), 2_f64.powi(-(n % 14)));
            let y = three(|i| by * x[i] + off * number());
            let rough = |side| Rough {
                is_triangle: false,
                at: [[0.0; 3]; 3],
                sides: [side; 3],
                half: [1.0; 3],
            };
            let shapes = [rough(x), rough(y)];
            let short = two(|k| shapes[k].short());
            let ruler = Ruler::new(&short);
            let found = ruler.measured::<<f32 as OfFour>::Quad>(|_| [0, 3]);
            if ruler.known(found.scale, found.square) & 1 == 0 {
                continue;
            }
            let (square, scale) = (found.square.lane(0), found.scale.lane(0));
            let is_noisy = scale * scale > 16.0 * square;
            let spread = if is_noisy { f32::SPREAD } else { f32::LEAST_SPREAD };
            let a = cross(&x, &y);
            let truth = dot(&a, &a);
            assert!((f64::from(square) - truth).abs() <= f64::from(spread) * truth, "{x:?} {y:?}");
            known[usize::from(is_noisy)] += 1;
        }
        assert!(known[0] > 8_000 && known[1] > 8_000, "{known:?}");
    }
}
