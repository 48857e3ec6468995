//! The numbers of C, and their types in Rust.

use fixed::types;
use septum::Scalar;

/// Fixed point of 8 fraction bits: a number times 256.
pub type I8F8 = i16;
/// Fixed point of 16 fraction bits: a number times 65,536.
pub type I16F16 = i32;

/// A number in C.
pub trait Number: Copy + PartialEq {
    type Scalar: Scalar;

    /// Tells it from the other types, also of its size.
    const TAG: u8;

    /// The numbers that stand for an unbounded range: as its start, and as its end.
    const UNBOUNDED: [Self; 2];

    fn scalar(self) -> Self::Scalar;
    fn raw(scalar: Self::Scalar) -> Self;
}

macro_rules! floats {
    ($($number:ty = $tag:literal)*) => {$(
        impl Number for $number {
            type Scalar = Self;

            const TAG: u8 = $tag;
            const UNBOUNDED: [Self; 2] = [Self::NEG_INFINITY, Self::INFINITY];

            fn scalar(self) -> Self {
                self
            }

            fn raw(scalar: Self) -> Self {
                scalar
            }
        }
    )*};
}
floats! { f32 = 1 f64 = 2 }

macro_rules! fixed_point {
    ($($number:ident = $tag:literal)*) => {$(
        impl Number for $number {
            type Scalar = types::$number;

            const TAG: u8 = $tag;
            const UNBOUNDED: [Self; 2] = [Self::MIN, Self::MAX];

            fn scalar(self) -> Self::Scalar {
                Self::Scalar::from_bits(self)
            }

            fn raw(scalar: Self::Scalar) -> Self {
                scalar.to_bits()
            }
        }
    )*};
}
fixed_point! { I8F8 = 3 I16F16 = 4 }
