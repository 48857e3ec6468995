//! A grid of 65,536 points along an axis, for boxes of 16-bit numbers. Every point is a number
//! of the scalar, so that a comparison on the grid is a comparison of numbers.

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

    /// The number, within 2⁻⁵⁰ of itself.
    fn real(self) -> f64;

    /// A number that the t of a hit is not above, if it was rounded to this one.
    fn farthest(self) -> f64;

    /// The same as a number of the scalar; `None` where there is none.
    fn farthest_number(self) -> Option<Self>;
}

/// A float's grid.
#[derive(Clone, Copy, Debug)]
pub struct FloatSteps<F> {
    origin: F,
    step: F,
    /// One over the step, exactly: both are powers of two.
    inverse: F,
}

/// Out of line for a machine whose emulator, QEMU before 8.0, multiplies two `f32` widened for
/// it wrongly (MDEBR).
#[cfg_attr(not(target_arch = "s390x"), inline(always))]
#[cfg_attr(target_arch = "s390x", inline(never))]
fn product(a: f64, b: f64) -> f64 {
    a * b
}

macro_rules! float {
    ($float:ident, $bits:ty, $least_step:expr) => {
        // The step is a power of two, and at least twice the last place of the greatest number;
        // the origin is a multiple of it. So a point is a multiple of the step, by a whole number
        // of the type's digits, and exact. The last points may be infinite.
        impl Gridded for $float {
            type Steps = FloatSteps<$float>;

            fn steps(min: Self, max: Self) -> Self::Steps {
                // At most 65,534 steps: one is lost at either end. Halves do not overflow.
                let half = max * 0.5 - min * 0.5;
                let most = if -min > max { -min } else { max };
                const LEAST: $float = <$float>::from_bits($least_step);
                // A little more than one of 65,534 steps for the whole.
                const PER_STEP: $float = 1.0 / 32_759.0;
                let power = |x: Self| {
                    let x = if x > LEAST { x } else { LEAST };
                    <$float>::from_bits(x.to_bits() & Self::INFINITY.to_bits())
                };
                let (wide, fine) =
                    (power(half * PER_STEP) * 2.0, power(most) * (2.0 * Self::EPSILON));
                let step = if wide > fine { wide } else { fine };
                let step = power(step);
                let inverse = 1.0 / step;
                // Toward zero; and down, also where what underflowed was below zero.
                let mut origin = (min * inverse) as $bits as Self * step;
                if origin > min {
                    origin -= step;
                }
                // The least number is a multiple of half the finest step, and exact as well.
                if origin < Self::MIN {
                    origin = Self::MIN;
                }
                FloatSteps { origin, step, inverse }
            }

            fn exponent(steps: &Self::Steps) -> i32 {
                (steps.step.to_bits() >> (Self::MANTISSA_DIGITS - 1)) as i32
            }

            #[inline]
            fn point_below(self, steps: &Self::Steps) -> u16 {
                // Within 2⁻⁸ of the truth; a conversion ends at the ends of the type.
                let q = ((self - steps.origin) * steps.inverse) as u16;
                let at = |q: u16| steps.origin + Self::from(q) * steps.step;
                if q > 0 && at(q) > self {
                    q - 1
                } else if q < u16::MAX && at(q + 1) <= self {
                    q + 1
                } else {
                    q
                }
            }

            #[inline]
            fn point_above(self, steps: &Self::Steps) -> u16 {
                let q = self.point_below(steps);
                let at = steps.origin + Self::from(q) * steps.step;
                if q < u16::MAX && at < self { q + 1 } else { q }
            }

            #[inline]
            fn point(steps: &Self::Steps, q: u16) -> Self {
                let at = steps.origin + Self::from(q) * steps.step;
                if at > Self::MAX { Self::MAX } else { at }
            }

            #[inline]
            fn reach(self, h: Self) -> [Self; 2] {
                // A rounding of x is at most half of its epsilon.
                let above = |x: Self| {
                    let x = x + (x.abs() * Self::EPSILON + Self::MIN_POSITIVE);
                    if x > Self::MAX { Self::MAX } else { x }
                };
                [-above(h.abs() - self), above(self + h.abs())]
            }

            #[inline]
            fn place(self, steps: &Self::Steps) -> f64 {
                (f64::from(self) - f64::from(steps.origin)) * f64::from(steps.inverse)
            }

            #[inline]
            fn length(self, steps: &Self::Steps) -> f64 {
                product(self.into(), steps.inverse.into())
            }

            #[inline]
            fn steps_from(self, other: Self, steps: &Self::Steps) -> f64 {
                product(f64::from(self) - f64::from(other), steps.inverse.into())
            }

            #[inline]
            fn real(self) -> f64 {
                self.into()
            }

            #[inline]
            fn farthest(self) -> f64 {
                // It is within 2 ulp, and an ulp at most an epsilon of it or the least number.
                let (t, ulp) = (f64::from(self), f64::from(Self::EPSILON));
                t + (t.abs() * (4.0 * ulp) + f64::from(Self::from_bits(4)))
            }

            #[inline]
            fn farthest_number(self) -> Option<Self> {
                None
            }
        }
    };
}
// The least steps are 2⁻¹⁰⁰ and 2⁻¹⁰⁰⁰: one over them is a number.
float!(f32, i64, (127 - 100) << 23);
float!(f64, i64, (1023 - 1000) << 52);

/// The grid of a fixed-point type, in raw bits.
#[cfg(feature = "fixed")]
#[derive(Clone, Copy, Debug)]
pub struct FixedSteps<W> {
    origin: W,
    /// The step is two to this power.
    shift: u32,
}

#[cfg(feature = "fixed")]
mod fixed_point {
    use fixed::types::extra::{LeEqU8, LeEqU16, LeEqU32, LeEqU64};
    use fixed::{FixedI8, FixedI16, FixedI32, FixedI64};

    use super::{FixedSteps, Gridded};

    /// 2^−n.
    const fn one_over_two_to(n: u32) -> f64 {
        f64::from_bits((1023 - n as u64) << 52)
    }

    // W is a word for sums of raw bits, U the same without a sign, for differences.
    macro_rules! fixed_point {
        ($($fixed:ident: $bound:ident, $raw:ty, $w:ty, $u:ty, |$d:ident| $to_f64:expr;)*) => {$(
            impl<Frac: $bound> Gridded for $fixed<Frac> {
                type Steps = FixedSteps<$w>;

                fn steps(min: Self, max: Self) -> Self::Steps {
                    let origin = <$w>::from(min.to_bits());
                    let length = <$w>::from(max.to_bits()).wrapping_sub(origin) as $u;
                    // The least with length ≤ 65,535·2^shift.
                    let mut shift = (<$u>::BITS - 16).saturating_sub(length.leading_zeros());
                    if length >> shift == 0xffff && (length >> shift) << shift != length {
                        shift += 1;
                    }
                    FixedSteps { origin, shift }
                }

                fn exponent(steps: &Self::Steps) -> i32 {
                    steps.shift as i32
                }

                #[inline]
                fn point_below(self, steps: &Self::Steps) -> u16 {
                    let x = <$w>::from(self.to_bits());
                    if x < steps.origin {
                        return 0;
                    }
                    let length = x.wrapping_sub(steps.origin) as $u;
                    u16::try_from(length >> steps.shift).unwrap_or(u16::MAX)
                }

                #[inline]
                fn point_above(self, steps: &Self::Steps) -> u16 {
                    let x = <$w>::from(self.to_bits());
                    if x < steps.origin {
                        return 0;
                    }
                    let length = x.wrapping_sub(steps.origin) as $u;
                    let q = length >> steps.shift;
                    let is_between = q << steps.shift != length;
                    u16::try_from(q).map_or(u16::MAX, |q| q.saturating_add(is_between.into()))
                }

                #[inline]
                fn point(steps: &Self::Steps, q: u16) -> Self {
                    let q = <$u>::from(q);
                    if q > <$u>::MAX >> steps.shift {
                        return Self::MAX;
                    }
                    let at = steps.origin.saturating_add_unsigned(q << steps.shift);
                    Self::from_bits(<$raw>::try_from(at).unwrap_or(<$raw>::MAX))
                }

                #[inline]
                fn reach(self, h: Self) -> [Self; 2] {
                    let (a, b) = (self.saturating_sub(h), self.saturating_add(h));
                    if a < b { [a, b] } else { [b, a] }
                }

                #[inline]
                fn place(self, steps: &Self::Steps) -> f64 {
                    let $d = (self.to_bits(), steps.origin);
                    $to_f64 * one_over_two_to(steps.shift)
                }

                #[inline]
                fn length(self, steps: &Self::Steps) -> f64 {
                    // In steps, for each unit of t.
                    self.to_bits() as f64 * one_over_two_to(steps.shift)
                }

                #[inline]
                fn steps_from(self, other: Self, steps: &Self::Steps) -> f64 {
                    let $d = (self.to_bits(), <$w>::from(other.to_bits()));
                    $to_f64 * one_over_two_to(steps.shift)
                }

                #[inline]
                fn real(self) -> f64 {
                    self.to_bits() as f64 * one_over_two_to(Self::FRAC_NBITS)
                }

                #[inline]
                fn farthest(self) -> f64 {
                    self.farthest_number().map_or(f64::INFINITY, |t| {
                        // What rounding to a float may have taken.
                        t.real() + t.real().abs() * (2.0 * f64::EPSILON)
                    })
                }

                #[inline]
                fn farthest_number(self) -> Option<Self> {
                    // At its end the type may stand for anything beyond.
                    self.checked_add(Self::DELTA)
                }
            }
        )*};
    }
    fixed_point! {
        FixedI8: LeEqU8, i8, i32, u32, |d| f64::from(i32::from(d.0) - d.1);
        FixedI16: LeEqU16, i16, i32, u32, |d| f64::from(i32::from(d.0) - d.1);
        FixedI32: LeEqU32, i32, i32, u32, |d| f64::from(d.0) - f64::from(d.1);
        FixedI64: LeEqU64, i64, i64, u64, |d| (i128::from(d.0) - i128::from(d.1)) as f64;
    }
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
