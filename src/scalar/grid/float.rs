//! The grids of floats.

use super::Gridded;

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
