//! A grid of 65,536 points along an axis, for boxes with 16-bit coordinates. Every point is a
//! number of the scalar, so that comparing grid points and comparing numbers agree.

#[cfg(feature = "fixed")]
mod fixed;
mod float;

use super::in_double::InDouble;

/// The grid arithmetic that a mesh tree requires of a scalar. Sealed, as
/// [`Backend`](super::Backend).
pub(crate) trait Gridded: InDouble {
    /// The position of point zero, and the distance between points.
    type SeptumSteps: Copy + core::fmt::Debug;

    /// A grid whose points enclose the numbers from `min` to `max`.
    fn steps(min: Self, max: Self) -> Self::SeptumSteps;

    /// The exponent of the step, which is a power of two, in a unit of the scalar's own.
    fn exponent(steps: &Self::SeptumSteps) -> i32;

    /// The greatest point not above this number, or the first point.
    fn point_below(self, steps: &Self::SeptumSteps) -> u16;

    /// The least point not below this number, or the last point.
    fn point_above(self, steps: &Self::SeptumSteps) -> u16;

    /// The number at point `q`, or the greatest number of the scalar if `q` lies beyond.
    fn point(steps: &Self::SeptumSteps, q: u16) -> Self;

    /// The greatest number not above self − |h|, and the least not below self + |h|. Fixed point
    /// clamps to its range; floats overflow to an infinity.
    fn reach(self, h: Self) -> [Self; 2];

    /// The position of point zero.
    fn origin(steps: &Self::SeptumSteps) -> Self;

    /// How many steps a [unit](InDouble::UNIT) has.
    fn steps_per_unit(steps: &Self::SeptumSteps) -> f64;

    /// The distance from point zero to this number in steps, within a relative 2⁻⁵⁰; infinite if it
    /// overflows.
    #[inline]
    fn place(self, steps: &Self::SeptumSteps) -> f64 {
        self.steps_from(Self::origin(steps), steps)
    }

    /// This length in steps, within a relative 2⁻⁵⁰; infinite if it overflows.
    #[inline]
    fn length(self, steps: &Self::SeptumSteps) -> f64 {
        product(self.units(), Self::steps_per_unit(steps))
    }

    /// The distance from `other` to this number in steps, within a relative 2⁻⁵⁰; infinite if it
    /// overflows.
    #[inline]
    fn steps_from(self, other: Self, steps: &Self::SeptumSteps) -> f64 {
        product(self.units_beyond(other), Self::steps_per_unit(steps))
    }

    /// An upper bound on the true t of a hit that was rounded to this number.
    fn farthest(self) -> f64;

    /// The same bound as a number of the scalar, if there is one.
    fn farthest_number(self) -> Option<Self>;
}

/// Out of line on s390x, because QEMU before 8.0 miscomputes the product of two `f32` widened to
/// `f64` (MDEBR).
#[cfg_attr(not(target_arch = "s390x"), inline(always))]
#[cfg_attr(target_arch = "s390x", inline(never))]
fn product(a: f64, b: f64) -> f64 {
    a * b
}

#[cfg(test)]
mod tests {
    extern crate std;

    use std::vec::Vec;

    use super::Gridded;
    use crate::scalar::Scalar;

    /// The properties that boxes on the grid depend on. For numbers within the ends, the two points
    /// around a number enclose it, and they are equal or adjacent. For two numbers, their points
    /// keep their order.
    fn check<S: Gridded + Scalar>(numbers: &[S]) {
        for &min in numbers {
            for &max in numbers.iter().filter(|&&max| max >= min) {
                let steps = S::steps(min, max);
                let within: Vec<S> =
                    numbers.iter().copied().filter(|&x| min <= x && x <= max).collect();
                for &x in numbers {
                    let (low, high) = (x.point_below(&steps), x.point_above(&steps));
                    assert!(low == high || low + 1 == high, "{x:?} in {min:?} to {max:?}");
                    if min <= x && x <= max {
                        assert!(S::point(&steps, low) <= x, "{x:?} in {min:?} to {max:?}");
                        assert!(S::point(&steps, high) >= x, "{x:?} in {min:?} to {max:?}");
                    }
                    for &y in within.iter().filter(|&&y| x <= y) {
                        assert!(low <= y.point_above(&steps), "{x:?}, {y:?}");
                    }
                    for &y in within.iter().filter(|&&y| y <= x) {
                        assert!(y.point_below(&steps) <= high, "{x:?}, {y:?}");
                    }
                }
            }
        }
    }

    #[test]
    fn points_enclose_floats() {
        let tiny = f32::from_bits(1);
        check(&[f32::MIN, -1e38, -3.0, -1.0, -tiny, 0.0, tiny, 1e-38, 0.1, 1.0, 2e38, f32::MAX]);
        check(&[16_777_214.0_f32, 16_777_215.0, 16_777_216.0, 16_777_218.0, 33_554_432.0]);
        let up = |ulps: u32| f32::from_bits(1e4_f32.to_bits() + ulps);
        check(&[1e4, up(1), up(5), 1e4 + 1.0, 1e4 + 77.7]);
        let tiny = f64::from_bits(1);
        check(&[f64::MIN, -1e300, -3.0, -tiny, 0.0, tiny, 1e-300, 0.1, 1.0, 1e308, f64::MAX]);
    }

    #[cfg(feature = "fixed")]
    #[test]
    fn points_enclose_fixed_point() {
        use fixed::types::{I4F4, I8F8, I16F16, I32F32};
        check(&[i8::MIN, -127, -1, 0, 1, 100, i8::MAX].map(I4F4::from_bits));
        check(&[i16::MIN, -32_767, -1, 0, 1, 300, i16::MAX - 1, i16::MAX].map(I8F8::from_bits));
        let near = [i32::MIN, i32::MIN + 1, -65_536, -1, 0, 1, 65_535, 65_536, i32::MAX];
        check(&near.map(I16F16::from_bits));
        let far = [i64::MIN, i64::MIN + 1, -(1 << 50), -1, 0, 1, 65_537, 1 << 40, i64::MAX];
        check(&far.map(I32F32::from_bits));
    }
}
