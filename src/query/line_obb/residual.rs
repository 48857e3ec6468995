//! Where a ray enters an oriented box and leaves it, in `f64`: verdict and numbers from the same floats, and a
//! quotient corrected by its residual.
//!
//! With the names of the kernel, V = u_0·w_0, and t and c_l near the true t and the point's coordinates in
//! the box, let r = m + t·d − Σ c_l·u_l. Because w_i·u_l = 0 for all l but i, the line crosses the face at
//! w_i·u_i·h_i = ±h_i·V at t − n/(w_i·d), with n = w_i·r + (c_i ∓ h_i)·V. r and c_i ∓ h_i are small, so floats
//! compute the correction well enough.
//!
//! r is nearly exact. A component x of u, d or m is cut at a grid, x = x1 + x2: multiples of g = 2^-25 for u,
//! of g·E for d and of g·P for m, with powers of two E > |d| and P. t is a multiple of g·P/E, and c_l of g·P.
//! If |t| ≤ 2·P/E, the sum m1 + t·d1 − Σ c_l·u1_l of multiples of g²·P is below 8·P at every step, because
//! |m| ≤ P, h_l·|u_l| ≤ P/2 and |c_l| ≤ h_l, all but for g: no step rounds. The sum of the rests is at
//! most g·P or so, and its roundings do not count.

use super::kernel::Operands;
use super::range::{Four, candidates, crossings, error_of_crossings};
use super::rows::{Slabs, verdict};
use super::{Disjoint, Line};
use crate::arithmetic::{
    Embeds, Filtered, Float, Number, Quad, enclosed, greatest, three, two, two_difference,
};
use crate::query::obb_rows::most;
use crate::scalar::Scalar;

/// Roundoffs of [`SMALL`], in units of P and the axes, in n: `residual.g`.
const RESIDUAL: u16 = 160;

/// What r and c_i ∓ h_i may be, in units of P: 2^-22.
const SMALL: f64 = 1.0 / 4_194_304.0;

/// Exact sums divide the first 64 digits of numerator and divisor, and round the quotient down to at
/// least 63. So theirs is less than the true one by up to 3·2^-63 of it, or greater by a third of that. Doubled
/// as any error of a numerator, this is that and a third more, and the roundoff of the correction that `ends.g`
/// leaves has the rest.
const TRUNCATED: f64 = 0.5 / (1_u64 << 61) as f64;

/// 1.5·2^52 times g: adding it and subtracting it again leaves a multiple of g.
const TO_GRID: f64 = 201_326_592.0;

/// x cut at a grid: the nearest multiple of its unit, and the rest. `to_grid` is [`TO_GRID`] times the unit
/// over g.
#[inline(always)]
fn cut(x: Four, to_grid: f64) -> [Four; 2] {
    let high = (x + Four::splat(to_grid)) - Four::splat(to_grid);
    [high, x - high]
}

/// Where the ray enters the box and leaves it, `Some(None)` if it misses it; `None` in doubt.
#[inline(never)]
pub(super) fn at_once<S: Scalar>(question: &Disjoint<'_, S>) -> Option<Option<(S, S)>>
where
    Filtered<f64>: Embeds<S>,
{
    let s = in_double(question)?;
    let (is_separated, slabs) = verdict::<f64, Four>(&s)?;
    if is_separated {
        return Some(None);
    }
    let error = error_of_crossings(&s)?;
    let ends = crossings(&slabs, &error);
    let [last, first] = candidates(&ends);
    if last & last.wrapping_sub(1) | first & first.wrapping_sub(1) != 0 {
        return None;
    }
    let [last, first] = two(|k| [last, first][k].trailing_zeros() as usize % 3);
    let Slabs { w, along, middle, volume, .. } = slabs;

    let sizes = s.sizes();
    let far = 2.0 * (sizes.way + 2.0 * sizes.half * sizes.axes).power_of_two_below();
    let fast = 2.0 * sizes.direction.power_of_two_below();
    let long = far / fast;
    let [o] = Filtered::<f64>::embed(&[question.rows()[0]])?;
    let [c] = Filtered::<f64>::embed(&[question.obb.center().to_array()])?;
    let [m, rest] = two_difference(Four::of_three(o), Four::of_three(c));
    let [m, small_m] = cut(m, TO_GRID * far);
    let small_m = small_m + rest;
    let [d, small_d] = cut(Four::of_three(s.d), TO_GRID * fast);
    let u = three(|l| cut(Four::of_three(s.u[l]), TO_GRID));
    let (h, inverse) = (Four::of_three(s.h), Four::splat(1.0 / volume));
    let axes = sizes.axes;
    let lost = (axes * axes * axes * far).error(RESIDUAL) * SMALL;
    let w = three(|x| w.rows()[x].to_array());
    let (along_of, h_of) = (along.to_array(), h.to_array());

    // Where the line crosses a face of slab i, if that is near t.
    let crossing = |t: f64, i: usize, is_near: bool| {
        let [t, _] = cut(Four::splat(t), TO_GRID * long);
        let c = (middle + t * along) * inverse;
        let [c, _] = cut(c.least(h).greatest(Four::splat(0.0) - h), TO_GRID * far);
        let of_box = c.to_array();
        let sum = |m: Four, d: Four, part: usize| {
            let [x, y, z] = three(|l| Four::splat(of_box[l]) * u[l][part]);
            m + t * d - x - y - z
        };
        let r = sum(m, d, 0) + sum(small_m, small_d, 1);
        // The line enters where its coordinate in the box is −h if it grows, and leaves at h.
        let face = f64::copysign(h_of[i], along_of[i]) * f64::copysign(1.0, volume);
        let off = if is_near { of_box[i] + face } else { of_box[i] - face };
        let [x, y, z] = r.three();
        let n = w[0][i] * x + w[1][i] * y + w[2][i] * z + off * volume;
        let size = greatest(most(r.magnitude()), off.abs());
        let t = t.to_array()[0];
        if !((size <= SMALL * far) & (t.abs() <= 2.0 * long)) {
            return None;
        }
        let den = along_of[i].abs();
        let lost = lost + t.abs() * den * TRUNCATED;
        let n = -f64::copysign(1.0, along_of[i]) * n;
        let [low, high] = enclosed(n, den, [lost, error.direction])?;
        Filtered::<f64>::nearest([t + low, t + high])
    };
    let [[near, _], [far_end, _]] = ends;
    let enter = crossing(near.to_array()[last], last, true)?;
    let leave = crossing(far_end.to_array()[first], first, false)?;
    Some(Some((enter, leave)))
}

/// As [`Disjoint::operands`], row by row: all at once would go through memory.
#[inline(always)]
fn in_double<S: Scalar>(question: &Disjoint<'_, S>) -> Option<Operands<f64>>
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
    let (o, c, ends) = (row(o)?, row(c)?, row(ends)?);
    Some(Operands {
        m: three(|x| o[x] - c[x]),
        d: row(d)?,
        ends: [ray.t_min().map(|_| ends[0]), ray.t_max().map(|_| ends[1])],
        u: [row(u)?, row(v)?, row(w)?],
        h: row(h)?,
        one: 1.0,
    })
}
