use super::overlaps::overlaps_methods;
use super::{Segment, ShapeError, Vec3, finite};
use crate::scalar::Scalar;

/// A capsule: all points within a radius of a segment, a closed set.
///
/// The radius may be zero: such a capsule is a segment. The ends may coincide: such a capsule is a
/// sphere. Whether a shape lies within a distance of a segment is the question whether it overlaps
/// the capsule of that radius.
///
/// ```
/// use septum::{Capsule, Triangle};
///
/// let floor = Triangle::new([0.0, 0.0, 0.0], [9.0, 0.0, 0.0], [0.0, 9.0, 0.0])?;
/// let person = Capsule::new([2.0, 2.0, 0.25], [2.0, 2.0, 1.75], 0.25)?;
/// assert!(person.overlaps(&floor)); // touching is overlap
/// assert!(person.contains([2.25, 2.0, 1.0]));
/// # Ok::<(), septum::ShapeError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Capsule<S> {
    pub(super) a: Vec3<S>,
    pub(super) b: Vec3<S>,
    pub(super) radius: S,
}

impl<S: Scalar> Capsule<S> {
    /// A capsule around the segment from `a` to `b`.
    ///
    /// # Errors
    /// [`ShapeError::NotFinite`] if a number is NaN or infinite, [`ShapeError::NegativeRadius`] if
    /// the radius is negative.
    #[inline]
    pub fn new(
        a: impl Into<Vec3<S>>,
        b: impl Into<Vec3<S>>,
        radius: S,
    ) -> Result<Self, ShapeError> {
        let (a, b) = (finite("a", a)?, finite("b", b)?);
        Ok(Self { a, b, radius: super::sphere::checked(radius)? })
    }
}

overlaps_methods!(
    Capsule,
    "a [`Triangle`](crate::Triangle), an [`Aabb`](crate::Aabb), an [`Obb`](crate::Obb), a \
     [`Segment`](crate::Segment), a [`Ray`](crate::Ray), a [`Plane`](crate::Plane), a \
     [`Sphere`](crate::Sphere) or another capsule"
);

impl<S: Copy> Capsule<S> {
    /// The two ends of the segment.
    #[inline]
    #[must_use]
    pub const fn ends(&self) -> (Vec3<S>, Vec3<S>) {
        (self.a, self.b)
    }

    /// The segment.
    #[inline]
    #[must_use]
    pub const fn segment(&self) -> Segment<S> {
        Segment::unchecked(self.a, self.b)
    }

    /// The radius.
    #[inline]
    #[must_use]
    pub const fn radius(&self) -> S {
        self.radius
    }
}
