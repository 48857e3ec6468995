//! A grid of 65,536 points along an axis, for boxes of 16-bit numbers. Every point is a number
//! of the scalar, so that a comparison on the grid is a comparison of numbers.

#[cfg(feature = "fixed")]
mod fixed;
mod float;

/// What the grid of a mesh asks of a scalar. Sealed, as [`Backend`](super::Backend).
pub trait Gridded: Copy {
    /// Where point zero is, and how far it is to the next.
    type Steps: Copy + core::fmt::Debug;

    /// A grid whose points enclose the numbers from `min` to `max`.
    fn steps(min: Self, max: Self) -> Self::Steps;

    /// The step as a power of two, whose exponent this is, in a unit of the scalar's own.
    fn exponent(steps: &Self::Steps) -> i32;

    /// The greatest point that is not above this number, or the first.
    fn point_below(self, steps: &Self::Steps) -> u16;

    /// The least point that is not below this number, or the last.
    fn point_above(self, steps: &Self::Steps) -> u16;

    /// The point, or the end of the scalar if that comes first.
    fn point(steps: &Self::Steps, q: u16) -> Self;

    /// Two numbers that enclose self − h and self + h, as far as the scalar goes.
    fn reach(self, h: Self) -> [Self; 2];

    /// How many steps it is from point zero to this number, within 2⁻⁵⁰ of itself; infinite
    /// where it overflows.
    fn place(self, steps: &Self::Steps) -> f64;

    /// How many steps a length comes to, within 2⁻⁵⁰ of itself; infinite where it overflows.
    fn length(self, steps: &Self::Steps) -> f64;

    /// How many steps it is from another number to this one, within 2⁻⁵⁰ of itself; infinite
    /// where it overflows.
    fn steps_from(self, other: Self, steps: &Self::Steps) -> f64;

    /// A number that the t of a hit is not above, if it was rounded to this one.
    fn farthest(self) -> f64;

    /// The same as a number of the scalar; `None` where there is none.
    fn farthest_number(self) -> Option<Self>;
}

#[cfg(test)]
mod tests {
    extern crate std;

    use std::vec::Vec;

    use super::Gridded;
    use crate::scalar::Scalar;

    /// What boxes on the grid rest on: of numbers within its ends, the points around one
    /// enclose it, and nothing lies between them; of two numbers, the order is kept.
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
        check(&[f32::MIN, -1e38, -3.0, -1.0, -tiny, 0.0, tiny, 1e-38, 0.1, 1.0, f32::MAX]);
        check(&[16_777_214.0_f32, 16_777_215.0, 16_777_216.0, 16_777_218.0, 33_554_432.0]);
        check(&[1e4, 1e4_f32.next_up_by(1), 1e4_f32.next_up_by(5), 1e4 + 1.0, 1e4 + 77.7]);
        let tiny = f64::from_bits(1);
        check(&[f64::MIN, -1e300, -3.0, -tiny, 0.0, tiny, 1e-300, 0.1, 1.0, 1e10, f64::MAX]);
    }

    trait NextUp {
        fn next_up_by(self, ulps: u32) -> Self;
    }

    impl NextUp for f32 {
        fn next_up_by(self, ulps: u32) -> f32 {
            f32::from_bits(self.to_bits() + ulps)
        }
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
