//! The numbers of C, and their types in Rust.

use fixed::types;
use septum::Scalar;

/// Fixed point of 8 fraction bits: a number times 256.
pub type I8F8 = i16;
/// Fixed point of 16 fraction bits: a number times 65,536.
pub type I16F16 = i32;

/// A number in C.
pub trait Number: Copy {
    type Scalar: Scalar;

    fn scalar(self) -> Self::Scalar;
    fn raw(scalar: Self::Scalar) -> Self;
    /// The end of a range, or `None` if the range is unbounded.
    fn end(self) -> Option<Self::Scalar>;
}

impl Number for f32 {
    type Scalar = Self;

    fn scalar(self) -> Self {
        self
    }

    fn raw(scalar: Self) -> Self {
        scalar
    }

    fn end(self) -> Option<Self> {
        if self.is_infinite() { None } else { Some(self) }
    }
}

impl Number for f64 {
    type Scalar = Self;

    fn scalar(self) -> Self {
        self
    }

    fn raw(scalar: Self) -> Self {
        scalar
    }

    fn end(self) -> Option<Self> {
        if self.is_infinite() { None } else { Some(self) }
    }
}

impl Number for I8F8 {
    type Scalar = types::I8F8;

    fn scalar(self) -> types::I8F8 {
        types::I8F8::from_bits(self)
    }

    fn raw(scalar: types::I8F8) -> Self {
        scalar.to_bits()
    }

    fn end(self) -> Option<types::I8F8> {
        if self == Self::MAX || self == Self::MIN { None } else { Some(self.scalar()) }
    }
}

impl Number for I16F16 {
    type Scalar = types::I16F16;

    fn scalar(self) -> types::I16F16 {
        types::I16F16::from_bits(self)
    }

    fn raw(scalar: types::I16F16) -> Self {
        scalar.to_bits()
    }

    fn end(self) -> Option<types::I16F16> {
        if self == Self::MAX || self == Self::MIN { None } else { Some(self.scalar()) }
    }
}
