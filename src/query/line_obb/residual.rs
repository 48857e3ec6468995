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

use super::Disjoint;
use super::range::{Four, candidates, crossings, error_of_crossings};
use super::rows::{Slabs, verdict};
use crate::arithmetic::{
    Double, Embeds, Filtered, Float, Number, Quad, enclosed_in_row, three,
};
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

/// x to the nearest multiple of a unit, given [`TO_GRID`] times that over g.
#[inline(always)]
fn cut(x: Four, to_grid: Four) -> Four {
    (x + to_grid) - to_grid
}

/// The same in all lanes.
#[inline(always)]
fn all(x: f64) -> Four {
    Four::splat(x)
}

/// Where the ray enters the box and leaves it, `Some(None)` if it misses it; `None` in doubt.
#[inline(never)]
pub(super) fn at_once<S: Scalar>(question: &Disjoint<'_, S>) -> Option<Option<(S, S)>>
where
    Filtered<f64>: Embeds<S>,
{
    let s = question.operands::<Filtered<f64>>()?;
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
    // Two lanes, one to enter by the last slab and one to leave by the first. The same twice: vectors of two
    // compute it once.
    let at = [last, first].map(|bits| bits.trailing_zeros() as usize % 3);
    let lanes = |[a, b]: [f64; 2]| Four::new([a, b, a, b]);
    let of_slab = |row: Four| {
        let row = row.to_array();
        lanes([row[at[0]], row[at[1]]])
    };
    let Slabs { w, along, middle, volume, .. } = slabs;

    let sizes = s.sizes();
    let far = 2.0 * (sizes.way + 2.0 * sizes.half * sizes.axes).power_of_two_below();
    let fast = 2.0 * sizes.direction.power_of_two_below();
    let long = far / fast;
    let [p, c] = [question.rows()[0], question.obb.center().to_array()];
    let [p, c] = Filtered::<f64>::embed(&[p, c])?;
    let m = Double::way(&p, &c);

    let [[near, _], [far_end, _]] = ends;
    let t = lanes([near.to_array()[at[0]], far_end.to_array()[at[1]]]);
    let t = cut(t, all(TO_GRID * long));
    let inverse = 1.0 / volume;
    let (middle, along_all) = (middle.to_array(), along.to_array());
    let coordinates = three(|l| {
        let x = (all(middle[l]) + t * all(along_all[l])) * all(inverse);
        let x = x.least(all(s.h[l])).greatest(all(-s.h[l]));
        cut(x, all(TO_GRID * far))
    });
    let u = three(|l| three(|x| {
        let high = cut(all(s.u[l][x]), all(TO_GRID));
        [high, all(s.u[l][x]) - high]
    }));
    let r = three(|x| {
        let m1 = cut(all(m[x].high), all(TO_GRID * far));
        let m2 = (all(m[x].high) - m1) + all(m[x].low);
        let d1 = cut(all(s.d[x]), all(TO_GRID * fast));
        let d2 = all(s.d[x]) - d1;
        let sum = |m: Four, d: Four, part: usize| {
            let [a, b, c] = three(|l| coordinates[l] * u[l][x][part]);
            m + t * d - a - b - c
        };
        sum(m1, d1, 0) + sum(m2, d2, 1)
    });
    let w = w.to_arrays();
    let w = three(|x| lanes([w[at[0]][x], w[at[1]][x]]));
    // The line enters where its coordinate in the box is −h if it grows, and leaves on the other side.
    let sign = f64::copysign(1.0, volume);
    let face = |i: usize| f64::copysign(s.h[i], along_all[i]) * sign;
    let off = lanes([coordinates[at[0]].to_array()[0] + face(at[0]), coordinates[at[1]].to_array()[1] - face(at[1])]);
    let n = w[0] * r[0] + w[1] * r[1] + w[2] * r[2] + off * all(volume);

    let size = r[0].magnitude().greatest(r[1].magnitude()).greatest(r[2].magnitude()).greatest(off.magnitude());
    let is_known = size.is_at_most(all(SMALL * far)) & t.magnitude().is_at_most(all(2.0 * long));
    if is_known & 3 != 3 {
        return None;
    }
    let along = of_slab(along);
    let axes = sizes.axes;
    let lost = (axes * axes * axes * far).error(RESIDUAL) * SMALL;
    let lost = all(lost) + t.magnitude() * along.magnitude() * all(TRUNCATED);
    let ends = enclosed_in_row(n, all(-1.0) / along, lost, error.direction);
    let [low, high] = ends.map(|end| (t + end).to_array());
    let nearest = <Filtered<f64> as Embeds<S>>::nearest;
    Some(Some((nearest([low[0], high[0]])?, nearest([low[1], high[1]])?)))
}
