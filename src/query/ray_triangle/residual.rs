//! t, u and v good to the last place, by what is left over.
//!
//! Short numbers near t, u and v go into the equation s + t·d = u·e1 + v·e2. What is left of it
//! is known to many places, for the products that nearly cancel have no error. It is a way to
//! an origin as s is, so the same kernel says how far t, u and v are from those numbers.
//!
//! # How far that is from the truth
//!
//! Short numbers t', u' and v' go into r = s + t'·d − u'·e1 − v'·e2, with true ways and edges, of
//! which r says how far they are from t, u and v. D, E, R and u are those of `super::error_bound`,
//! P(x) is the power of two below x, and ρ the relative error of the determinant. It is asked for
//! that R ≤ 2^22·E and ρ·R ≤ 2^-20·E, and known that the ray hits.
//!
//! * u' and v' are multiples of 2^-26, and at most 1 + 2^-18: they err by ρ and half a unit. t'
//!   is a multiple of τ = 2^-24·P(R)/P(D). The hit is no farther than E + R from the origin, so
//!   |t| ≤ 2·R/D, and |t'| < 1.05·2^26·τ.
//! * A component of e1, e2 or s is cut at G = 2^-25·P(E), of d at 2^-25·P(D). What is cut off is
//!   half of that at most, and exact. The lower part has what the rounding of the difference
//!   took besides.
//! * The higher parts: one of e1 or e2 is at most 2^26 units of G; times u' that is below 2^53
//!   units of 2^-26·G, and so is t'·d, below 2^26 + 1 times 1.05·2^26 units of 2^-49·P(R). So
//!   products are exact. s + t'·d is a way from the first vertex to near the hit: E, but for
//!   τ·D/2, for 3.2·ρ·R and for the lower parts, at most 2.8·P(E); and what comes after is no
//!   greater. All are multiples of 2^-51·P(E), for R ≥ E: below 2^53 units. So sums are exact too.
//! * The lower parts, in units of u·2^-25·R, times 1/u. Of s: 0.54, and errs by that. t'·d: 1.05
//!   and 1.05; the sum: 1.6. Those of e1 and e2: 0.5, and with u' and v' 0.5 and 0.5 each; the
//!   sums with them: 2.1 and 2.6. In all 0.54 + 1.05 + 1.6 + 3.1 + 3.6 = 9.9. r is that, and a
//!   rounding of its own.
//! * The kernel takes r for s. No difference for s, so the first bound has 6 roundings for each of
//!   6 terms, t 7. With that of r itself 42 and 48 roundoffs of D·E and E·E times the greatest of
//!   r; [`LEFT`] = 45 and [`LEFT_T`] = 51. What the lower parts err counts 6 times: 60 of u·2^-25
//!   times R; [`LOST`] = 64.
//! * Divided by the determinant: ρ, and 2 roundings, of what is added. ρ is at least
//!   44·u/6: 2·ρ. Then a rounding of the sum, 1/2 ulp.
//!
//! In `f64` numbers are good if the rest comes to u of them, at most 1 ulp. In `f32` they are good
//! if the error leaves no doubt to which number they round. So it is the number that the
//! integers would give, and machines to which `f64` is dear need not ask.
//!
//! `residual.g` proves the lower parts and the volumes of r, underflow included.

use core::ops::{Add, Mul, Sub};

use super::crossing::{Crossing, Setting, Sizes};
use super::error_bound::VOLUME;
use super::split::{CUT, cut};
use crate::arithmetic::{Embeds, Filtered, Float, Number, OfFour, Quad, largest, two_difference};
use crate::scalar::Scalar;

/// Roundoffs in u and v of what is left over.
const LEFT: u16 = 45;

/// Roundoffs in its t.
const LEFT_T: u16 = 51;

/// Roundoffs, times 2^-25, in its volumes from what it errs itself.
const LOST: u16 = 64;

/// 1.5·2^27: adding and subtracting so many times a power of two P leaves multiples of P·2^-25.
const SHIFTER: f64 = 201_326_592.0;

/// 1.5·2^26, for u and v: leaves multiples of 2^-26.
const SIDE_SHIFTER: f64 = 100_663_296.0;

/// 1.5·2^28, for t.
const T_SHIFTER: f64 = 402_653_184.0;

/// The way to the origin is no longer than so many edges.
const FARTHEST: f64 = 4_194_304.0;

/// The greatest error of u and v at first, where the way is no longer than an edge.
const MOST_ERROR: f64 = 1.0 / 1_048_576.0;

type Row = <f64 as OfFour>::Quad;

/// t, u and v where a ray hits for certain, but for a rounding each, and how far those are
/// from the truth at most.
pub(super) struct Numbers {
    pub(super) numbers: [(f64, f64); 3],
    /// Whether it is known how far.
    pub(super) is_known: bool,
}

impl Numbers {
    /// Of volumes that tell that it does.
    #[inline(always)]
    pub(super) fn new<const IN_ROWS: bool>(
        points: &[[f64; 3]; 4],
        d: [f64; 3],
        [det, t, u, v]: [f64; 4],
        Sizes { direction, edges, size }: Sizes<f64>,
    ) -> Self {
        let setting = Setting::new(points, d);
        let inverse = 1.0 / det;
        let roundoff = (edges * inverse.magnitude()).error(1);
        let relative_error = direction * size * roundoff * f64::from(VOLUME);
        let is_known = (direction.in_range() & edges.in_range() & size.in_range())
            & (size <= edges * FARTHEST)
            & (relative_error * size <= edges * MOST_ERROR);

        let longest = size.power_of_two_below() / direction.power_of_two_below();
        let near = |x: f64, shifter: f64| (x * inverse + shifter) - shifter;
        let short = [near(t, longest * T_SHIFTER), near(u, SIDE_SHIFTER), near(v, SIDE_SHIFTER)];
        let shifters = [edges, direction].map(|x| x.power_of_two_below() * SHIFTER);
        let left = if IN_ROWS {
            in_rows(points, d, short, shifters)
        } else {
            one_by_one(points, d, short, shifters)
        };
        let Crossing { t, sides: [_, u, v], .. } = setting.seen_along(left).volumes();
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

    /// Of numbers that are good.
    #[inline(always)]
    pub(super) fn known(numbers: [f64; 3]) -> Self {
        Self { numbers: numbers.map(|x| (x, 0.0)), is_known: true }
    }

    /// t, u and v, each within 2 ulp in `f64`, and as the last stages would round it in
    /// `f32`, if the second says so.
    #[inline(always)]
    pub(super) fn rounded<S: Scalar>(&self) -> ([S; 3], bool)
    where
        Filtered<f64>: Embeds<S>,
    {
        let rounded = |x: f64| Filtered::<f64>::quotient_of_lengths(x, 1.0);
        // Seen at compile time.
        let is_f64 = S::FLOAT.is_some_and(|format| {
            let [[roundoff, ..]] = Filtered::<f64>::embed_held(&[[format.roundoff; 3]]);
            roundoff == f64::EPSILON / 2.0
        });
        let is_good = |(x, error): (f64, f64)| {
            if is_f64 {
                return error <= x.magnitude() * (f64::EPSILON / 2.0);
            }
            // 2^-50 for the roundings, and for those of the last stages.
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
fn in_rows(
    [a, b, c, o]: &[[f64; 3]; 4],
    d: [f64; 3],
    short: [f64; 3],
    shifters: [f64; 2],
) -> [f64; 3] {
    let rows = [a, b, c, o, &d].map(|x| Row::of_three(*x));
    left_over(rows, short.map(Row::splat), shifters.map(Row::splat)).three()
}

/// The same one after the other, for who asks about several triangles at once.
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

/// What is left of s + t·d − u·e1 − v·e2: each component in two parts, the higher so short that
/// what they come to has no error, the lower with what the rounding of a difference took.
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
