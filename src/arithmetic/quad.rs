//! Four floats at once. Queries of two shapes use three lanes and ignore the fourth; trees and
//! voxels use all four.

use core::fmt::Debug;
use core::ops::{Add, Div, Mul, Sub};

use super::number::{Number, greatest};

#[cfg_attr(
    all(
        feature = "simd",
        any(target_feature = "sse2", target_feature = "neon", target_feature = "simd128")
    ),
    path = "quad/vector.rs"
)]
// Without vectors quad/machine.rs: four numbers.
mod machine;

pub(crate) use machine::root_of_machine;

/// Four floats side by side. Each lane of a result equals the result of the float's own operation,
/// so an answer does not depend on the representation of a quad.
pub trait Quad:
    Copy + Debug + Add<Output = Self> + Sub<Output = Self> + Mul<Output = Self> + Div<Output = Self>
{
    /// The type of a lane.
    type Lane: Number;

    /// Whether it is a vector of the machine; otherwise it is four numbers.
    const IS_VECTOR: bool;

    /// A quad of these lanes.
    fn new(lanes: [Self::Lane; 4]) -> Self;
    /// The lanes.
    fn to_array(self) -> [Self::Lane; 4];
    /// The absolute values.
    fn magnitude(self) -> Self;
    /// The smaller of each two lanes. No lane is NaN.
    fn least(self, other: Self) -> Self;
    /// The greater of each two lanes. No lane is NaN.
    fn greatest(self, other: Self) -> Self;
    /// The lanes in which this is the greater, as bits, the first lane lowest.
    fn exceeds(self, other: Self) -> u32;
    /// The lanes in which this is at most `other`, likewise; false if either is NaN.
    fn is_at_most(self, other: Self) -> u32;

    /// The lanes in which the true number may be above zero, if it differs from this one by at most
    /// `error`. An infinite or NaN error leaves it possible.
    #[inline(always)]
    fn may_be_above(self, error: Self) -> u32 {
        !(self + error).is_at_most(Self::splat(Self::Lane::ZERO))
    }

    /// The same number in all lanes.
    #[inline(always)]
    fn splat(x: Self::Lane) -> Self {
        Self::new([x; 4])
    }

    /// Three numbers and an unused fourth.
    #[inline(always)]
    fn of_three([x, y, z]: [Self::Lane; 3]) -> Self {
        Self::new([x, y, z, z])
    }

    /// The first three lanes.
    #[inline(always)]
    fn three(self) -> [Self::Lane; 3] {
        let [x, y, z, _] = self.to_array();
        [x, y, z]
    }

    /// The greatest of the first three lanes.
    #[inline(always)]
    fn most(self) -> Self::Lane {
        let [x, y, z] = self.three();
        greatest(greatest(x, y), z)
    }

    /// The dot product of the first three lanes, summed in order.
    #[inline(always)]
    fn dot(self, other: Self) -> Self::Lane {
        let [x, y, z] = (self * other).three();
        x + y + z
    }

    /// A half of each lane.
    #[inline(always)]
    fn halved(self) -> Self
    where
        Self::Lane: From<u16>,
    {
        self * Self::splat(Self::Lane::from(1).half())
    }

    /// (y, z, x).
    #[inline(always)]
    fn turned(self) -> Self {
        let [x, y, z, w] = self.to_array();
        Self::new([y, z, x, w])
    }
}

/// The first three lanes, as a mask of comparisons.
pub(crate) const THREE: u32 = 0b111;

/// A float with a quad.
pub trait OfFour: Copy + Debug {
    /// Four of the float.
    type Quad: Quad<Lane = Self>;
}
