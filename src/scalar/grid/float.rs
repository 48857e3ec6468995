//! The grids of floats.

use super::Gridded;
use crate::scalar::Ordinal;

/// The grid of a float.
#[derive(Clone, Copy, Debug)]
pub struct FloatSteps<F> {
    origin: F,
    /// The origin in steps. Sums are in steps, because sums of coordinates may overflow if the grid
    /// spans more than half of the range.
    first: F,
    step: F,
    /// The reciprocal of the step, exact because the step is a power of two.
    inverse: F,
}

macro_rules! float {
    ($float:ident, $bits:ty, $least_step:expr) => {
        // The step is a power of two, at least two units in the last place of the greatest number,
        // and the origin is a multiple of it. Hence every point is a multiple of the step with no
        // more digits than the type has, and exact. The last points may be infinite.
        impl Gridded for $float {
            type SeptumSteps = FloatSteps<$float>;

            fn steps(min: Self, max: Self) -> Self::SeptumSteps {
                // At most 65,534 steps: rounding costs one at either end. The halves do not
                // overflow.
                let half = max * 0.5 - min * 0.5;
                let most = if -min > max { -min } else { max };
                const LEAST: $float = <$float>::from_bits($least_step);
                // `half`/32,759 is the length/65,518: a little more than one of 65,534 steps.
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
                // Rounded toward zero, then down if that left it above `min`.
                let mut origin = (min * inverse) as $bits as Self * step;
                if origin > min {
                    origin -= step;
                }
                // `MIN` is a multiple of half the finest step, and exact as well.
                if origin < Self::MIN {
                    origin = Self::MIN;
                }
                FloatSteps { origin, first: origin * inverse, step, inverse }
            }

            fn exponent(steps: &Self::SeptumSteps) -> i32 {
                (steps.step.to_bits() >> (Self::MANTISSA_DIGITS - 1)) as i32
            }

            #[inline]
            fn point_below(self, steps: &Self::SeptumSteps) -> u16 {
                // Within 2⁻⁸ of the true quotient. The conversion saturates at both ends.
                let q = (self * steps.inverse - steps.first) as u16;
                let at = |q: u16| (steps.first + Self::from(q)) * steps.step;
                if q > 0 && at(q) > self {
                    q - 1
                } else if q < u16::MAX && at(q + 1) <= self {
                    q + 1
                } else {
                    q
                }
            }

            #[inline]
            fn point_above(self, steps: &Self::SeptumSteps) -> u16 {
                let q = self.point_below(steps);
                let at = (steps.first + Self::from(q)) * steps.step;
                if q < u16::MAX && at < self { q + 1 } else { q }
            }

            #[inline]
            fn point(steps: &Self::SeptumSteps, q: u16) -> Self {
                let at = (steps.first + Self::from(q)) * steps.step;
                if at > Self::MAX { Self::MAX } else { at }
            }

            #[inline]
            fn reach(self, h: Self) -> [Self; 2] {
                // c + h rounded up, by the exact error of the sum (Knuth's two-sum).
                let above = |c: Self, h: Self| {
                    let sum = c + h;
                    let to_h = sum - c;
                    let error = (c - (sum - to_h)) + (h - to_h);
                    // Zero plus a number is never −0.
                    if error > 0.0 { Self::of_ordinal(sum.ordinal() + 1) } else { 0.0 + sum }
                };
                [0.0 - above(-self, h.abs()), above(self, h.abs())]
            }

            #[inline]
            fn origin(steps: &Self::SeptumSteps) -> Self {
                steps.origin
            }

            #[inline]
            fn steps_per_unit(steps: &Self::SeptumSteps) -> f64 {
                steps.inverse.into()
            }

            #[inline]
            fn farthest(self) -> f64 {
                // The true t is within 2 ulp, and an ulp is at most an epsilon of t, or the least
                // number. A t of −∞ is below the numbers of the type, or within 2 ulp of the least.
                let t = if self == Self::NEG_INFINITY { Self::MIN } else { self };
                let (t, ulp) = (f64::from(t), f64::from(Self::EPSILON));
                t + (t.abs() * (4.0 * ulp) + f64::from(Self::from_bits(4)))
            }

            #[inline]
            fn farthest_number(self) -> Option<Self> {
                None
            }
        }
    };
}
// The finest steps are 2⁻¹⁰⁰ and 2⁻¹⁰⁰⁰, so that their reciprocals are finite.
float!(f32, i64, (127 - 100) << 23);
float!(f64, i64, (1023 - 1000) << 52);
