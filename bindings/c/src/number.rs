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

    /// The numbers that stand for an unbounded range: as its start, and as its end.
    const UNBOUNDED: [Self; 2];

    fn scalar(self) -> Self::Scalar;
    fn raw(scalar: Self::Scalar) -> Self;
}

impl Number for f32 {
    type Scalar = Self;

    const UNBOUNDED: [Self; 2] = [Self::NEG_INFINITY, Self::INFINITY];

    fn scalar(self) -> Self {
        self
    }

    fn raw(scalar: Self) -> Self {
        scalar
    }
}

impl Number for f64 {
    type Scalar = Self;

    const UNBOUNDED: [Self; 2] = [Self::NEG_INFINITY, Self::INFINITY];

    fn scalar(self) -> Self {
        self
    }

    fn raw(scalar: Self) -> Self {
        scalar
    }
}

impl Number for I8F8 {
    type Scalar = types::I8F8;

    const UNBOUNDED: [Self; 2] = [Self::MIN, Self::MAX];

    fn scalar(self) -> types::I8F8 {
        types::I8F8::from_bits(self)
    }

    fn raw(scalar: types::I8F8) -> Self {
        scalar.to_bits()
    }
}

impl Number for I16F16 {
    type Scalar = types::I16F16;

    const UNBOUNDED: [Self; 2] = [Self::MIN, Self::MAX];

    fn scalar(self) -> types::I16F16 {
        types::I16F16::from_bits(self)
    }

    fn raw(scalar: types::I16F16) -> Self {
        scalar.to_bits()
    }
}
