use super::Vec3;
use super::overlaps::overlaps_methods;
use super::{ShapeError, finite};
use crate::scalar::Scalar;

/// A sphere with its interior: all points within a radius of a centre, a closed set.
///
/// The radius may be zero: such a sphere is a point. Whether a shape lies within a distance of a
/// point is the question whether it overlaps the sphere of that radius.
///
/// ```
/// use septum::{Sphere, Triangle};
///
/// let floor = Triangle::new([0.0, 0.0, 0.0], [9.0, 0.0, 0.0], [0.0, 9.0, 0.0])?;
/// let ball = Sphere::new([2.0, 2.0, 0.5], 0.5)?;
/// assert!(ball.overlaps(&floor)); // touching is overlap
/// let corner = Sphere::new([-3.0, -4.0, 12.0], 13.0)?;
/// assert!(corner.overlaps(&floor)); // 3² + 4² + 12² = 13²
/// # Ok::<(), septum::ShapeError>(())
/// ```
#[doc(alias = "ball")]
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Sphere<S> {
    pub(super) center: Vec3<S>,
    pub(super) radius: S,
}

impl<S: Scalar> Sphere<S> {
    /// A sphere around `center`.
    ///
    /// # Errors
    /// [`ShapeError::NotFinite`] if a number is NaN or infinite, [`ShapeError::NegativeRadius`] if
    /// the radius is negative.
    #[inline]
    pub fn new(center: impl Into<Vec3<S>>, radius: S) -> Result<Self, ShapeError> {
        Ok(Self { center: finite("center", center)?, radius: checked(radius)? })
    }
}

/// Returns the radius if it is finite and not negative.
#[inline(always)]
pub(super) fn checked<S: Scalar>(radius: S) -> Result<S, ShapeError> {
    if !radius.is_finite() {
        Err(ShapeError::NotFinite { argument: "radius", index: None })
    } else if radius < S::ZERO {
        Err(ShapeError::NegativeRadius)
    } else {
        Ok(radius)
    }
}

overlaps_methods!(
    Sphere,
    "a [`Triangle`](crate::Triangle), an [`Aabb`](crate::Aabb), an [`Obb`](crate::Obb), a \
     [`Segment`](crate::Segment), a [`Ray`](crate::Ray), a [`Plane`](crate::Plane), a \
     [`Capsule`](crate::Capsule) or another sphere"
);

impl<S: Copy> Sphere<S> {
    /// The centre.
    #[inline]
    #[must_use]
    pub const fn center(&self) -> Vec3<S> {
        self.center
    }

    /// The radius.
    #[inline]
    #[must_use]
    pub const fn radius(&self) -> S {
        self.radius
    }
}
