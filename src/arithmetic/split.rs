//! Numbers of `f64` in two parts, the higher so short that products of it are exact;
//! two at a time, for that is what every vector unit has room for.

use core::ops::{Add, Mul, Sub};

/// Two numbers, on which the same is done.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Two(pub(crate) [f64; 2]);

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

/// a + b without loss where |a| ≥ |b|: the sum as rounded, and what the rounding took.
///
/// T. J. Dekker, "A Floating-Point Technique for Extending the Available Precision",
/// *Numerische Mathematik* 18, 1971.
#[inline(always)]
fn fast_two_sum(a: Two, b: Two) -> [Two; 2] {
    let sum = a + b;
    [sum, (a - sum) + b]
}

/// a − b without loss: the difference as rounded, and what the rounding took.
///
/// D. E. Knuth, *The Art of Computer Programming*, volume 2, 4.2.2, theorem B.
#[inline(always)]
pub(crate) fn two_difference<T>(a: T, b: T) -> [T; 2]
where
    T: Copy + Add<Output = T> + Sub<Output = T>,
{
    let difference = a - b;
    let of_b = a - difference;
    [difference, (a - (difference + of_b)) + (of_b - b)]
}

/// Two to the 28.
pub(crate) const FAR: f64 = 268_435_456.0;

/// x on a coarse grid, of which `far` is a point: 2^k times a bound s on |x|, 2 ≤ k ≤ 51.
///
/// far + x lies in [far − s, far + s]. Its last place g is at least that of far − s, so the
/// sum is a multiple of g, far is one too, and their difference is exact. So the
/// result is a multiple of g no greater than s + g, where
/// 2^53·g > far − s, hence s/g < 2^53/(2^k − 1) < 2^(53−k) + 1; and it is no farther from
/// x than half the last place of far + s, hence than 2^(k−53)·s and a trifle.
#[inline(always)]
fn shortened<T>(x: T, far: T) -> T
where
    T: Copy + Add<Output = T> + Sub<Output = T>,
{
    (x + far) - far
}

/// A vector of [`Two`], each component as given, and in two parts.
#[derive(Clone, Copy)]
pub(crate) struct Split {
    pub(crate) whole: [Two; 3],
    pub(crate) high: [Two; 3],
    pub(crate) low: [Two; 3],
}

impl Split {
    /// `whole` + `rest` in two parts; see [`shortened`].
    #[inline(always)]
    pub(crate) fn new(whole: [Two; 3], rest: [Two; 3], far: Two) -> Self {
        let [x, y, z] = whole;
        let high = [shortened(x, far), shortened(y, far), shortened(z, far)];
        let low = |i: usize| (whole[i] - high[i]) + rest[i];
        Self { whole, high, low: [low(0), low(1), low(2)] }
    }

    /// The size of the lower parts: zero if the higher ones are all there is.
    #[inline(always)]
    pub(crate) fn lost(&self) -> f64 {
        let [x, y, z] = self.low;
        let Two([a, b]) = x.magnitude() + y.magnitude() + z.magnitude();
        a + b
    }

    /// The cross product in two parts, the higher without loss.
    #[inline(always)]
    pub(crate) fn cross(&self, other: &Self) -> [[Two; 3]; 2] {
        let (a, b) = (self, other);
        let high = |j: usize, k: usize| a.high[j] * b.high[k] - a.high[k] * b.high[j];
        let mixed = |j: usize, k: usize| a.high[j] * b.low[k] + a.low[j] * b.whole[k];
        let low = |j: usize, k: usize| mixed(j, k) - mixed(k, j);
        [[high(1, 2), high(2, 0), high(0, 1)], [low(1, 2), low(2, 0), low(0, 1)]]
    }

    /// The dot product with areas in two parts, of which `high` is short: without loss
    /// what the higher parts come to, and the rest.
    #[inline(always)]
    pub(crate) fn dot(&self, [high, low]: &[[Two; 3]; 2]) -> [Two; 2] {
        let exact = |i: usize| high[i] * self.high[i];
        let rest = |i: usize| low[i] * self.whole[i] + high[i] * self.low[i];
        fast_two_sum(exact(0) + exact(1) + exact(2), rest(0) + rest(1) + rest(2))
    }
}

/// Areas in two parts, the higher made short, see [`shortened`], and the two swapped.
#[inline(always)]
pub(crate) fn short_areas([high, low]: [[Two; 3]; 2], far: Two) -> [[Two; 3]; 2] {
    let [x, y, z] = high;
    let short = [shortened(x, far), shortened(y, far), shortened(z, far)];
    let rest = |i: usize| ((high[i] - short[i]) + low[i]).swapped();
    [[short[0].swapped(), short[1].swapped(), short[2].swapped()], [rest(0), rest(1), rest(2)]]
}
