//! t, u and v accurate to the last place, from a residual.
//!
//! Short numbers near t, u and v are inserted in the equation s + t·d = u·e1 + v·e2. The residual
//! is accurate, because the products that nearly cancel are exact. It is a vector to an origin,
//! like s, so the same kernel computes the corrections to t, u and v from it.
//!
//! # Errors
//!
//! Short numbers t', u' and v' give r = s + t'·d − u'·e1 − v'·e2, with exact vectors and edges, and
//! r determines their distance from t, u and v. D, E, R and u are as in `super::error_bound`,
//! P(x) is the power of two below x, and ρ the relative error of the determinant. The code requires
//! R ≤ 2^22·E and ρ·R ≤ 2^-20·E, and that the ray hits.
//!
//! * u' and v' are multiples of 2^-26, and at most 1 + 2^-18: they err by ρ and half a unit. t' is
//!   a multiple of τ = 2^-24·P(R)/P(D). The hit is no farther than E + R from the origin, so |t| ≤
//!   2·R/D, and |t'| < 1.05·2^26·τ.
//! * A component of e1, e2 or s is cut at G = 2^-25·P(E), of d at 2^-25·P(D). The lower part is at
//!   most half of that, and exact; it also takes the rounding error of the difference.
//! * The higher parts: a component of e1 or e2 is at most 2^26 units of G, and times u' it is below
//!   2^53 units of 2^-26·G. So is t'·d, below 2^26 + 1 times 1.05·2^26 units of 2^-49·P(R). Hence
//!   these products are exact. s + t'·d is the vector from the first vertex to a point near the
//!   hit: at most E, apart from τ·D/2, 3.2·ρ·R and the lower parts, together at most 2.8·P(E), and
//!   the later sums are no greater. All are multiples of 2^-51·P(E), because R ≥ E: below 2^53
//!   units. Hence the sums are exact too.
//! * The lower parts err, and r has a rounding of its own. `residual.g` proves that their errors
//!   add at most [`LOST`] roundoffs of 2^-25·R to a volume.
//! * The kernel takes r in place of s. `residual.g` proves that its volumes err by at most [`LEFT`]
//!   and [`LEFT_T`] roundoffs of D·E and E·E times the greatest component of r, underflow included.
//! * Dividing by the determinant adds ρ and 2 roundings of the correction. ρ is at least 44·u/6:
//!   2·ρ in all. The last sum is rounded by 1/2 ulp.
//!
//! In `f64` the numbers are accurate enough if the remaining error is at most u of them, together
//! at most 1 ulp. In `f32` they are accurate enough if the error leaves no doubt about the number
//! that they round to. Then it is the number that the integers give, so machines on which `f64` is
//! expensive need not use it.

use core::ops::{Add, Mul, Sub};

use super::error_bound::VOLUME;
use super::kernel::{Crossing, Setting, Sizes};
use super::refined::{CUT, cut};
use crate::arithmetic::{
    Each, Embeds, Filtered, Float, Number, OfFour, Quad, largest, two_difference,
};
use crate::scalar::Scalar;

/// Roundoffs in u and v of the residual.
const LEFT: u16 = 45;

/// Roundoffs in t of the residual.
const LEFT_T: u16 = 51;

/// Roundoffs, times 2^-25, that the residual's own error adds to its volumes.
const LOST: u16 = 64;

/// 1.5·2^27. Adding and subtracting this multiple of a power of two P rounds to multiples of
/// P·2^-25.
const SHIFTER: f64 = 201_326_592.0;

/// 1.5·2^26, for u and v: rounds to multiples of 2^-26.
const SIDE_SHIFTER: f64 = 100_663_296.0;

/// 1.5·2^28, for t.
const T_SHIFTER: f64 = 402_653_184.0;

/// The greatest R, in units of E.
const FARTHEST: f64 = 4_194_304.0;

/// The greatest first error of u and v, for R ≤ E.
const MOST_ERROR: f64 = 1.0 / 1_048_576.0;

type Row = <f64 as OfFour>::Quad;

/// t, u and v of a ray that certainly hits, each before its last rounding, and their error bounds.
pub(super) struct Numbers {
    pub(super) numbers: [(f64, f64); 3],
    /// Whether the error bounds are valid.
    pub(super) is_known: bool,
}

impl Numbers {
    /// From the volumes of a ray that hits.
    #[inline(always)]
    pub(super) fn new(
        in_rows: bool,
        points: &[[f64; 3]; 4],
        d: [f64; 3],
        [det, t, u, v]: [f64; 4],
        sizes: Sizes<f64>,
    ) -> Self {
        let Sizes { direction, edges, size } = sizes;
        let inverse = 1.0 / det;
        let roundoff = (edges * inverse.magnitude()).error(1);
        let relative_error = direction * size * roundoff * f64::from(VOLUME);
        let is_known = sizes.are_in_range()
            & (size <= edges * FARTHEST)
            & (relative_error * size <= edges * MOST_ERROR);

        let longest = size.power_of_two_below() / direction.power_of_two_below();
        let near = |x: f64, shifter: f64| (x * inverse + shifter) - shifter;
        let short = [near(t, longest * T_SHIFTER), near(u, SIDE_SHIFTER), near(v, SIDE_SHIFTER)];
        let shifters = [edges, direction].each(|x| x.power_of_two_below() * SHIFTER);
        let left = if in_rows {
            all_at_once(points, d, short, shifters)
        } else {
            one_by_one(points, d, short, shifters)
        };
        let seen = Setting { s: left, ..Setting::new(points, d) };
        let Crossing { t, sides: [_, u, v], .. } = seen.volumes::<Filtered<f64>>();
        let (left, lost) = (largest(&left), size * (f64::from(LOST) * CUT));
        let (side_left, t_left) = (left * f64::from(LEFT) + lost, left * f64::from(LEFT_T) + lost);
        let number = |k: usize, volume: f64, error: f64| {
            let rest = volume * inverse;
            (short[k] + rest, error + 2.0 * relative_error * rest.magnitude())
        };
        let numbers = [
            number(0, t, edges * roundoff * t_left),
            number(1, u, direction * roundoff * side_left),
            number(2, v, direction * roundoff * side_left),
        ];
        Self { numbers, is_known }
    }

    /// From numbers that are accurate already.
    #[inline(always)]
    pub(super) fn known(numbers: [f64; 3]) -> Self {
        Self { numbers: numbers.each(|x| (x, 0.0)), is_known: true }
    }

    /// t, u and v: within 2 ulp in `f64`, and in `f32` with the rounding of the last stages; and
    /// whether they are accurate enough.
    #[inline(always)]
    pub(super) fn rounded<S: Scalar>(&self) -> ([S; 3], bool)
    where
        Filtered<f64>: Embeds<S>,
    {
        let rounded = |x: f64| Filtered::<f64>::quotient_of_lengths(x, 1.0);
        // Known at compile time.
        let is_f64 = S::FLOAT.is_some_and(|format| {
            let [[roundoff, ..]] = Filtered::<f64>::embed_held(&[[format.roundoff; 3]]);
            roundoff == f64::EPSILON / 2.0
        });
        let is_good = |(x, error): (f64, f64)| {
            if is_f64 {
                return error <= x.magnitude() * (f64::EPSILON / 2.0);
            }
            // 2^-50 for the roundings here and in the last stages.
            let doubt = 1.25 * error + x.magnitude() * (4.0 * f64::EPSILON);
            rounded(x - doubt) == rounded(x + doubt)
        };
        let [t, u, v] = self.numbers;
        let are_good = self.is_known & is_good(t) & is_good(u) & is_good(v);
        ([rounded(t.0), rounded(u.0), rounded(v.0)], are_good)
    }
}

/// [`left_over`], three components at once.
#[inline(always)]
fn all_at_once(
    [a, b, c, o]: &[[f64; 3]; 4],
    d: [f64; 3],
    short: [f64; 3],
    shifters: [f64; 2],
) -> [f64; 3] {
    let rows = [a, b, c, o, &d].map(|x| Row::of_three(*x));
    left_over(rows, short.each(Row::splat), shifters.each(Row::splat)).three()
}

/// The same, component by component, for callers that process several triangles at once.
#[inline(always)]
fn one_by_one(
    [a, b, c, o]: &[[f64; 3]; 4],
    d: [f64; 3],
    short: [f64; 3],
    shifters: [f64; 2],
) -> [f64; 3] {
    let left = |i: usize| left_over([a[i], b[i], c[i], o[i], d[i]], short, shifters);
    [left(0), left(1), left(2)]
}

/// s + t·d − u·e1 − v·e2, with each component in two parts: the higher so short that its products
/// and sums are exact, the lower with the rounding error of a difference.
#[inline(always)]
fn left_over<T>(
    [a, b, c, o, d]: [T; 5],
    [t, u, v]: [T; 3],
    [shifter, direction_shifter]: [T; 2],
) -> T
where
    T: Copy + Add<Output = T> + Sub<Output = T> + Mul<Output = T>,
{
    let from_a = |x: T| cut(two_difference(x, a), shifter);
    let [e1, e2, s] = [from_a(b), from_a(c), from_a(o)];
    let high = (d + direction_shifter) - direction_shifter;
    let d = [high, d - high];
    let part = |k: usize| s[k] + d[k] * t - e1[k] * u - e2[k] * v;
    part(0) + part(1)
}
