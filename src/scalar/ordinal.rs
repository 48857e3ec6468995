//! The numbers of a scalar in their order.

/// A number for each value of a scalar, adjacent values numbered adjacently. Sealed, as
/// [`Backend`](super::Backend).
pub(crate) trait Ordinal: Copy {
    /// The number of a finite value. Both zeros are number zero.
    fn ordinal(self) -> i64;

    /// The value of a number; beyond the greatest float there is infinity.
    fn of_ordinal(n: i64) -> Self;
}

macro_rules! float {
    ($float:ident, $signed:ident) => {
        impl Ordinal for $float {
            #[inline]
            fn ordinal(self) -> i64 {
                let bits = self.to_bits() as $signed;
                let size = i64::from(bits & $signed::MAX);
                if bits < 0 { -size } else { size }
            }
            #[inline]
            fn of_ordinal(n: i64) -> Self {
                let size = Self::from_bits(n.unsigned_abs() as _);
                if n < 0 { -size } else { size }
            }
        }
    };
}
float!(f32, i32);
float!(f64, i64);

#[cfg(feature = "fixed")]
macro_rules! fixed {
    ($($fixed:ident, $bound:ident;)*) => {$(
        impl<Frac: fixed::types::extra::$bound> Ordinal for fixed::$fixed<Frac> {
            #[inline]
            fn ordinal(self) -> i64 {
                self.to_bits().into()
            }
            #[inline]
            fn of_ordinal(n: i64) -> Self {
                Self::from_bits(n as _)
            }
        }
    )*};
}
#[cfg(feature = "fixed")]
fixed! {
    FixedI8, LeEqU8;
    FixedI16, LeEqU16;
    FixedI32, LeEqU32;
    FixedI64, LeEqU64;
}
