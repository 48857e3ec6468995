//! Numbers from random bits, the same on every machine.

use fixed::types::{I4F4, I8F8, I16F16, I32F32};
use septum::{Scalar, Triangle, Vec3};

/// SplitMix64 (G. L. Steele, D. Lea, C. H. Flood, "Fast Splittable Pseudorandom
/// Number Generators", OOPSLA 2014).
pub(crate) struct Rng(u64);

impl Rng {
    pub(crate) fn new(seed: u64) -> Self {
        Self(seed)
    }

    fn bits(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let z = (self.0 ^ (self.0 >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        let z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }

    /// A number from 0 to n − 1.
    pub(crate) fn below(&mut self, n: u32) -> u32 {
        ((u64::from(self.bits() as u32) * u64::from(n)) >> 32) as u32
    }

    /// An integer from −n to n.
    fn within(&mut self, n: u32) -> i32 {
        self.below(2 * n + 1) as i32 - n as i32
    }
}

/// A scalar that can be drawn and hashed.
pub(crate) trait Draw: Scalar {
    /// A number of one of six kinds: on a coarse grid; on a fine grid; on a mix of a fine and a
    /// small grid; of any magnitude; at the ends of the range; at its least steps.
    fn draw(rng: &mut Rng, kind: u8) -> Self;

    /// All bits of the number; every NaN gives the same bits.
    fn bits(self) -> u64;

    /// The magnitude, or the greatest number if the magnitude overflows.
    fn size(self) -> Self;

    /// The sum of the halves of both numbers.
    fn middle(self, other: Self) -> Self;

    /// The difference, kept within the range.
    fn minus(self, other: Self) -> Self;

    /// The unit normal by integers, in the scalars that have it.
    fn unit_normal(_triangle: &Triangle<Self>) -> Option<Option<Vec3<Self>>> {
        None
    }
}

macro_rules! float {
    ($float:ident) => {
        impl Draw for $float {
            fn draw(rng: &mut Rng, kind: u8) -> Self {
                let ends = [$float::MAX, $float::MAX / 2.0, 1.0, 0.0, $float::MIN_POSITIVE];
                let steps = [$float::MIN_POSITIVE, $float::from_bits(1), 1.0, 0.0];
                let positive = match kind {
                    0 => rng.within(4) as $float,
                    1 => rng.within(1 << 20) as $float / 65536.0,
                    2 if rng.below(2) == 0 => rng.within(2) as $float,
                    2 => rng.within(1 << 20) as $float / 262144.0,
                    3 => loop {
                        let x = $float::from_bits(rng.bits() as _);
                        if x.is_finite() {
                            break x;
                        }
                    },
                    4 => ends[rng.below(ends.len() as u32) as usize],
                    // Up to 64 steps of the least subnormal, or at another number.
                    _ => {
                        let few = $float::from_bits(rng.below(64).into());
                        if rng.below(2) == 0 {
                            few
                        } else {
                            steps[rng.below(steps.len() as u32) as usize]
                        }
                    }
                };
                if rng.below(2) == 0 { positive } else { -positive }
            }
            fn bits(self) -> u64 {
                // NaNs differ between machines.
                if self.is_nan() { $float::NAN.to_bits().into() } else { self.to_bits().into() }
            }
            fn size(self) -> Self {
                self.abs()
            }
            fn middle(self, other: Self) -> Self {
                self / 2.0 + other / 2.0
            }
            fn minus(self, other: Self) -> Self {
                (self - other).clamp($float::MIN, $float::MAX)
            }
        }
    };
}
float!(f32);
float!(f64);

macro_rules! fixed {
    ($($fixed:ident: $int:ident;)*) => {$(
        impl Draw for $fixed {
            fn draw(rng: &mut Rng, kind: u8) -> Self {
                // Half the bits, because the fraction loses the products of the other half.
                let half = 1 << ($int::BITS / 2);
                let ends = [$int::MAX, $int::MIN, $int::MAX / 2, $int::MIN / 2, 0, 1, -1];
                $fixed::from_bits(match kind {
                    0 => rng.within(4) as $int * (half / 4),
                    1 => rng.within(1 << ($int::BITS / 2 + 2).min(20)) as $int,
                    2 if rng.below(2) == 0 => rng.within(2) as $int * (half / 4),
                    2 => rng.within(1 << ($int::BITS / 2).min(20)) as $int,
                    3 => rng.bits() as $int,
                    4 => ends[rng.below(ends.len() as u32) as usize],
                    _ => rng.within(3) as $int,
                })
            }
            fn bits(self) -> u64 {
                i64::from(self.to_bits()) as u64
            }
            fn size(self) -> Self {
                self.saturating_abs()
            }
            fn middle(self, other: Self) -> Self {
                $fixed::from_bits((self.to_bits() >> 1) + (other.to_bits() >> 1))
            }
            fn minus(self, other: Self) -> Self {
                self.saturating_sub(other)
            }
            fn unit_normal(triangle: &Triangle<Self>) -> Option<Option<Vec3<Self>>> {
                Some(triangle.unit_normal())
            }
        }
    )*};
}
fixed! { I4F4: i8; I8F8: i16; I16F16: i32; I32F32: i64; }
