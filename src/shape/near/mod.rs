//! Shapes that have been checked to be near the origin.

#[cfg(feature = "fixed")]
mod fixed;
mod float;

use super::overlaps::Overlaps;

/// A shape near the origin: see [`near`](crate::near).
///
/// `near` of `Triangle`, `Ray`, `Aabb`, `Obb`, `Sphere` and `Capsule` makes one.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[repr(transparent)]
pub struct Near<T>(T);

impl<T> Near<T> {
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
