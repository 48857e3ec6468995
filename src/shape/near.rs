//! Shapes that were checked to be near the origin.

use fixed::FixedI32;
use fixed::types::extra::LeEqU32;

use super::aabb::Form;
use super::overlaps::Overlaps;
use super::{Aabb, Obb, Ray, ShapeError, Triangle, Vec3};

/// A shape near the origin: see [`near`](crate::near).
///
/// Made by [`Triangle::near`], [`Ray::near`], [`Aabb::near`] and [`Obb::near`].
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[repr(transparent)]
pub struct Near<T>(T);

impl<T> Near<T> {
    /// The shape as it was.
    #[inline]
    #[must_use]
    pub const fn get(&self) -> &T {
        &self.0
    }

    /// Whether the shape has a point in common with another that is near. Exact; the same
    /// answer as that of the shapes as they were.
    #[doc(alias = "intersects")]
    #[must_use]
    #[inline]
    pub fn overlaps<Other>(&self, other: &Near<Other>) -> bool
    where
        Self: Overlaps<Near<Other>>,
    {
        Overlaps::overlaps(self, other)
    }

    /// Whether the two may have a point in common: never `false` if they have.
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

/// How many bits a coordinate has beside its sign. Two of them are less than 2^18 apart, which is
/// what the kernel for an axis-aligned box has room for on every core.
const POSITION: u32 = 17;
/// The same of a direction, an axis or a half-extent: what volumes have room for.
const LENGTH: u32 = 19;

const fn fits(bits: i32, most: u32) -> bool {
    (bits ^ (bits >> 31)) >> most == 0
}

const fn all_fit<Frac: LeEqU32>(v: &Vec3<FixedI32<Frac>>, most: u32) -> bool {
    fits(v.x.to_bits(), most) && fits(v.y.to_bits(), most) && fits(v.z.to_bits(), most)
}

/// Whether c − h and c + h fit.
const fn ends_fit<Frac: LeEqU32>(c: FixedI32<Frac>, h: FixedI32<Frac>) -> bool {
    let (c, h) = (c.to_bits(), h.to_bits());
    fits(c, POSITION) && fits(h, LENGTH) && fits(c - h, POSITION) && fits(c + h, POSITION)
}

impl<Frac: LeEqU32> Triangle<FixedI32<Frac>> {
    /// The triangle, for queries in 32-bit words alone: see [`near`](crate::near).
    ///
    /// # Errors
    /// [`ShapeError::NotNear`] where a vertex is 2¹⁷ units in the last place or more from zero on
    /// some axis.
    pub const fn near(self) -> Result<Near<Self>, ShapeError> {
        let [a, b, c] = &self.vertices;
        if all_fit(a, POSITION) && all_fit(b, POSITION) && all_fit(c, POSITION) {
            Ok(Near(self))
        } else {
            Err(ShapeError::NotNear)
        }
    }
}

impl<Frac: LeEqU32> Ray<FixedI32<Frac>> {
    /// The ray, for queries in 32-bit words alone: see [`near`](crate::near). Its range may be
    /// any.
    ///
    /// # Errors
    /// [`ShapeError::NotNear`] where the origin is 2¹⁷ units in the last place or more from zero
    /// on some axis, or the direction 2¹⁹.
    pub const fn near(self) -> Result<Near<Self>, ShapeError> {
        if all_fit(&self.origin, POSITION) && all_fit(&self.direction, LENGTH) {
            Ok(Near(self))
        } else {
            Err(ShapeError::NotNear)
        }
    }
}

impl<Frac: LeEqU32> Aabb<FixedI32<Frac>> {
    /// The box, for queries in 32-bit words alone: see [`near`](crate::near).
    ///
    /// # Errors
    /// [`ShapeError::NotNear`] where a corner is 2¹⁷ units in the last place or more from zero on
    /// some axis.
    pub const fn near(self) -> Result<Near<Self>, ShapeError> {
        let is_near = match &self.form {
            Form::Center { center: c, half: h } => {
                ends_fit(c.x, h.x) && ends_fit(c.y, h.y) && ends_fit(c.z, h.z)
            }
            Form::Corners { min, max } => all_fit(min, POSITION) && all_fit(max, POSITION),
        };
        if is_near { Ok(Near(self)) } else { Err(ShapeError::NotNear) }
    }
}

impl<Frac: LeEqU32> Obb<FixedI32<Frac>> {
    /// The box, for queries in 32-bit words alone: see [`near`](crate::near).
    ///
    /// # Errors
    /// [`ShapeError::NotNear`] where the centre is 2¹⁷ units in the last place or more from zero
    /// on some axis, or an axis or a half-extent 2¹⁹: a type of more than 18 fraction bits has no
    /// unit vectors so short.
    pub const fn near(self) -> Result<Near<Self>, ShapeError> {
        let [u, v, w] = &self.axes;
        let is_near = all_fit(&self.center, POSITION)
            && all_fit(&self.half, LENGTH)
            && all_fit(u, LENGTH)
            && all_fit(v, LENGTH)
            && all_fit(w, LENGTH)
            && FixedI32::<Frac>::FRAC_NBITS <= 30;
        if is_near { Ok(Near(self)) } else { Err(ShapeError::NotNear) }
    }
}
