//! Quads for machines with vectors, by the crate `wide`.

use super::{OfFour, Quad};

macro_rules! quad {
    ($vector:ident, $float:ident) => {
        impl OfFour for $float {
            type Quad = wide::$vector;
        }

        impl Quad for wide::$vector {
            type Lane = $float;
            const IS_VECTOR: bool = true;

            #[inline(always)]
            fn new(lanes: [$float; 4]) -> Self {
                Self::new(lanes)
            }
            #[inline(always)]
            fn to_array(self) -> [$float; 4] {
                self.to_array()
            }
            #[inline(always)]
            fn magnitude(self) -> Self {
                self.abs()
            }
            #[inline(always)]
            fn least(self, other: Self) -> Self {
                self.fast_min(other)
            }
            #[inline(always)]
            fn greatest(self, other: Self) -> Self {
                self.fast_max(other)
            }
            #[inline(always)]
            fn exceeds(self, other: Self) -> u32 {
                self.simd_gt(other).to_bitmask()
            }
            #[inline(always)]
            fn is_at_most(self, other: Self) -> u32 {
                self.simd_le(other).to_bitmask()
            }
        }
    };
}
quad!(f32x4, f32);
quad!(f64x4, f64);

/// The square root of a normal float above zero, within two unit roundoffs; not the same on every
/// machine.
#[inline(always)]
pub(crate) fn root_of_machine(x: f64) -> f64 {
    let [root, _] = wide::f64x2::splat(x).sqrt().to_array();
    root
}
