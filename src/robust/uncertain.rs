use core::ops::{BitAnd, BitOr, Not};

use crate::arithmetic::Number;

/// The verdict of the axes tested so far, with their errors; of several side by side as bits.
///
/// No branch depends on either flag until both are final. The result of a single test is almost
/// random, and a mispredicted branch costs more than all nine edge axes.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Uncertain<T = bool> {
    /// Some axis separates, beyond the error bound.
    pub(crate) certain: T,
    /// Some axis may separate, within the error bound.
    pub(crate) possible: T,
}

impl Uncertain {
    /// No axis has been tested.
    pub(crate) const NONE: Self = Self { certain: false, possible: false };

    /// Whether a true gap is above zero. The computed one differs from it by at most `error`.
    ///
    /// The answer is in doubt if the computation overflowed: then `error` is infinite or NaN,
    /// because it grows with every number in the gap. Kernels compare a gap with its error bound
    /// only by this function and by [`certain_sign`]; for vectors there is
    /// [`Quad::may_be_above`](crate::arithmetic::Quad::may_be_above).
    #[inline(always)]
    pub(crate) fn above<T: Number>(gap: T, error: T) -> Self {
        Self { certain: gap > error, possible: !gap.is_not_above(error) }
    }

    /// Whether a true gap is zero or above.
    #[inline(always)]
    pub(crate) fn not_below<T: Number>(gap: T, error: T) -> Self {
        Self::above(-gap, error).not()
    }

    /// An answer, or doubt.
    #[inline(always)]
    pub(crate) fn of(answer: Option<bool>) -> Self {
        Self { certain: answer == Some(true), possible: answer != Some(false) }
    }

    /// Whether an axis separates; `None` in doubt.
    #[inline(always)]
    pub(crate) fn verdict(self) -> Option<bool> {
        // One comparison that is nearly always false, instead of two random ones.
        if self.certain ^ self.possible { None } else { Some(self.certain) }
    }
}

impl<T> Uncertain<T>
where
    T: Copy + BitAnd<Output = T> + BitOr<Output = T> + Not<Output = T>,
{
    /// An answer without doubt.
    #[inline(always)]
    pub(crate) fn known(answer: T) -> Self {
        Self { certain: answer, possible: answer }
    }

    #[inline(always)]
    pub(crate) fn or(self, other: Self) -> Self {
        Self { certain: self.certain | other.certain, possible: self.possible | other.possible }
    }

    #[inline(always)]
    pub(crate) fn and(self, other: Self) -> Self {
        Self { certain: self.certain & other.certain, possible: self.possible & other.possible }
    }

    #[inline(always)]
    pub(crate) fn not(self) -> Self {
        Self { certain: !self.possible, possible: !self.certain }
    }
}

/// The sign of a true number. The computed one differs from it by at most `error`. Zero in doubt,
/// and if the computation overflowed.
#[inline(always)]
pub(crate) fn certain_sign<T: Number>(x: T, error: T) -> i8 {
    i8::from(x > error) - i8::from(x < -error)
}

#[cfg(test)]
mod tests {
    use super::{Uncertain, certain_sign};

    #[test]
    fn overflow_is_in_doubt() {
        let beyond = [f32::INFINITY, f32::NAN];
        for gap in [f32::NEG_INFINITY, -1.0, 0.0, 1.0, f32::INFINITY, f32::NAN] {
            for error in beyond {
                assert_eq!(Uncertain::above(gap, error).verdict(), None, "{gap} {error}");
                assert_eq!(Uncertain::not_below(gap, error).verdict(), None, "{gap} {error}");
                assert_eq!(certain_sign(gap, error), 0, "{gap} {error}");
            }
        }
        assert_eq!(Uncertain::above(f64::NAN, 1.0).verdict(), None);
        assert_eq!(Uncertain::not_below(f64::NAN, 1.0).verdict(), None);
        assert_eq!(certain_sign(f64::NAN, 1.0), 0);
    }

    #[test]
    fn a_gap_is_compared_with_its_bound() {
        for (gap, above) in [(-2.0, Some(false)), (-0.5, None), (0.5, None), (2.0, Some(true))] {
            assert_eq!(Uncertain::above(gap, 1.0_f64).verdict(), above);
            assert_eq!(Uncertain::not_below(gap, 1.0_f64).verdict(), above);
        }
        // Nothing is rounded: zero is not above zero, and not below it.
        for gap in -1..=1_i64 {
            assert_eq!(Uncertain::above(gap, 0).verdict(), Some(gap > 0));
            assert_eq!(Uncertain::not_below(gap, 0).verdict(), Some(gap >= 0));
        }
    }
}
