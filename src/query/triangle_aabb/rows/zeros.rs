//! Zeros that the kernel in floats found, of which rounding may have made some.

use super::{half_of, row, rows, size};
use crate::arithmetic::{Float, InFloat, Quad, THREE, two_difference};
use crate::scalar::Scalar;
use crate::shape::{Aabb, AabbForm, Triangle, Vec3};

/// Whether each gap of zero between a triangle and a box given by its centre is one indeed:
/// whether the difference that says so was not rounded.
#[cold]
#[inline(never)]
pub(super) fn gaps_are_exact<S: Scalar + InFloat<F>, F: Float>(
    triangle: &Triangle<S>,
    center: &Vec3<S>,
    half: &Vec3<S>,
) -> bool {
    let (all, half) = (rows::<S, F::Quad>(triangle), row::<S, F::Quad>(half));
    let center = row::<S, F::Quad>(center);
    let zero = F::Quad::splat(F::ZERO);
    let ([low, low_lost], [high, high_lost]) =
        (two_difference(all.low, center), two_difference(all.high, center));
    let is_rounded = |lost: F::Quad| lost.magnitude().exceeds(zero);
    let (above, below) = (half.exceeds(low), high.exceeds(zero - half));
    (is_rounded(low_lost) & !above | is_rounded(high_lost) & !below) & THREE == 0
}

/// Whether these coordinates are whole multiples of so great a unit that no sum of
/// products of three of their differences is rounded, for differences up to this size.
#[cold]
#[inline(never)]
pub(super) fn is_on_grid<S: Scalar + InFloat<F>, F: Float>(
    triangle: &Triangle<S>,
    aabb: &Aabb<S>,
) -> bool {
    let all = rows::<S, F::Quad>(triangle);
    let (p, q, half) = match aabb.form() {
        AabbForm::Center { center, half } => (row(center), row(half), row(half)),
        AabbForm::Corners { min, max } => {
            let (min, max): (F::Quad, F::Quad) = (row(min), row(max));
            (min, max, half_of(max - min))
        }
    };
    let shifter =
        F::Quad::splat(size(half, all.high - all.low).power_of_two_below() * F::GRID_SHIFTER);
    let mut off = 0;
    for x in [all.v[0], all.v[1], all.v[2], p, q] {
        let whole = (x + shifter) - shifter;
        off |= whole.exceeds(x) | x.exceeds(whole);
    }
    off & THREE == 0
}
