//! The questions, one file for each pair of shapes.

mod clear_hit;
mod crossing;
mod hit;
mod line_published;
mod plane_aabb;
mod published;
mod ray_aabb;
mod ray_slabs;
mod ray_slopes;
mod ray_triangle;
mod rounded;
mod segment_aabb;
mod triangle_aabb;
mod triangle_obb;
mod unit_normal;

pub(crate) use clear_hit::clear_hit;
pub use hit::{Cull, Facing, Feature, Hit, HitRules};
pub use plane_aabb::Side;
pub use published::Order;
pub use ray_slabs::SlabRay;
pub(crate) use ray_slabs::{Faces, plain_interval};
pub use ray_slopes::SlopeRay;
pub(crate) use rounded::{
    Found, Limits, Stored, Triple, are_zero, edges, moller_trumbore, rounded, settle, store,
    stored_normal,
};
pub use rounded::{NormalTriangle, ProjectedTriangle, ShearedRay};
#[cfg(feature = "libm")]
pub(crate) use unit_normal::direction;

use crate::shape::Triangle;

/// Whether two shapes have a point in common, exactly.
///
/// Implemented for each pair that can be asked about; the methods of the same
/// name on the shapes are this, and need no import.
pub trait Overlaps<Other> {
    /// Whether the two shapes, as closed sets, have a point in common.
    fn overlaps(&self, other: &Other) -> bool;
}

/// Whether two shapes may have a point in common: quick, and never `false` for
/// shapes that have.
pub trait MayOverlap<Other> {
    /// `false` only if the two shapes have no point in common.
    fn may_overlap(&self, other: &Other) -> bool;
}

impl<S> Triangle<S> {
    /// Whether the triangle meets the other shape, an [`Aabb`] or an [`Obb`].
    ///
    /// Exact for every valid input; touching is overlap; never panics. What there
    /// is to know of numerics, range and cost stands with each pair: see the
    /// implementations of [`Overlaps`].
    ///
    /// ```
    /// use septum::{Aabb, Triangle};
    ///
    /// let cell = Aabb::from_min_max([0.0_f32; 3], [1.0; 3])?;
    /// let t = Triangle::new([1.0, 0.5, 0.5], [2.0, 0.0, 0.0], [2.0, 1.0, 0.0])?;
    /// assert!(t.overlaps(&cell)); // a vertex lies on a face
    /// # Ok::<(), septum::ShapeError>(())
    /// ```
    ///
    /// [`Aabb`]: crate::Aabb
    /// [`Obb`]: crate::Obb
    #[inline]
    pub fn overlaps<Other>(&self, other: &Other) -> bool
    where
        Self: Overlaps<Other>,
    {
        Overlaps::overlaps(self, other)
    }

    /// Whether the triangle may meet the other shape: never `false` if it does.
    ///
    /// Never panics; bounded in time. See the implementations of [`MayOverlap`] for
    /// when it is `true` without need.
    ///
    /// ```
    /// use septum::{Aabb, Triangle};
    ///
    /// let cell = Aabb::from_min_max([0.0_f32; 3], [1.0; 3])?;
    /// let t = Triangle::new([3.0, 0.0, 0.5], [0.0, 3.0, 0.5], [3.0, 3.0, 0.5])?;
    /// assert!(!t.may_overlap(&cell)); // certainly apart
    /// # Ok::<(), septum::ShapeError>(())
    /// ```
    #[inline]
    pub fn may_overlap<Other>(&self, other: &Other) -> bool
    where
        Self: MayOverlap<Other>,
    {
        MayOverlap::may_overlap(self, other)
    }
}
