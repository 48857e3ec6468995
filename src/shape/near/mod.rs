//! Shapes that have been checked to be near the origin.

#[cfg(feature = "fixed")]
mod fixed;

use super::overlaps::Overlaps;
use crate::shape::aabb::Form;
use crate::shape::{Aabb, ShapeError, Triangle, Vec3};

/// A shape near the origin: see [`near`](crate::near).
///
/// `near` of `Triangle`, `Ray`, `Segment`, `Aabb`, `Obb`, `Sphere`, `Capsule` and `mesh::Tree` makes one.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[repr(transparent)]
pub struct Near<T>(T);

impl<T> Near<T> {
    /// A shape that is known to be near.
    #[cfg(feature = "fixed")]
    #[inline(always)]
    pub(crate) const fn unchecked(shape: T) -> Self {
        Self(shape)
    }

    #[inline(always)]
    pub(crate) const fn checked(shape: T, is_near: bool) -> Result<Self, ShapeError>
    where
        T: Copy,
    {
        if is_near { Ok(Self(shape)) } else { Err(ShapeError::NotNear) }
    }

    /// The ordinary shape.
    #[inline]
    #[must_use]
    pub const fn get(&self) -> &T {
        &self.0
    }

    /// Do the two shapes have a point in common? Exact: the answer of the ordinary shapes.
    #[doc(alias = "intersects")]
    #[must_use]
    #[inline]
    pub fn overlaps<Other>(&self, other: &Near<Other>) -> bool
    where
        Self: Overlaps<Near<Other>>,
    {
        Overlaps::overlaps(self, other)
    }

    /// May the two shapes have a point in common? Never `false` if they have.
    #[doc(alias = "intersects")]
    #[must_use]
    #[inline]
    pub fn may_overlap<Other>(&self, other: &Near<Other>) -> bool
    where
        Self: Overlaps<Near<Other>>,
    {
        Overlaps::may_overlap(self, other)
    }
}

/// Coordinates are below two to this power.
const MOST: u32 = 10;
/// They are multiples of two to minus this power. Together these are the 60 bits that
/// [`Int64`](crate::arithmetic::Int64) takes.
const LEAST: u32 = 50;

/// Whether a number is in the range. An infinity and a NaN are not.
const fn fits(x: f32) -> bool {
    const STORED: u32 = f32::MANTISSA_DIGITS - 1;
    const BIAS: u32 = f32::MAX_EXP as u32 - 1;
    let magnitude = x.to_bits() & !(1 << 31);
    // Zeros at the end, at most as many as a power of two has.
    let (exponent, zeros) = (magnitude >> STORED, magnitude.trailing_zeros());
    let zeros = if zeros < STORED { zeros } else { STORED };
    magnitude == 0 || exponent < BIAS + MOST && exponent + zeros >= BIAS + STORED - LEAST
}

const fn all_fit(v: &Vec3<f32>) -> bool {
    fits(v.x) && fits(v.y) && fits(v.z)
}

impl Triangle<f32> {
    /// The triangle, for queries in `f32` and 64-bit integers alone: see [`near`](crate::near).
    ///
    /// # Errors
    /// [`ShapeError::NotNear`] if a coordinate is 1024 or more from zero, or no multiple of 2⁻⁵⁰.
    pub const fn near(self) -> Result<Near<Self>, ShapeError> {
        let [a, b, c] = &self.vertices;
        Near::checked(self, all_fit(a) && all_fit(b) && all_fit(c))
    }
}

impl Aabb<f32> {
    /// The box, for queries in `f32` and 64-bit integers alone: see [`near`](crate::near).
    ///
    /// # Errors
    /// [`ShapeError::NotNear`] if a number that the box was made from is 1024 or more from zero, or
    /// no multiple of 2⁻⁵⁰.
    pub const fn near(self) -> Result<Near<Self>, ShapeError> {
        let (Form::Center { center: p, half: q } | Form::Corners { min: p, max: q }) = &self.form;
        Near::checked(self, all_fit(p) && all_fit(q))
    }
}
