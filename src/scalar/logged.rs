//! Logging of a scalar. This is a supertrait of `Scalar`, so it is here rather than with the
//! logging of shapes.

use defmt::{Formatter, write};
#[cfg(feature = "fixed")]
use fixed::traits::Fixed;

#[cfg(feature = "fixed")]
use crate::arithmetic::InRaw;

/// A scalar that can be logged; every scalar can.
pub(crate) trait Logged: Sized {
    /// Writes the number.
    fn log(self, to: Formatter<'_>);
}

impl Logged for f32 {
    fn log(self, to: Formatter<'_>) {
        write!(to, "{=f32}", self);
    }
}

impl Logged for f64 {
    fn log(self, to: Formatter<'_>) {
        write!(to, "{=f64}", self);
    }
}

#[cfg(feature = "fixed")]
impl<S: InRaw + Fixed> Logged for S {
    fn log(self, to: Formatter<'_>) {
        if S::BITS <= 16 {
            write!(to, "{=f32}", self.to_num());
        } else {
            write!(to, "{=f64}", self.to_num());
        }
    }
}
