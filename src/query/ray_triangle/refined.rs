//! The crossing in `f64` in two parts, for signs in doubt.
//!
//! D, E and R are as in `super::error_bound`. A component x of a vector of size s (D, E or R) is
//! cut at a grid: x = h + l, with h a multiple of g, |h| ≤ (1 + 2^25)·g, and |l| ≤ η·s, η = 2^-25,
//! up to a relative 2^-28 ([`cut`]). l also takes the rounding error of the difference. A
//! component of an area is (h h − h h) + (h l + l x − h l − l x). The first bracket is less than
//! 2^52 times its unit, so it is exact. It is cut again, at 26 bits, and the rest is at most η
//! times its size. The three products of its higher part with h sum to less than 3·2^51 + 2^30
//! units, so their sum H is exact as well. Only the rest, L, errs. `refined.g` proves its error.
//!
//! H + L is the number X plus its rounding error, without loss if |H| ≥ |L|. Otherwise X − H may be
//! rounded too. In all a volume errs by at most [`REFINED`]·u·η·D·E·R, with u the unit roundoff,
//! and w by at most 3·[`REFINED`].
//!
//! If all l are zero, nothing is lost. The part cut off an area is less than 2^25 + 3 units; L is a
//! sum of three products of that with h, and like H less than 2^53 units. X is zero only if H + L
//! is. det is a multiple of g³, with g of the edges twice, and u and v have no smaller unit,
//! because R ≥ E. The rounding errors added for w sum to less than 2^6·u·D·E·R ≤ 2^28·R/E units:
//! while R ≤ 2^20·E their sum is exact too.
//!
//! D, E and R are in range, so units of volumes are multiples of 2^-1038, which `f64` can
//! represent, and other underflow is below 2^-40 of the bound.

use core::ops::{Add, Mul, Sub};

use super::Feature;
use super::crosses::Crosses;
use super::kernel::{Crossing, Setting, Sizes, VolumeErrors};
use crate::arithmetic::{Each, Embeds, Filtered, Number, fast_two_sum, two_difference};
use crate::scalar::Scalar;

/// Roundoffs, times [`CUT`], in the volumes in two parts.
const REFINED: u16 = 192;

/// The size of the lower part of a number, relative to the size that sets the grid: 2^-25.
pub(super) const CUT: f64 = 1.0 / 33_554_432.0;

/// 2^28: `far` of [`cut`] for the 25 bits of a [`Split`].
const FAR: f64 = 268_435_456.0;

/// Volumes, each as a rounded number and its rounding error.
pub(super) struct Refined {
    det: f64,
    t: f64,
    u: f64,
    v: f64,
    pub(super) low_det: f64,
    low_t: f64,
    pub(super) low_u: f64,
    pub(super) low_v: f64,
    /// The error bounds of t, and of the remaining volumes.
    t_error: f64,
    side_error: f64,
    /// Whether nothing was lost, in a determinant or in a sum of three.
    is_exact: bool,
}

/// A crossing that counts.
pub(super) struct Met {
    pub(super) feature: Feature,
    pub(super) det: f64,
    /// t, u and v, if any is zero.
    pub(super) quotients: Option<[f64; 3]>,
}

impl Refined {
    /// Computes two volumes at a time; the module's documentation explains the parts. Also returns
    /// whether the error bounds are valid.
    #[inline(always)]
    pub(super) fn new(points: &[[f64; 3]; 4], d: [f64; 3]) -> (Self, bool) {
        let sizes = Setting::new(points, d).sizes();
        let Sizes { direction, edges: edge, size } = sizes;
        let [a, b, c, o] = points;
        let way = |i: usize| two_difference(Two([d[i], o[i]]), Two([0.0, a[i]]));
        let side = |i: usize| two_difference(Two([c[i], b[i]]), Two([a[i], a[i]]));
        let split = |parts, far: [f64; 2]| Split::new(parts, Two(far) * Two([FAR; 2]));
        let ways = split([way(0), way(1), way(2)], [direction, size]);
        let edges = split([side(0), side(1), side(2)], [edge, edge]);
        let areas = Two([direction, size]) * Two([edge; 2]);
        let products = short_areas(ways.cross(&edges), areas * Two([FAR; 2]));
        let [Two([t, det]), Two([low_t, low_det])] = edges.dot(&products);
        let [Two([v, u]), Two([low_v, low_u])] = ways.dot(&products);
        let is_exact = (ways.lost() + edges.lost() == 0.0) & (size <= 1_048_576.0 * edge);
        let unit = if is_exact { 0.0 } else { CUT };
        let error = |area: f64, length: f64| (area * length).error(REFINED) * unit;
        let Two([area, far_area]) = areas;
        let (t_error, side_error) = (error(far_area, edge), error(area, size));
        let refined =
            Self { det, t, u, v, low_det, low_t, low_u, low_v, t_error, side_error, is_exact };
        (refined, sizes.are_in_range())
    }

    /// The crossing for the test of signs, its error bounds, and whether it is exact.
    #[inline(always)]
    pub(super) fn crossing(&self) -> (Crossing<f64>, VolumeErrors<f64>, bool) {
        let Self { det, t, u, v, .. } = *self;
        let [rest, first] = two_difference(det, u);
        let [rest, second] = two_difference(rest, v);
        let w = rest + (first + second + (self.low_det - self.low_u - self.low_v));
        let errors =
            VolumeErrors { side: self.side_error, sides: 3.0 * self.side_error, t: self.t_error };
        (Crossing { det, t, sides: [w, u, v] }, errors, self.is_exact)
    }

    /// t, u and v within 1.1 roundings, if nothing was lost.
    #[inline(always)]
    fn quotients(&self) -> [f64; 3] {
        let inverse = 1.0 / self.det;
        let quotient = |high: f64, low: f64| {
            // A zero then has the sign of the determinant, as in every other system.
            let (high, low) = (high + 0.0, low + 0.0);
            let first = high / self.det;
            first + (low - first * self.low_det) * inverse
        };
        [quotient(self.t, self.low_t), quotient(self.u, self.low_u), quotient(self.v, self.low_v)]
    }
}

impl<S: Scalar> Crosses<'_, S> {
    /// The hit, if the crossing counts; `None` in doubt.
    #[inline(always)]
    pub(super) fn refined_crossing(
        &self,
        points: &[[f64; 3]; 4],
        d: [f64; 3],
    ) -> Option<Option<Met>>
    where
        Filtered<f64>: Embeds<S>,
    {
        let (refined, is_known) = Refined::new(points, d);
        if !is_known {
            return None;
        }
        let (crossing, errors, is_exact) = refined.crossing();
        let errors = if is_exact { None } else { Some(&errors) };
        if !crossing.meets(errors)? {
            return Some(None);
        }
        let counts = self.counts::<Filtered<f64>>(&Setting::new(points, d), &crossing, errors)?;
        let Crossing { det, t, sides: [_, u, v] } = crossing;
        let is_contact = is_exact & [t, u, v].contains(&0.0);
        let quotients = || is_contact.then(|| refined.quotients());
        Some(counts.then(|| Met { feature: crossing.feature(), det, quotients: quotients() }))
    }
}

/// Two numbers that undergo the same operations: every vector unit has room for two.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Two([f64; 2]);

impl Add for Two {
    type Output = Self;
    #[inline(always)]
    fn add(self, other: Self) -> Self {
        self.with(other, f64::add)
    }
}

impl Sub for Two {
    type Output = Self;
    #[inline(always)]
    fn sub(self, other: Self) -> Self {
        self.with(other, f64::sub)
    }
}

impl Mul for Two {
    type Output = Self;
    #[inline(always)]
    fn mul(self, other: Self) -> Self {
        self.with(other, f64::mul)
    }
}

impl Two {
    #[inline(always)]
    fn with(self, other: Self, f: impl Fn(f64, f64) -> f64) -> Self {
        Self([f(self.0[0], other.0[0]), f(self.0[1], other.0[1])])
    }

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
struct Split {
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
fn short_areas([x, y, z]: [[Two; 2]; 3], far: Two) -> [[Two; 2]; 3] {
    let short = |area: [Two; 2]| cut(area, far).each(Two::swapped);
    [short(x), short(y), short(z)]
}
