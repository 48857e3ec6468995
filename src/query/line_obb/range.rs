//! Where a ray that meets an oriented box enters it and leaves it.
//!
//! With the names of the kernel, the ray is within slab i from t = (−s·(w_i·m) − r_i)/|w_i·d| to t
//! = (−s·(w_i·m) + r_i)/|w_i·d|, with s the sign of w_i·d and r_i = h_i·|u_0·w_0|. The answer is
//! the greatest first value and the least second value, rounded. `f64` computes bounds on each, which also
//! decide whether the ray misses the box. If both bounds round to the same number of the scalar, exact sums would
//! give the same. For `f64` itself, residuals make the bounds narrow enough; where these do not round alike,
//! numbers in two words are divided as exact sums are.

use super::error_bound::{Sizes, error_bound};
use super::kernel::Operands;
use super::residual::refined;
use super::slabs::{Four, Slabs};
use super::{Disjoint, Line};
use crate::arithmetic::{
    Double, Each, Embeds, Filtered, Float, Number, Quad, REGISTERS_ARE_WIDE, Soft, greatest, least,
    three, turn, two,
};
use crate::robust::{Clue, Numeric, Predicate, exact_stage};
use crate::scalar::Scalar;

/// Where does the ray enter the box and leave it? `None` if it misses the box, which is asked before
/// unless the question [`DECIDES`](Range::DECIDES).
pub(super) struct Range<'a, S>(pub(super) Disjoint<'a, S>);

impl<S: Scalar> Range<'_, S> {
    /// Whether `f64` is asked first: it gives the verdict with the numbers. Verdicts in `f32` and in
    /// fixed point take less time, and most rays miss.
    pub(super) const DECIDES: bool =
        REGISTERS_ARE_WIDE && S::FLOAT.is_some() && size_of::<S>() == 8;
}

impl<S: Scalar> Predicate<S> for Range<'_, S> {
    type Answer = Option<(S, S)>;

    /// Integers have no quotients of such volumes; exact sums do.
    fn filter<N: Embeds<S>>(&self) -> Option<Option<(S, S)>> {
        if N::CERTAIN { Some(exact_stage(self)) } else { None }
    }

    fn exact(&self) -> Option<(S, S)> {
        let line = self.0.exactly();
        let crossings = (0..3).filter_map(|i| line.crossing(i));
        // Some component of the direction is not zero, and the axes span space. Rounding keeps
        // order.
        crossings.reduce(|a, b| (greatest(a.0, b.0), least(a.1, b.1)))
    }
}

impl<S: Scalar> Numeric<S> for Range<'_, S> {
    #[inline(always)]
    fn fast_path(&self) -> Result<Option<(S, S)>, Clue>
    where
        Filtered<f64>: Embeds<S>,
    {
        let (misses, numbers) = in_double(&self.0).unwrap_or_default();
        if misses.unwrap_or_else(|| S::evaluate(&self.0)) {
            return Ok(None);
        }
        numbers.map(Some).ok_or(Clue::NoNumbers)
    }

    fn refined(&self, _: Clue) -> Option<Option<(S, S)>>
    where
        Filtered<f64>: Embeds<S>,
    {
        let is_long = !<Filtered<f64> as Embeds<S>>::HAS_QUOTIENTS;
        if is_long { in_longs(&self.0).map(Some) } else { None }
    }
}

/// Whether the ray misses the box, and where the line enters and leaves it, each if that is certain.
type Found<S> = (Option<bool>, Option<(S, S)>);

/// What `f64` finds out.
#[inline(never)]
fn in_double<S: Scalar>(question: &Disjoint<'_, S>) -> Option<Found<S>>
where
    Filtered<f64>: Embeds<S>,
{
    let (s, rests) = embedded(question)?;
    let slabs = Slabs::new(&s)?;
    let misses = slabs.misses(s.ends);
    if misses == Some(true) {
        return Some((misses, None));
    }
    let ends = if <Filtered<f64> as Embeds<S>>::HAS_QUOTIENTS {
        Some([slabs.enter, slabs.leave])
    } else {
        refined(&s, rests, &slabs)
    };
    let nearest = <Filtered<f64> as Embeds<S>>::nearest;
    let numbers = ends.and_then(|[enter, leave]| Some((nearest(enter)?, nearest(leave)?)));
    Some((misses, numbers))
}

/// As [`Disjoint::operands`], and the rounding errors of m. Row by row, because all at once would go through
/// memory.
#[inline(always)]
fn embedded<S: Scalar>(question: &Disjoint<'_, S>) -> Option<(Operands<f64>, [f64; 3])>
where
    Filtered<f64>: Embeds<S>,
{
    let Line::Ray(ray) = question.line else { return None };
    let row = |row: [S; 3]| -> Option<[f64; 3]> {
        let [row] = Filtered::<f64>::embed(&[row])?;
        Some(row)
    };
    let [o, d, ends] = question.rows();
    let [c, u, v, w, h] = question.obb.numbers();
    let (m, ends) = (Double::way(&row(o)?, &row(c)?), row(ends)?);
    let s = Operands {
        m: three(|x| m[x].high),
        d: row(d)?,
        ends: [ray.t_min().map(|_| ends[0]), ray.t_max().map(|_| ends[1])],
        u: [row(u)?, row(v)?, row(w)?],
        h: row(h)?,
        one: <Filtered<f64> as Embeds<S>>::one()?,
    };
    Some((s, three(|x| m[x].low)))
}

/// Roundoffs of a bound of `f64` that bound the same number in two words: `range.g`.
const PART: u16 = 8;

/// The range in `f64`: each quotient has the bits that exact sums would give it.
///
/// Floats find which slabs may be the last to be entered or the first to be left, nearly always one each.
/// For those, numbers in two words have the first 64 digits of numerator and divisor, which exact sums
/// divide as well. If the digits are not certain, as of sums with few digits, both quotients must round alike.
#[inline(never)]
fn in_longs<S: Scalar>(question: &Disjoint<'_, S>) -> Option<(S, S)>
where
    Filtered<f64>: Embeds<S>,
{
    let s = question.operands::<Filtered<f64>>()?;
    let center = question.obb.center().to_array();
    let [p, c] = Filtered::<f64>::embed(&[question.rows()[0], center])?;
    let short = error_bound::<Filtered<f64>>(s.one, &Sizes { ends: 0.0, ..s.sizes() })?;
    let [lasts, firsts] = Slabs::new(&s)?.candidates();

    let part = 1.0.error(PART);
    let (direction, face) = (part * short.direction, part * short.face);
    let m = Double::way(&p, &c);
    let (mut enter, mut leave) = ([f64::NEG_INFINITY; 2], [f64::INFINITY; 2]);
    for slabs in pairs(lasts, firsts) {
        for (lane, [den, middle, reach]) in in_lanes(&s, &m, slabs).into_iter().enumerate() {
            // The first word has the sign only if the second lies below its last place.
            let (den, reach) = (den.apart(), reach.apart().magnitude());
            // No branch, because half of the signs differ.
            let sign = -f64::copysign(1.0, den.high);
            let middle = Double { high: sign * middle.high, low: sign * middle.low };
            let is_near = lane == 0;
            let num = middle.loose_sum(if is_near { reach.negated() } else { reach }).apart();
            let [least_num, most_num] = num.leading(face)?;
            let [least_den, most_den] = den.leading(direction)?;
            let quotient = |num: Soft, den: Soft| {
                let (whole, exponent) = num.quotient(den);
                f64::scaled(whole, exponent)
            };
            let near = quotient(least_num, most_den);
            let is_known = least_num == most_num && least_den == most_den;
            let far = if is_known { near } else { quotient(most_num, least_den) };
            let t = if num.high < 0.0 { [-far, -near] } else { [near, far] };
            // Rounding keeps order.
            if is_near {
                enter = two(|k| greatest(enter[k], t[k]));
            } else {
                leave = two(|k| least(leave[k], t[k]));
            }
        }
    }
    let nearest = <Filtered<f64> as Embeds<S>>::nearest;
    Some((nearest(enter)?, nearest(leave)?))
}

/// Pairs of slabs: each slab of the first set is the first of a pair, and each of the second set the second
/// of one. Sets are bits, because no branch on a slab could be predicted.
fn pairs(firsts: u32, seconds: u32) -> impl Iterator<Item = [usize; 2]> {
    let mut left = Some([firsts, seconds]);
    core::iter::from_fn(move || {
        let sets = left?;
        let rest = sets.each(|set| set & set.wrapping_sub(1));
        left =
            (rest != [0; 2]).then(|| [0, 1].each(|k| if rest[k] == 0 { sets[k] } else { rest[k] }));
        Some(sets.each(|set| set.trailing_zeros() as usize % 3))
    })
}

/// For each of two slabs w·d, w·m and h·(u·w), side by side. The second words are loose.
#[inline(always)]
fn in_lanes(s: &Operands<f64>, m: &[Double; 3], slabs: [usize; 2]) -> [[Double; 3]; 2] {
    let lanes = |of: &dyn Fn(usize) -> f64| -> Four {
        let [a, b] = slabs.each(of);
        // The same twice: vectors of two compute it once.
        Quad::new([a, b, a, b])
    };
    let u = three(|k| three(|x| lanes(&|i| s.u[(i + k) % 3][x])));
    let w = three(|x| {
        let (_, y, z) = turn(x);
        let product = |y: usize, z: usize| Double::of_product(u[1][y], u[2][z]);
        product(y, z).loose_difference(product(z, y))
    });
    let sum = |[x, y, z]: [Double<Four>; 3]| x.loose_sum(y).loose_sum(z);
    let splat = |x: Double| Double { high: Quad::splat(x.high), low: Quad::splat(x.low) };
    let along = sum(three(|x| w[x].scaled(Quad::splat(s.d[x]))));
    let middle = sum(three(|x| w[x].product(splat(m[x]))));
    let reach = sum(three(|x| w[x].scaled(u[0][x]))).scaled(lanes(&|i| s.h[i]));
    let all = [along, middle, reach].each(|x| (x.high.to_array(), x.low.to_array()));
    [0, 1].each(|lane| all.each(|(high, low)| Double { high: high[lane], low: low[lane] }))
}

#[cfg(test)]
mod tests {
    use super::super::Line;
    use super::*;
    use crate::shape::{Obb, Ray};

    /// Rays from points on and near the faces of rotated boxes, where nearly all of a numerator
    /// cancels: exact sums agree with everything that `f64` decides. Returns the number of
    /// decisions.
    fn check<S: Scalar>(near: impl Fn(f64) -> S) -> [u32; 2]
    where
        Filtered<f64>: Embeds<S>,
    {
        let row = |p: [f64; 3]| p.each(&near);
        let axes = [[0.6, 0.8, 0.0], [-0.48, 0.36, 0.8], [0.64, -0.48, 0.6]];
        let obb =
            Obb::from_skewed_axes(row([0.125, 1.0, -0.5]), axes.each(row), row([1.3, 0.7, 2.1]));
        let obb = obb.unwrap();
        let (mut settled, mut asked) = (0, 0);
        for n in 0..1_200 {
            // To a point of a face, and on into the box.
            let (face, step) = (n % 3, [0.0, 1e-9, 1e-4, 0.3][n / 3 % 4]);
            let at = |k: usize, times: usize| ((n * times) % 17) as f64 / 17.0 - 0.3 * k as f64;
            let s = [0, 1, 2].each(|i: usize| if i == face { 1.0 } else { at(i, i + 3) });
            let half = [1.3, 0.7, 2.1];
            let point = |s: [f64; 3], step: f64| {
                let reach = [0, 1, 2]
                    .each(|i: usize| (s[i] + if i == face { step } else { 0.0 }) * half[i]);
                let sum = |c: usize| (0..3).map(|i| reach[i] * axes[i][c]).sum::<f64>();
                [0.125 + sum(0), 1.0 + sum(1), -0.5 + sum(2)]
            };
            let from = point(s, step);
            let to = [0.125, 1.0 - at(1, 5) / 4.0, -0.5];
            let into = [0, 1, 2].each(|c: usize| to[c] - from[c]);
            // Past an edge, or through it, as the step rounds.
            let next = (face + 1) % 3;
            let edge = [0, 1, 2].each(|i: usize| if i == next { 1.0 } else { s[i] });
            let edge = point(edge, [0.0, 1e-16, -1e-16, 1e-9][n / 3 % 4]);
            let across = [0, 1, 2].each(|c: usize| axes[face][c] - axes[next][c]);
            let before = [0, 1, 2].each(|c: usize| edge[c] - across[c]);
            let [ray, grazing] = [(from, into), (before, across)]
                .each(|(from, way)| Ray::new(row(from), row(way)).unwrap());
            for ray in [&ray, &grazing] {
                let question = Disjoint { line: Line::Ray(ray), obb: &obb };
                let (misses, _) = in_double(&question).unwrap_or_default();
                assert!(misses != Some(ray.overlaps(&obb)), "{ray:?}");
            }
            if !ray.overlaps(&obb) {
                continue;
            }
            let question = Disjoint { line: Line::Ray(&ray), obb: &obb };
            let (_, found) = in_double(&question).unwrap_or_default();
            asked += 1;
            let found = found.or_else(|| Range(question).refined(Clue::NoNumbers).flatten());
            if let Some(found) = found {
                settled += 1;
                let question = Disjoint { line: Line::Ray(&ray), obb: &obb };
                assert_eq!(Some(found), Range(question).exact(), "{ray:?}");
            }
        }
        [settled, asked]
    }

    #[test]
    fn floats_say_what_exact_sums_say() {
        let [settled, asked] = check(|x| x as f32);
        assert!(asked > 800 && settled > asked / 3 && settled < asked, "{settled} of {asked}");
        let [settled, asked] = check(|x| x);
        assert!(asked > 800 && settled > asked / 3 && settled < asked, "{settled} of {asked}");
    }

    #[cfg(feature = "fixed")]
    #[test]
    fn fixed_point_too() {
        use fixed::types::{I8F8, I16F16};
        let [settled, asked] = check(I16F16::from_num);
        assert!(asked > 800 && settled > asked / 2, "{settled} of {asked}");
        let [settled, asked] = check(I8F8::from_num);
        assert!(asked > 400 && settled > asked / 2, "{settled} of {asked}");
    }
}
