//! What every machine number here can do, and nothing that rounds.

use core::ops::{Add, Neg, Sub};

/// A number that a geometric quantity is held in: it can be added, subtracted,
/// negated and compared. Products are not here: they belong to the
/// [`Numbers`](super::Numbers), which know in what type a product fits.
pub trait Number:
    Copy + PartialOrd + Add<Output = Self> + Sub<Output = Self> + Neg<Output = Self>
{
    /// Nought.
    const ZERO: Self;

    /// The absolute value.
    fn magnitude(self) -> Self;
}

macro_rules! number {
    ($($t:ty: $zero:expr, $abs:expr;)*) => {$(
        impl Number for $t {
            const ZERO: Self = $zero;
            #[inline(always)]
            fn magnitude(self) -> Self {
                $abs(self)
            }
        }
    )*};
}
number! {
    i32: 0, i32::abs;
    i64: 0, i64::abs;
    i128: 0, i128::abs;
    f32: 0.0, f32::abs;
    f64: 0.0, f64::abs;
}

/// The smaller of two numbers. On x86-64 this form is one instruction, where
/// `f32::min`, which must think of NaN, is several.
#[inline(always)]
pub(crate) fn least<T: PartialOrd>(a: T, b: T) -> T {
    if a < b { a } else { b }
}

/// The greater of two numbers; see [`least`].
#[inline(always)]
pub(crate) fn greatest<T: PartialOrd>(a: T, b: T) -> T {
    if a > b { a } else { b }
}
