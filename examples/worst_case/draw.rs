//! Numbers, the same on every board.

use fixed::types::{I4F4, I8F8, I16F16, I32F32};
use septum::{Scalar, Vec3};

/// A scalar made from integers.
pub(crate) trait Raw: Scalar {
    const NAME: &'static str;
    /// The number of bits of a number, with the sign.
    const BITS: u32;

    /// The number with these bits; in floats, a number of units of 2⁻¹⁶.
    fn of(bits: i64) -> Self;
    /// One, or the nearest number.
    fn one() -> i64;
    /// Any number, from its bits.
    fn any(bits: i64) -> Self {
        Self::of(bits)
    }
}

macro_rules! fixed {
    ($($fixed:ident, $raw:ident;)*) => {$(
        impl Raw for $fixed {
            const NAME: &'static str = stringify!($fixed);
            const BITS: u32 = $raw::BITS;

            fn of(bits: i64) -> Self {
                Self::from_bits(bits.clamp($raw::MIN.into(), $raw::MAX.into()) as $raw)
            }
            fn one() -> i64 {
                1 << Self::FRAC_NBITS
            }
        }
    )*};
}
fixed! {
    I4F4, i8;
    I8F8, i16;
    I16F16, i32;
    I32F32, i64;
}

impl Raw for f32 {
    const NAME: &'static str = "f32";
    const BITS: u32 = 32;

    fn of(bits: i64) -> Self {
        bits as f32 / 65536.0
    }
    fn one() -> i64 {
        65536
    }
    fn any(bits: i64) -> Self {
        let any = Self::from_bits(bits as u32);
        if any.is_finite() { any } else { 1.0 }
    }
}

/// The ways to draw coordinates.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(crate) enum Path {
    Random,
    Contact,
    OffByOne,
    Ends,
    Far,
}

impl Path {
    pub(crate) const ALL: [Self; 5] =
        [Self::Random, Self::Contact, Self::OffByOne, Self::Ends, Self::Far];

    pub(crate) fn name(self) -> &'static str {
        match self {
            Self::Random => "random",
            Self::Contact => "contact",
            Self::OffByOne => "off by one",
            Self::Ends => "ends",
            Self::Far => "far",
        }
    }
}

/// Xorshift, 64 bits (G. Marsaglia, "Xorshift RNGs", 2003).
pub(crate) struct Rng(u64);

impl Rng {
    pub(crate) fn new() -> Self {
        Self(0x5e97_0a11)
    }

    fn bits(&mut self) -> u64 {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        self.0
    }

    /// An integer below n.
    pub(crate) fn below(&mut self, n: u32) -> i64 {
        (((self.bits() >> 32) * u64::from(n)) >> 32) as i64
    }

    /// An integer of `bits` bits without its sign.
    fn within(&mut self, bits: u32) -> i64 {
        (self.bits() as i64) >> (63 - bits)
    }
}

/// Draws coordinates of one path, with a limit on the bits of each number.
pub(crate) struct Draw {
    pub(crate) rng: Rng,
    pub(crate) path: Path,
    pub(crate) most: u32,
}

impl Draw {
    fn coordinate(&mut self) -> i64 {
        let Self { rng, path, most } = self;
        let near = 16.min(*most - 1);
        match path {
            Path::Random => rng.within(near),
            Path::Contact => (rng.below(5) - 2) << (near - 2),
            Path::OffByOne => ((rng.below(5) - 2) << (near - 2)) + rng.below(3) - 1,
            Path::Ends => {
                let end = ((1_i128 << *most) - 1) as i64;
                [!end, end, 0, 1, -1, end >> 1][rng.below(6) as usize]
            }
            Path::Far => rng.within(*most),
        }
    }

    pub(crate) fn point(&mut self) -> [i64; 3] {
        [self.coordinate(), self.coordinate(), self.coordinate()]
    }

    /// A point in a scalar.
    pub(crate) fn vector<S: Raw>(&self, point: [i64; 3]) -> Vec3<S> {
        Vec3::from(point.map(if self.path == Path::Far { S::any } else { S::of }))
    }
}
