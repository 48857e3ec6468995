//! Where a ray enters an oriented box and leaves it, in `f64`: each quotient is corrected by its residual.
//!
//! With the names of the kernel, let V = u_0·w_0, let t and c_l be near the true t and the coordinates in the box
//! of the point there, and r = m + t·d − Σ c_l·u_l. Because w_i·u_l is zero for l ≠ i, the line crosses a face
//! of slab i at t − n/(w_i·d), with n = w_i·r + (c_i ∓ h_i)·V. r and c_i ∓ h_i are small, so floats compute n
//! well enough.
//!
//! r is nearly exact. A component of u, d or m is cut at a grid of g = 2^-25, g·E or g·P, with powers of two
//! E > D and P > |m| + 2·h·A, for the greatest m and h: x = x1 + x2. t is a multiple of g·P/E, and c_l of g·P.
//! If |t| ≤ 2·P/E, m1 + t·d1 − Σ c_l·u1_l is a sum of multiples of g²·P, and each partial sum is below 8·P,
//! because Σ |c_l·u1_l| is at most 2·P: no step rounds. The same sum with x2 has terms of g·P at most, and
//! `residual.g` bounds its roundings.

use super::error_bound::Sizes;
use super::kernel::Operands;
use super::slabs::{Four, Slabs};
use crate::arithmetic::{Float, Number, Quad, enclosed, greatest, three, two};

/// Roundoffs of `SMALL`·A³·P that n may be from the truth: `residual.g`.
const RESIDUAL: u16 = 160;

/// How great the components of r, and c_i ∓ h_i, may be, in units of P: 2^-22, as in `residual.g`.
const SMALL: f64 = 1.0 / 4_194_304.0;

/// A volume above this part of A³ has a certain sign, which says on which side a face is: V is a sum of six
/// products of at most A³, each rounded five times, and errs by less than 40 roundoffs of A³.
const FLAT: f64 = 1.0 / (1_u64 << 40) as f64;

/// Exact sums divide the first 64 digits of numerator and divisor, and of the quotient they keep at least 63.
/// Their quotient is less than the true one by up to 3·2^-63 of it, or greater by 2^-63. As an error of n this is 2^-62
/// of t·(w_i·d): an interval around a quotient doubles an error, and three quarters of that suffice
/// (`ends.g`). The same share of the correction n/(w_i·d) is far below the roundings that the interval
/// allows it.
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

/// Bounds on where the line enters the box and on where it leaves it, close enough to round alike, if one
/// slab is certainly the last to be entered, and one the first to be left.
#[inline(always)]
pub(super) fn refined(s: &Operands<f64>, rests: [f64; 3], slabs: &Slabs) -> Option<[[f64; 2]; 2]> {
    let [last, first] = slabs.candidates();
    let axes = slabs.sizes.axes;
    let is_flat = slabs.volume.abs() <= FLAT * (axes * axes * axes);
    if is_flat | (last & last.wrapping_sub(1) | first & first.wrapping_sub(1) != 0) {
        return None;
    }
    let [last, first] = two(|k| [last, first][k].trailing_zeros() as usize % 3);
    let faces = Faces::new(s, rests, slabs);
    let (near, far) = (slabs.near[0].to_array(), slabs.far[0].to_array());
    Some([faces.crossing(near[last], last, true)?, faces.crossing(far[first], first, false)?])
}

/// The line and the box, cut at grids.
struct Faces<'a> {
    slabs: &'a Slabs,
    w: [[f64; 4]; 3],
    along: [f64; 4],
    half: [f64; 4],
    m: [Four; 2],
    d: [Four; 2],
    u: [[Four; 2]; 3],
    h: Four,
    /// 1/V.
    inverse: Four,
    /// P, and P/E.
    far: f64,
    long: f64,
    /// How far n and w_i·d may be from the truth.
    errors: [f64; 2],
}

impl<'a> Faces<'a> {
    #[inline(always)]
    fn new(s: &Operands<f64>, rests: [f64; 3], slabs: &'a Slabs) -> Self {
        let Sizes { axes, way, direction, half, .. } = slabs.sizes;
        let far = 2.0 * (way + 2.0 * half * axes).power_of_two_below();
        let fast = 2.0 * direction.power_of_two_below();
        let [m, small] = cut(Four::of_three(s.m), TO_GRID * far);
        Self {
            slabs,
            w: three(|x| slabs.w.rows()[x].to_array()),
            along: slabs.along.to_array(),
            half: Four::of_three(s.h).to_array(),
            m: [m, small + Four::of_three(rests)],
            d: cut(Four::of_three(s.d), TO_GRID * fast),
            u: three(|l| cut(Four::of_three(s.u[l]), TO_GRID)),
            h: Four::of_three(s.h),
            inverse: Four::splat(1.0 / slabs.volume),
            far,
            long: far / fast,
            errors: [(axes * axes * axes * far).error(RESIDUAL) * SMALL, slabs.error],
        }
    }

    /// Bounds on where the line crosses a face of slab i, near t.
    #[inline(always)]
    fn crossing(&self, t: f64, i: usize, is_near: bool) -> Option<[f64; 2]> {
        let Self { m, d, u, h, far, long, errors: [lost, error], .. } = *self;
        let Slabs { along, middle, volume, .. } = self.slabs;
        let [t, _] = cut(Four::splat(t), TO_GRID * long);
        let c = (*middle + t * *along) * self.inverse;
        let [c, _] = cut(c.least(h).greatest(Four::splat(0.0) - h), TO_GRID * far);
        let c = c.to_array();
        let (mut high, mut low) = (m[0] + t * d[0], m[1] + t * d[1]);
        for l in 0..3 {
            let c = Four::splat(c[l]);
            (high, low) = (high - c * u[l][0], low - c * u[l][1]);
        }
        let [x, y, z] = (high + low).three();
        let size = greatest(greatest(x.abs(), y.abs()), z.abs());

        let along = self.along[i];
        // The line enters where its coordinate in the box is −h if it grows, and leaves at h.
        let face = f64::copysign(self.half[i], along) * f64::copysign(1.0, *volume);
        let off = if is_near { c[i] + face } else { c[i] - face };
        let [a, b, e] = three(|x| self.w[x][i]);
        let n = a * x + b * y + e * z + off * *volume;
        let t = t.to_array()[0];
        if !((greatest(size, off.abs()) <= SMALL * far) & (t.abs() <= 2.0 * long)) {
            return None;
        }
        let den = along.abs();
        let lost = lost + t.abs() * den * TRUNCATED;
        let [low, high] = enclosed(-f64::copysign(1.0, along) * n, den, [lost, error])?;
        Some([t + low, t + high])
    }
}
