//! Axis-aligned box against oriented box.

use super::Overlaps;
use super::obb_obb::{First, Lie};
use super::relation::{Asked, Relate, Relation};
use crate::scalar::Scalar;
use crate::shape::{Aabb, Obb};

impl<S: Scalar> Overlaps<Obb<S>> for Aabb<S> {
    /// Do an axis-aligned box and an oriented box have a point in common?
    ///
    /// *Geometry*: closed sets in one frame and one unit. The axis-aligned box is given by its
    /// corners, or by centre and half-extents. The oriented box is the parallelepiped that its
    /// numbers describe. Flat boxes, segments and points are boxes.
    ///
    /// *Contact*: touching counts as overlap.
    ///
    /// *Numerics*: exact for every valid input, in every scalar.
    ///
    /// *Range*, *Panics*, *Cost* and *Source*: as for [two oriented
    /// boxes](Obb#impl-Overlaps<Obb<S>>-for-Obb<S>).
    ///
    /// ```
    /// use septum::{Aabb, Obb};
    ///
    /// let cell = Aabb::from_min_max([0.0, 0.0, 0.0], [1.0, 1.0, 1.0])?;
    /// let axes = [[0.8, 0.6, 0.0], [-0.6, 0.8, 0.0], [0.0, 0.0, 1.0]];
    /// let tool = Obb::new([2.4, 0.5, 0.5], axes, [1.0, 1.0, 0.25])?;
    /// assert!(tool.overlaps(&cell)); // a corner reaches to x = 1
    /// # Ok::<(), septum::ShapeError>(())
    /// ```
    #[inline]
    fn overlaps(&self, obb: &Obb<S>) -> bool {
        S::evaluate_numeric(&Lie { first: First::Aabb(self), second: obb, asked: Asked::Overlaps })
            != Relation::Disjoint
    }

    /// May an axis-aligned box and an oriented box have a point in common?
    ///
    /// *Numerics*, *Panics* and *Cost*: as for [two oriented
    /// boxes](Obb#impl-Overlaps<Obb<S>>-for-Obb<S>).
    #[inline]
    fn may_overlap(&self, obb: &Obb<S>) -> bool {
        let question = Lie { first: First::Aabb(self), second: obb, asked: Asked::MayOverlap };
        S::evaluate_bounded(&question) != Some(Relation::Disjoint)
    }
}

impl<S: Scalar> Relate<Obb<S>> for Aabb<S> {
    fn relation(&self, obb: &Obb<S>) -> Relation {
        S::evaluate_numeric(&Lie { first: First::Aabb(self), second: obb, asked: Asked::Relation })
    }
}
