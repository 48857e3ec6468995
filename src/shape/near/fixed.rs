//! Shapes in 32-bit fixed point.

use fixed::FixedI32;
use fixed::types::extra::LeEqU32;

use super::Near;
use crate::shape::aabb::Form;
use crate::shape::segment::Form as SegmentForm;
use crate::shape::{Aabb, Capsule, Obb, Ray, Segment, ShapeError, Sphere, Triangle, Vec3};

/// The bits of a coordinate without its sign. Two such coordinates differ by less than 2^18, which
/// the kernel for axis-aligned boxes can take on every core.
const POSITION: u32 = 17;
/// The bits of a component of a direction, an axis or a half-extent, limited by the width of
/// volumes.
const LENGTH: u32 = 19;
/// The bits of a radius: [`Int16`](crate::arithmetic::Int16) holds it.
const RADIUS: u32 = 18;

const fn fits(bits: i32, most: u32) -> bool {
    (bits ^ (bits >> 31)) >> most == 0
}

const fn all_fit<Frac: LeEqU32>(v: &Vec3<FixedI32<Frac>>, most: u32) -> bool {
    fits(v.x.to_bits(), most) && fits(v.y.to_bits(), most) && fits(v.z.to_bits(), most)
}

/// Whether c − h and c + h fit in `POSITION` bits.
const fn ends_fit<Frac: LeEqU32>(c: FixedI32<Frac>, h: FixedI32<Frac>) -> bool {
    let (c, h) = (c.to_bits(), h.to_bits());
    fits(c, POSITION) && fits(h, LENGTH) && fits(c - h, POSITION) && fits(c + h, POSITION)
}

impl<Frac: LeEqU32> Near<Vec3<FixedI32<Frac>>> {
    /// Whether a vertex is near.
    pub(crate) const fn is_in_range(vertex: &Vec3<FixedI32<Frac>>) -> bool {
        all_fit(vertex, POSITION)
    }
}

impl<Frac: LeEqU32> Triangle<FixedI32<Frac>> {
    /// The triangle, for queries in 32-bit words alone: see [`near`](crate::near).
    ///
    /// # Errors
    /// [`ShapeError::NotNear`] if a vertex is below −2¹⁷ units in the last place, or 2¹⁷ or more, on some
    /// axis.
    pub const fn near(self) -> Result<Near<Self>, ShapeError> {
        let [a, b, c] = &self.vertices;
        Near::checked(self, all_fit(a, POSITION) && all_fit(b, POSITION) && all_fit(c, POSITION))
    }
}

impl<Frac: LeEqU32> Ray<FixedI32<Frac>> {
    /// The ray, for queries in 32-bit words alone: see [`near`](crate::near).
    ///
    /// Its range of t is not restricted.
    ///
    /// # Errors
    /// [`ShapeError::NotNear`] if the origin is below −2¹⁷ units in the last place, or 2¹⁷ or more, on
    /// some axis, or the direction 2¹⁹.
    pub const fn near(self) -> Result<Near<Self>, ShapeError> {
        Near::checked(self, all_fit(&self.origin, POSITION) && all_fit(&self.direction, LENGTH))
    }
}

impl<Frac: LeEqU32> Segment<FixedI32<Frac>> {
    /// The segment, for queries in one number system: see [`near`](crate::near).
    ///
    /// # Errors
    /// [`ShapeError::NotNear`] if an end is below −2¹⁷ units in the last place, or 2¹⁷ or more, on some
    /// axis.
    pub const fn near(self) -> Result<Near<Self>, ShapeError> {
        let is_near = match &self.form {
            SegmentForm::Center { center: c, half: h } => {
                ends_fit(c.x, h.x) && ends_fit(c.y, h.y) && ends_fit(c.z, h.z)
            }
            SegmentForm::Ends(a, b) => all_fit(a, POSITION) && all_fit(b, POSITION),
        };
        Near::checked(self, is_near)
    }
}

impl<Frac: LeEqU32> Aabb<FixedI32<Frac>> {
    /// The box, for queries in 32-bit words alone: see [`near`](crate::near).
    ///
    /// # Errors
    /// [`ShapeError::NotNear`] if a corner is below −2¹⁷ units in the last place, or 2¹⁷ or more, on some
    /// axis.
    pub const fn near(self) -> Result<Near<Self>, ShapeError> {
        let is_near = match &self.form {
            Form::Center { center: c, half: h } => {
                ends_fit(c.x, h.x) && ends_fit(c.y, h.y) && ends_fit(c.z, h.z)
            }
            Form::Corners { min, max } => all_fit(min, POSITION) && all_fit(max, POSITION),
        };
        Near::checked(self, is_near)
    }
}

impl<Frac: LeEqU32> Sphere<FixedI32<Frac>> {
    /// The sphere, for queries in one number system: see [`near`](crate::near).
    ///
    /// # Errors
    /// [`ShapeError::NotNear`] if the centre is below −2¹⁷ units in the last place, or 2¹⁷ or more, on
    /// some axis, or the radius is 2¹⁸ units or more.
    pub const fn near(self) -> Result<Near<Self>, ShapeError> {
        Near::checked(self, all_fit(&self.center, POSITION) && fits(self.radius.to_bits(), RADIUS))
    }
}

impl<Frac: LeEqU32> Capsule<FixedI32<Frac>> {
    /// The capsule, for queries in one number system: see [`near`](crate::near).
    ///
    /// # Errors
    /// [`ShapeError::NotNear`] if an end is below −2¹⁷ units in the last place, or 2¹⁷ or more, on some
    /// axis, or the radius is 2¹⁸ units or more.
    pub const fn near(self) -> Result<Near<Self>, ShapeError> {
        let are_near = all_fit(&self.a, POSITION) && all_fit(&self.b, POSITION);
        Near::checked(self, are_near && fits(self.radius.to_bits(), RADIUS))
    }
}

impl<Frac: LeEqU32> Obb<FixedI32<Frac>> {
    /// The box, for queries in 32-bit words alone: see [`near`](crate::near).
    ///
    /// # Errors
    /// [`ShapeError::NotNear`] if the centre is below −2¹⁷ units in the last place, or 2¹⁷ or more, on
    /// some axis, or an axis or a half-extent 2¹⁹. In a type of more than 18 fraction bits a unit
    /// vector is longer than that. In a type of 31 or 32 fraction bits no oriented box is near.
    pub const fn near(self) -> Result<Near<Self>, ShapeError> {
        let [u, v, w] = &self.axes;
        let is_near = all_fit(&self.center, POSITION)
            && all_fit(&self.half, LENGTH)
            && all_fit(u, LENGTH)
            && all_fit(v, LENGTH)
            && all_fit(w, LENGTH)
            && FixedI32::<Frac>::FRAC_NBITS <= 30;
        Near::checked(self, is_near)
    }
}
