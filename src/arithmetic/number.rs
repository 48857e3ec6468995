//! The operations of all numbers in a kernel. Products are not among them:
//! [`Arithmetic`](super::Arithmetic) knows which type holds a product.

use core::cmp::Ordering;
use core::ops::{Add, Neg, Sub};

use super::portion::{divided, divided_short};
use super::soft::Soft;

/// A number that holds a geometric quantity.
pub trait Number:
    Copy + PartialOrd + Add<Output = Self> + Sub<Output = Self> + Neg<Output = Self>
{
    /// Zero.
    const ZERO: Self;

    /// The most that underflow in a few operations can lose, beside [`error`](Self::error).
    const UNDERFLOW: Self = Self::ZERO;

    /// Whether the number is zero.
    #[inline(always)]
    fn is_zero(&self) -> bool {
        *self == Self::ZERO
    }

    /// Whether the number is above zero.
    #[inline(always)]
    fn is_positive(&self) -> bool {
        *self > Self::ZERO
    }

    /// The absolute value.
    fn magnitude(self) -> Self;

    /// One half of the number; an odd integer rounds down.
    fn half(self) -> Self;

    /// The error of a computed number of this size: `roundoffs` times the unit roundoff times the
    /// size. Zero if nothing is rounded, or if the method accepts rounding.
    #[inline(always)]
    fn error(self, roundoffs: u16) -> Self {
        let _ = roundoffs;
        Self::ZERO
    }

    /// Whether the true number is certainly zero or below, if it differs from this one by at most
    /// `error`. The default is for numbers without rounding.
    #[inline(always)]
    fn is_not_above(self, error: Self) -> bool {
        let _ = error;
        self <= Self::ZERO
    }

    /// Whether products of numbers of this size stay in their type and within their
    /// [`error`](Self::error): nothing overflows, and underflow does not matter.
    #[inline(always)]
    fn in_range(self) -> bool {
        true
    }

    /// Two numbers that enclose self/den, given the errors of the two. If nothing is rounded, the
    /// caller promises 0 < self ≤ den, and both are the quotient rounded down.
    #[inline(always)]
    fn portion(self, den: Self, errors: [Self; 2]) -> [Soft; 2] {
        let _ = (den, errors);
        [Soft::ZERO, Soft::ONE]
    }

    /// Sign and size of an exact number; `None` for zero, and for numbers that are rounded.
    #[inline(always)]
    fn sign_and_size(self) -> Option<(Ordering, Soft)> {
        None
    }
}

/// A number of several limbs.
pub trait Limbed {
    /// The number in two's complement, the least limb first.
    fn limbs(&self) -> &[u64];
}

/// Sign and size of a number that is not zero, from its sign and magnitude.
pub(super) fn signed<const L: usize>(
    (is_negative, limbs): (bool, [u64; L]),
) -> Option<(Ordering, Soft)> {
    let sign = if is_negative { Ordering::Less } else { Ordering::Greater };
    Some((sign, Soft::of_limbs(&limbs)?))
}

macro_rules! integer {
    ($($t:ty: $divided:ident, |$x:ident| $in_range:expr;)*) => {$(
        impl Number for $t {
            const ZERO: Self = 0;
            #[inline(always)]
            fn magnitude(self) -> Self {
                self.abs()
            }
            #[inline(always)]
            fn half(self) -> Self {
                self >> 1
            }
            #[inline(always)]
            fn in_range(self) -> bool {
                let $x = self;
                $in_range
            }
            #[inline(always)]
            fn portion(self, den: Self, _: [Self; 2]) -> [Soft; 2] {
                debug_assert!(self > 0 && self <= den);
                [$divided(self.unsigned_abs().into(), den.unsigned_abs().into()); 2]
            }
            #[cfg_attr(target_pointer_width = "64", inline(always))]
            fn sign_and_size(self) -> Option<(Ordering, Soft)> {
                let sign = self.cmp(&0);
                sign.is_ne().then(|| (sign, Soft::of(self.unsigned_abs().into(), 0, 0)))
            }
        }
    )*};
}
integer! {
    i32: divided_short, |_size| true;
    i64: divided_short, |_size| true;
    // As an operand of sums of at most 30 products of four.
    i128: divided, |size| size <= 1 << 30;
}

/// How two numbers compare; none is NaN.
#[inline(always)]
pub(crate) fn compare<T: PartialOrd>(a: T, b: T) -> Ordering {
    if a < b {
        Ordering::Less
    } else if a > b {
        Ordering::Greater
    } else {
        Ordering::Equal
    }
}

/// How a number compares with zero. For long numbers this is much code, and the compiler decides
/// whether to inline it.
pub(crate) fn sign<T: Number>(x: T) -> Ordering {
    compare(x, T::ZERO)
}

/// The smaller of two numbers. On x86-64 this form is one instruction; `f32::min`, which must treat
/// NaN, takes several.
#[inline(always)]
pub(crate) fn least<T: PartialOrd>(a: T, b: T) -> T {
    if a < b { a } else { b }
}

/// The greater of two numbers; see [`least`].
#[inline(always)]
pub(crate) fn greatest<T: PartialOrd>(a: T, b: T) -> T {
    if a > b { a } else { b }
}

/// The greatest magnitude of three numbers.
#[inline(always)]
pub(crate) fn largest<T: Number>(x: &[T; 3]) -> T {
    greatest(greatest(x[0].magnitude(), x[1].magnitude()), x[2].magnitude())
}
