//! Lengths as scaled floats, for quotients that are only compared.
//!
//! A filter by quotients needs each term within a few roundings of itself. Then it needs no term
//! for underflow and no check for overflow. Differences of coordinates qualify: floats subtract
//! with one rounding, and integers that an `f64` holds with none. Quotients qualify in units of
//! 1/[`Span::SCALE`]: see `query::ray_aabb::error_bound`.

use core::fmt::Debug;
use core::ops::Div;

use super::float::Float;
use super::parts::exp2;
use super::quad::{OfFour, Quad};

/// A float in which quotients of lengths are compared.
pub(crate) trait Span: Float + Div<Output = Self> + Debug {
    /// One, in the unit of quotients. Multiply a nonzero length by the scale over an
    /// [`INVERTIBLE`](Self::INVERTIBLE) number: the product is a normal number, and so is its
    /// error. If it overflows, the quotient exceeds every finite computed quotient.
    const SCALE: Self;
    /// A number between these may be a divisor.
    const INVERTIBLE: (Self, Self);
    /// The greatest number, where an open range ends.
    const GREATEST: Self;

    /// Whether `other` exceeds this number by more than these units in the last place.
    /// Neither number is −0, and at least one is not negative.
    fn is_below(self, other: Self, units: u16) -> bool;
}

impl Span for f32 {
    const SCALE: f32 = exp2(64) as f32;
    const INVERTIBLE: (f32, f32) = (exp2(-40) as f32, exp2(40) as f32);
    const GREATEST: f32 = f32::MAX;

    #[inline(always)]
    fn is_below(self, other: f32, units: u16) -> bool {
        (self.to_bits() as i32) + i32::from(units) < other.to_bits() as i32
    }
}

impl Span for f64 {
    const SCALE: f64 = exp2(512);
    const INVERTIBLE: (f64, f64) = (exp2(-400), exp2(400));
    const GREATEST: f64 = f64::MAX;

    #[inline(always)]
    fn is_below(self, other: f64, units: u16) -> bool {
        (self.to_bits() as i64) + i64::from(units) < other.to_bits() as i64
    }
}

/// Four spans side by side.
pub type Spans<S> = <<S as Spanned>::SeptumSpan as OfFour>::Quad;

/// A scalar whose lengths are spans, each rounded at most once.
pub(crate) trait Spanned: Copy {
    /// The float.
    type SeptumSpan: Span;
    /// A coordinate from which others are measured.
    type SeptumAnchor: Copy + Debug;
    /// Whether this machine has fast operations on the float.
    const IS_FAST: bool;

    /// The coordinate as an anchor.
    fn anchor(self) -> Self::SeptumAnchor;
    /// The difference from the anchor to this coordinate.
    fn beyond(self, anchor: Self::SeptumAnchor) -> Self::SeptumSpan;
    /// The differences from the anchors to these coordinates. The fourth lane is ignored.
    #[inline(always)]
    fn all_beyond([x, y, z, _]: [Self; 4], [a, b, c, _]: [Self::SeptumAnchor; 4]) -> Spans<Self> {
        Quad::of_three([x.beyond(a), y.beyond(b), z.beyond(c)])
    }
    /// A length, in the unit of differences.
    fn span(self) -> Self::SeptumSpan;
    /// A quotient of lengths, times the scale; `None` if it was rounded.
    fn scaled(self) -> Option<Self::SeptumSpan>;
}

impl<F: Span> Spanned for F {
    type SeptumSpan = F;
    type SeptumAnchor = F;
    const IS_FAST: bool = true;

    #[inline(always)]
    fn anchor(self) -> F {
        self
    }
    #[inline(always)]
    fn beyond(self, anchor: F) -> F {
        self - anchor
    }
    #[inline(always)]
    fn all_beyond(p: [F; 4], anchors: [F; 4]) -> Spans<F> {
        <Spans<F> as Quad>::new(p) - <Spans<F> as Quad>::new(anchors)
    }
    #[inline(always)]
    fn span(self) -> F {
        self
    }
    #[inline(always)]
    fn scaled(self) -> Option<F> {
        Some(self * F::SCALE)
    }
}

#[cfg(feature = "fixed")]
mod fixed_point {
    use fixed::types::extra::{LeEqU8, LeEqU16, LeEqU32, LeEqU64};
    use fixed::{FixedI8, FixedI16, FixedI32, FixedI64};

    use super::{Span, Spanned};
    use crate::arithmetic::REGISTERS_ARE_WIDE;

    /// 2^-n times the scale.
    #[inline]
    const fn scale_over_two_to(n: u32) -> f64 {
        f64::from_bits(<f64 as Span>::SCALE.to_bits() - ((n as u64) << 52))
    }

    /// The number and 2^52 + 2^31, exactly: the number is in the last bits of the float.
    ///
    /// On x86-64 the conversion instruction waits for the previous value of its register. That wait
    /// took as long as a whole query against one of many boxes.
    #[inline(always)]
    const fn above(x: i32) -> f64 {
        f64::from_bits(1075 << 52 | (x as u32 ^ 1 << 31) as u64)
    }

    macro_rules! fixed_point {
        ($($fixed:ident: $bound:ident;)*) => {$(
            impl<Frac: $bound> Spanned for $fixed<Frac> {
                type SeptumSpan = f64;
                type SeptumAnchor = f64;
                const IS_FAST: bool = REGISTERS_ARE_WIDE;

                #[inline(always)]
                fn anchor(self) -> f64 {
                    above(self.to_bits().into())
                }
                // At most 33 bits, so not rounded.
                #[inline(always)]
                fn beyond(self, anchor: f64) -> f64 {
                    above(self.to_bits().into()) - anchor
                }
                #[inline(always)]
                fn span(self) -> f64 {
                    above(self.to_bits().into()) - above(0)
                }
                #[inline(always)]
                fn scaled(self) -> Option<f64> {
                    Some(self.span() * scale_over_two_to(Self::FRAC_NBITS))
                }
            }
        )*};
    }
    fixed_point! { FixedI8: LeEqU8; FixedI16: LeEqU16; FixedI32: LeEqU32; }

    /// From the anchor to a coordinate across zero. The difference has 65 bits and
    /// its magnitude 64; converting 64 bits takes three times as long.
    #[cold]
    #[inline(never)]
    fn far(x: i64, anchor: i64) -> f64 {
        let magnitude = x.abs_diff(anchor) as f64;
        if x < anchor { -magnitude } else { magnitude }
    }

    impl<Frac: LeEqU64> Spanned for FixedI64<Frac> {
        type SeptumSpan = f64;
        type SeptumAnchor = i64;
        const IS_FAST: bool = REGISTERS_ARE_WIDE;

        #[inline(always)]
        fn anchor(self) -> i64 {
            self.to_bits()
        }
        #[inline(always)]
        fn beyond(self, anchor: i64) -> f64 {
            match self.to_bits().checked_sub(anchor) {
                Some(difference) => difference as f64,
                None => far(self.to_bits(), anchor),
            }
        }
        #[inline(always)]
        fn span(self) -> f64 {
            self.to_bits() as f64
        }
        #[inline(always)]
        fn scaled(self) -> Option<f64> {
            let is_exact = self.to_bits().unsigned_abs() <= 1 << 53;
            is_exact.then(|| self.span() * scale_over_two_to(Self::FRAC_NBITS))
        }
    }
}
