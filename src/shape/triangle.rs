use super::Vec3;
use super::overlaps::overlaps_methods;
use super::{ShapeError, finite};
use crate::scalar::Scalar;

/// A triangle: the convex hull of three points, a closed set.
///
/// Its vertices may coincide or lie on one line. Such a triangle is a segment or a point, and every
/// query about it is still exact.
///
/// ```
/// use septum::{Aabb, Triangle};
///
/// let cell = Aabb::from_min_max([0.0, 0.0, 0.0], [1.0, 1.0, 1.0])?;
/// let floor = Triangle::new([-9.0, -9.0, 1.0], [9.0, -9.0, 1.0], [0.0, 9.0, 1.0])?;
/// assert!(floor.overlaps(&cell)); // it touches the top face
/// # Ok::<(), septum::ShapeError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[repr(transparent)]
pub struct Triangle<S> {
    pub(super) vertices: [Vec3<S>; 3],
}

impl<S: Scalar> Triangle<S> {
    /// A triangle with these vertices, in any order.
    ///
    /// # Errors
    /// [`ShapeError::NotFinite`] if a coordinate is NaN or infinite.
    #[inline]
    pub fn new(
        a: impl Into<Vec3<S>>,
        b: impl Into<Vec3<S>>,
        c: impl Into<Vec3<S>>,
    ) -> Result<Self, ShapeError> {
        Ok(Self { vertices: [finite("a", a)?, finite("b", b)?, finite("c", c)?] })
    }
}

overlaps_methods!(
    Triangle,
    "an [`Aabb`](crate::Aabb), an [`Obb`](crate::Obb), a triangle, a [`Segment`](crate::Segment), a [`Sphere`](crate::Sphere) or a [`Capsule`](crate::Capsule)"
);

impl<S: Copy> Triangle<S> {
    /// The three vertices, in the order given.
    #[inline]
    #[must_use]
    pub const fn vertices(&self) -> &[Vec3<S>; 3] {
        &self.vertices
    }

    /// A triangle whose vertices were checked before. A rounded method may also make one with an
    /// infinity, where a sum overflowed.
    pub(crate) const fn unchecked(vertices: [Vec3<S>; 3]) -> Self {
        Self { vertices }
    }

    #[inline(always)]
    pub(crate) fn points(&self) -> [[S; 3]; 3] {
        let [a, b, c] = self.vertices;
        [a.to_array(), b.to_array(), c.to_array()]
    }
}
