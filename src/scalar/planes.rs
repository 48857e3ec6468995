//! The planes of a grid of voxels: numbers at equal steps.

use super::{Ordinal, Scalar};
#[cfg(feature = "fixed")]
use crate::arithmetic::{InRaw, REGISTERS_ARE_WIDE};

/// The plane arithmetic that a grid of voxels requires of a scalar.
pub(crate) trait Planes: Copy {
    /// Whether floats may locate a number among the planes: always for floats, and for fixed point
    /// on machines where floats are cheap.
    const HAS_PLACES: bool;

    /// `origin + k·step`: exact in fixed point; in floats product and sum are rounded.
    fn plane(origin: Self, step: Self, k: u32) -> Self;

    /// The distance from one number to another in `count` steps, rounded up in fixed point. `None`
    /// if `count` is zero, or the scalar has no such step.
    fn step(from: Self, to: Self, count: u32) -> Option<Self>;

    /// An origin whose plane k is not above this number, and not farther below it than rounding
    /// needs. `None` if it is out of range.
    fn origin_before(self, step: Self, k: u32) -> Option<Self>;

    /// The number of the first plane not below `to`, or close to it where rounding makes planes
    /// coincide. `None` if a float cannot hold the distance from the origin.
    fn first_plane_above(origin: Self, step: Self, to: Self) -> Option<u32>;

    /// The greatest distance, in steps, of a plane from its exact position, for up to `count`
    /// steps; at most one half. Or the reason why these planes do not exist.
    fn check_planes(origin: Self, step: Self, count: u32) -> Result<f64, PlanesError>;
}

/// The reason why a grid's planes do not exist.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum PlanesError {
    /// The farthest plane is out of the range of the scalar.
    OutOfRange,
    /// Rounding might make two planes coincide.
    TooClose,
}

// Let M = |origin| + count·step. The product and the sum each err by a relative u, so a plane is
// off by at most 2·u·M to first order, and the computed M is too small by as much. Two planes a
// step apart are distinct if 4·u·M is below the step; the check requires 8·u·M.
// The product of a plane errs by u·count·step, and the sum, unless the origin is zero, by u times the
// plane's magnitude, which is at most that of the origin or of the last plane. The function returns the
// sum of both in steps, which is at most 1/4, and a sixteenth more: second orders and its own roundings
// are far below.
macro_rules! float {
    ($($float:ident)*) => {$(
        impl Planes for $float {
            const HAS_PLACES: bool = true;

            #[inline(always)]
            fn plane(origin: Self, step: Self, k: u32) -> Self {
                origin + k as Self * step
            }

            fn step(from: Self, to: Self, count: u32) -> Option<Self> {
                let step = (to - from) / count as Self;
                step.is_finite().then_some(step)
            }

            fn origin_before(self, step: Self, k: u32) -> Option<Self> {
                let origin = self - k as Self * step;
                // Rounded by half a unit of the origin at most.
                let is_above = Self::plane(origin, step, k) > self;
                let origin = if is_above { Self::of_ordinal(origin.ordinal() - 1) } else { origin };
                origin.is_finite().then_some(origin)
            }

            fn first_plane_above(origin: Self, step: Self, to: Self) -> Option<u32> {
                let length = to - origin;
                // Rounded down, and off by less than one.
                let k = (length / step) as u32;
                let is_below = |k: u32| Self::plane(origin, step, k) < to;
                let k = if !is_below(k.saturating_sub(1)) {
                    k.saturating_sub(1)
                } else if is_below(k) {
                    k.saturating_add(1 + u32::from(is_below(k.saturating_add(1))))
                } else {
                    k
                };
                length.is_finite().then_some(k)
            }

            fn check_planes(origin: Self, step: Self, count: u32) -> Result<f64, PlanesError> {
                const ROUNDOFF: $float = $float::EPSILON / 2.0;
                let farthest = origin.abs() + count as Self * step;
                if !farthest.is_finite() {
                    return Err(PlanesError::OutOfRange);
                }
                let least = 8.0 * ROUNDOFF * farthest;
                if least > step {
                    return Err(PlanesError::TooClose);
                }
                if is_on_grid([origin, step], farthest, $float::MANTISSA_DIGITS) {
                    return Ok(0.0);
                }
                let length = count as Self * step;
                let last = (origin + length).abs();
                let sum = if last <= origin.abs() { origin.abs() } else { last };
                let sum = if origin == 0.0 { 0.0 } else { sum };
                Ok((1.0625 * ROUNDOFF * (length / step + sum / step)).into())
            }
        }
    )*};
}
float! { f32 f64 }

/// Whether both numbers are multiples of a power of two so great that no plane up to `farthest` is
/// rounded. One bit is reserved for the rounding of `farthest` itself.
fn is_on_grid<S: Scalar>(numbers: [S; 2], farthest: S, digits: u32) -> bool {
    let lowest = numbers.map(S::parts).into_iter().filter(|x| x.magnitude != 0);
    let lowest = lowest.map(|x| u32::from(x.shift) + x.magnitude.trailing_zeros()).min();
    let top = farthest.parts();
    let highest = u32::from(top.shift) + top.magnitude.max(1).ilog2();
    lowest.is_some_and(|lowest| highest < lowest + digits - 1)
}

#[cfg(feature = "fixed")]
impl<S: InRaw> Planes for S {
    const HAS_PLACES: bool = REGISTERS_ARE_WIDE;

    #[inline(always)]
    fn plane(origin: Self, step: Self, k: u32) -> Self {
        // Modulo 2^64: the product may wrap, but the sum fits.
        let [origin, step]: [i64; 2] = [origin.raw().into(), step.raw().into()];
        Self::from_raw(origin.wrapping_add(step.wrapping_mul(k.into())))
    }

    fn step(from: Self, to: Self, count: u32) -> Option<Self> {
        let (length, count) = (wide(to) - wide(from), i128::from(count));
        Self::held((length + count - 1).checked_div(count)?)
    }

    fn origin_before(self, step: Self, k: u32) -> Option<Self> {
        Self::held(wide(self) - wide(step) * i128::from(k))
    }

    fn first_plane_above(origin: Self, step: Self, to: Self) -> Option<u32> {
        let (length, step) = (wide(to) - wide(origin), wide(step));
        let planes = (length + step - 1).checked_div(step);
        planes.map(|k| u32::try_from(k).unwrap_or(u32::MAX))
    }

    fn check_planes(origin: Self, step: Self, count: u32) -> Result<f64, PlanesError> {
        let farthest = Self::held(wide(origin) + wide(step) * i128::from(count));
        farthest.map(|_| 0.0).ok_or(PlanesError::OutOfRange)
    }
}

/// The raw bits of a number.
#[cfg(feature = "fixed")]
fn wide<S: InRaw>(x: S) -> i128 {
    let raw: i64 = x.raw().into();
    raw.into()
}

#[cfg(test)]
mod tests {
    use super::Planes;
    use crate::random::Random;

    /// Planes of `f32` against `f64`, which holds the products and errs a millionth as much.
    #[test]
    fn planes_are_within_their_deviation() {
        let (mut random, mut most) = (Random(0x91a), 0.0_f64);
        for case in 0..3_000 {
            let mut number = |bits: u32| random.of_bits(0, 24) as f32 / (1_u32 << bits) as f32;
            let origin = [0.0, number(30), number(24), number(20)][case % 4];
            let (step, count) = (number(29).abs() + 0.001, 1 + case as u32 % 2_000);
            let Ok(deviation) = f32::check_planes(origin, step, count) else { continue };
            for k in 0..=count {
                let exact = f64::from(origin) + f64::from(k) * f64::from(step);
                let off = (f64::from(f32::plane(origin, step, k)) - exact).abs() / f64::from(step);
                assert!(off <= deviation, "{origin} {step} {k}");
                most = if deviation > 0.0 { most.max(off / deviation) } else { most };
            }
        }
        assert!(most > 0.7, "{most}");
    }
}
