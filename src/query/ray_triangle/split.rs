//! Vectors of `f64` cut in two parts at a grid: the higher part is so short that its products are
//! exact.

use core::ops::{Add, Mul, Sub};

use crate::arithmetic::fast_two_sum;

/// The size of the lower part of a number, relative to the size that sets the grid: 2^-25.
pub(super) const CUT: f64 = 1.0 / 33_554_432.0;

/// 2^28: `far` of [`cut`] for the 25 bits of a [`Split`].
pub(super) const FAR: f64 = 268_435_456.0;

/// Two numbers that undergo the same operations: every vector unit has room for two.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Two(pub(super) [f64; 2]);

macro_rules! operators {
    ($($operator:ident: $function:ident;)*) => {$(
        impl $operator for Two {
            type Output = Self;
            #[inline(always)]
            fn $function(self, other: Self) -> Self {
                Self([self.0[0].$function(other.0[0]), self.0[1].$function(other.0[1])])
            }
        }
    )*};
}
operators! { Add: add; Sub: sub; Mul: mul; }

impl Two {
    #[inline(always)]
    fn swapped(self) -> Self {
        Self([self.0[1], self.0[0]])
    }

    #[inline(always)]
    fn magnitude(self) -> Self {
        Self([self.0[0].abs(), self.0[1].abs()])
    }
}

/// x + `rest` in two parts, the higher on a coarse grid that contains `far`, which is 2^k times a
/// bound s on |x|, 2 ≤ k ≤ 51.
///
/// far + x lies in [far − s, far + s]. The last place g of the sum is at least that of far − s. So
/// the sum is a multiple of g, far is too, and their difference is exact. Hence the higher part is
/// a multiple of g no greater than s + g. With 2^53·g > far − s this gives s/g < 2^53/(2^k − 1) <
/// 2^(53−k) + 1. The higher part differs from x by at most half the last place of far + s, which is
/// little more than 2^(k−53)·s.
#[inline(always)]
pub(super) fn cut<T>([x, rest]: [T; 2], far: T) -> [T; 2]
where
    T: Copy + Add<Output = T> + Sub<Output = T>,
{
    let high = (x + far) - far;
    [high, (x - high) + rest]
}

/// A vector of [`Two`], with each component as given, and in two parts.
#[derive(Clone, Copy)]
pub(super) struct Split {
    whole: [Two; 3],
    high: [Two; 3],
    low: [Two; 3],
}

impl Split {
    /// Each component and its rounding error, in two parts; see [`cut`].
    #[inline(always)]
    pub(super) fn new([x, y, z]: [[Two; 2]; 3], far: Two) -> Self {
        let whole = [x[0], y[0], z[0]];
        let [x, y, z] = [cut(x, far), cut(y, far), cut(z, far)];
        Self { whole, high: [x[0], y[0], z[0]], low: [x[1], y[1], z[1]] }
    }

    /// The size of the lower parts: zero if the higher parts are exact.
    #[inline(always)]
    pub(super) fn lost(&self) -> f64 {
        let [x, y, z] = self.low;
        let Two([a, b]) = x.magnitude() + y.magnitude() + z.magnitude();
        a + b
    }

    /// The cross product in two parts; the higher part is exact.
    #[inline(always)]
    pub(super) fn cross(&self, other: &Self) -> [[Two; 2]; 3] {
        let (a, b) = (self, other);
        let high = |j: usize, k: usize| a.high[j] * b.high[k] - a.high[k] * b.high[j];
        let mixed = |j: usize, k: usize| a.high[j] * b.low[k] + a.low[j] * b.whole[k];
        let minor = |j: usize, k: usize| [high(j, k), mixed(j, k) - mixed(k, j)];
        [minor(1, 2), minor(2, 0), minor(0, 1)]
    }

    /// The dot product with areas whose higher parts are short, in two parts: the exact product of
    /// the higher parts, and the rest.
    #[inline(always)]
    pub(super) fn dot(&self, areas: &[[Two; 2]; 3]) -> [Two; 2] {
        let exact = |i: usize| areas[i][0] * self.high[i];
        let rest = |i: usize| areas[i][1] * self.whole[i] + areas[i][0] * self.low[i];
        fast_two_sum(exact(0) + exact(1) + exact(2), rest(0) + rest(1) + rest(2))
    }
}

/// Areas in two parts, the higher part shortened by [`cut`], and the two numbers swapped.
#[inline(always)]
pub(super) fn short_areas([x, y, z]: [[Two; 2]; 3], far: Two) -> [[Two; 2]; 3] {
    let short = |area: [Two; 2]| cut(area, far).map(Two::swapped);
    [short(x), short(y), short(z)]
}
