use core::fmt;

use crate::scalar::Scalar;

/// A point or a direction: three coordinates in one unit.
///
/// Any three numbers make a `Vec3`; the constructor of a shape checks them. Arrays convert both
/// ways, and constructors accept a `Vec3` or an array:
///
/// ```
/// use septum::{Triangle, Vec3};
///
/// let a = Vec3::new(0.0, 0.0, 0.0);
/// let t = Triangle::new(a, [1.0, 0.0, 0.0], [0.0, 1.0, 0.0])?;
/// assert_eq!(t.vertices()[1], Vec3::new(1.0, 0.0, 0.0));
/// # Ok::<(), septum::ShapeError>(())
/// ```
#[derive(Clone, Copy, Default, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(deny_unknown_fields))]
#[repr(C)]
pub struct Vec3<S> {
    /// Along the first axis.
    pub x: S,
    /// Along the second axis.
    pub y: S,
    /// Along the third axis.
    pub z: S,
}

impl<S> Vec3<S> {
    /// A point or direction with these coordinates.
    #[inline]
    #[must_use]
    pub const fn new(x: S, y: S, z: S) -> Self {
        Self { x, y, z }
    }

    /// The coordinates x, y and z.
    #[inline]
    #[must_use]
    pub fn to_array(self) -> [S; 3] {
        [self.x, self.y, self.z]
    }
}

impl<S: Copy> Vec3<S> {
    /// A point with the same coordinate on every axis.
    #[inline]
    #[must_use]
    pub const fn splat(each: S) -> Self {
        Self { x: each, y: each, z: each }
    }
}

impl<S: Scalar> Vec3<S> {
    /// Whether all coordinates are finite.
    #[inline]
    pub(crate) fn is_finite(self) -> bool {
        self.x.is_finite() && self.y.is_finite() && self.z.is_finite()
    }
}

impl<S> From<[S; 3]> for Vec3<S> {
    #[inline]
    fn from([x, y, z]: [S; 3]) -> Self {
        Self { x, y, z }
    }
}

impl<S> From<Vec3<S>> for [S; 3] {
    #[inline]
    fn from(v: Vec3<S>) -> Self {
        v.to_array()
    }
}

impl<S: fmt::Debug> fmt::Debug for Vec3<S> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "({:?}, {:?}, {:?})", self.x, self.y, self.z)
    }
}
