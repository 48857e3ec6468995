//! The numbers of the simulation: I16F16, in which everything between the queries is integers, or
//! `f32`.

use core::ops::{Add, Div, Mul, Neg, Sub};

use fixed::types::{I16F16, I32F32};
use septum::Scalar;

/// Each constant once, as a literal of both types.
macro_rules! constants {
    ($($(#[$doc:meta])* $name:ident = $value:literal;)*) => {
        pub(crate) trait Constants: Sized {
            $($(#[$doc])* const $name: Self;)*
        }

        impl Constants for I16F16 {
            $(const $name: Self = Self::lit(stringify!($value));)*
        }

        impl Constants for f32 {
            $(const $name: Self = $value;)*
        }
    };
}

// Units: metre, second, and the mass of a cube of half a metre.
constants! {
    HALF = 0.5;
    ONE = 1.0;
    /// Ticks a second.
    RATE = 60.0;
    /// Gains of speed in a tick: by gravity, and by a player.
    GRAVITY = 0.1635;
    THRUST = 0.24;
    /// The part of the speed that a tick leaves.
    DRAG = 0.995;
    /// The greatest speed along an axis, and about one: no sum overflows in I16F16.
    FASTEST = 128.0;
    /// The speed below which a body is calm.
    STILL = 0.19;
    /// The speed above which a body wakes the bodies that it touches.
    WAKES = 1.2;
    /// The depth that a contact may keep, so that it persists in the next tick.
    SLOP = 0.004;
    /// The speed of parting for each metre of a greater depth, and the greatest such speed.
    PARTING = 12.0;
    PARTING_AT_MOST = 0.6;
    FRICTION = 0.6;
}

/// A scalar of septum with the arithmetic of the simulation.
pub(crate) trait Number:
    Scalar
    + Constants
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Div<Output = Self>
    + Neg<Output = Self>
{
    /// A number that both types hold, or nearly: a place of the level, a sine.
    fn of(number: I16F16) -> Self;

    /// Back to I16F16, for checks.
    fn rounded(self) -> I16F16;

    fn dot(a: [Self; 3], b: [Self; 3]) -> Self;

    fn length(vector: &[Self]) -> Self;

    fn bits(self) -> u32;
}

/// The sum is rounded, and not its products.
fn sum_of_products(a: &[I16F16], b: &[I16F16]) -> I32F32 {
    let products = a.iter().zip(b).map(|(&a, &b)| a.wide_mul(b));
    products.fold(I32F32::ZERO, I32F32::saturating_add)
}

impl Number for I16F16 {
    fn of(number: I16F16) -> Self {
        number
    }

    fn rounded(self) -> I16F16 {
        self
    }

    fn dot(a: [Self; 3], b: [Self; 3]) -> Self {
        sum_of_products(&a, &b).saturating_to_num()
    }

    fn length(vector: &[Self]) -> Self {
        sum_of_products(vector, vector).sqrt().saturating_to_num()
    }

    fn bits(self) -> u32 {
        self.to_bits() as u32
    }
}

/// Sums and products in one order, so that every machine gives the same bits.
impl Number for f32 {
    fn of(number: I16F16) -> Self {
        number.to_num()
    }

    fn rounded(self) -> I16F16 {
        I16F16::saturating_from_num(self)
    }

    fn dot(a: [Self; 3], b: [Self; 3]) -> Self {
        a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
    }

    /// The root by Newton's method, because `core` has none.
    fn length(vector: &[Self]) -> Self {
        let square = vector.iter().fold(0.0, |sum, x| sum + x * x);
        if square <= 0.0 {
            return 0.0;
        }
        // Half the exponent is within a factor of two.
        let mut root = f32::from_bits((square.to_bits() >> 1) + (0x3f80_0000 >> 1));
        for _ in 0..4 {
            root = 0.5 * (root + square / root);
        }
        root
    }

    fn bits(self) -> u32 {
        self.to_bits()
    }
}

/// A ratio of small numbers.
pub(crate) fn ratio<T: Number>(numerator: usize, denominator: usize) -> T {
    T::of(I16F16::saturating_from_num(numerator) / I16F16::saturating_from_num(denominator))
}
