//! Logging of a scalar. This is a supertrait of `Scalar`, so it is here rather than with the
//! logging of shapes.

use defmt::{Formatter, write};

/// A scalar that can be logged; every scalar can.
pub(crate) trait Logged: Sized {
    /// Writes the number.
    fn log(self, to: Formatter<'_>);
}

macro_rules! logged {
    ($([$($generic:ident: $bound:ident)?] $scalar:ty, $format:literal, |$x:ident| $number:expr;)*) => {$(
        impl<$($generic: fixed::types::extra::$bound)?> Logged for $scalar {
            fn log(self, to: Formatter<'_>) {
                let $x = self;
                write!(to, $format, $number);
            }
        }
    )*};
}
logged! {
    [] f32, "{=f32}", |x| x;
    [] f64, "{=f64}", |x| x;
}
#[cfg(feature = "fixed")]
logged! {
    [Frac: LeEqU8] fixed::FixedI8<Frac>, "{=f32}", |x| x.to_num();
    [Frac: LeEqU16] fixed::FixedI16<Frac>, "{=f32}", |x| x.to_num();
    [Frac: LeEqU32] fixed::FixedI32<Frac>, "{=f64}", |x| x.to_num();
    [Frac: LeEqU64] fixed::FixedI64<Frac>, "{=f64}", |x| x.to_num();
}
