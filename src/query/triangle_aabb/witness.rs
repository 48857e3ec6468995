//! The witness: which axis separates. It is looked for apart from the verdict, axis by axis
//! in a fixed order and each exactly, so that it is the same on every machine.

use super::edges::one_edge;
use super::error_bound::error_bound;
use super::faces::one_face;
use super::kernel::{in_frame_of_center, in_frame_of_corners, narrow_plane};
use super::plane::{normal, plane};
use super::{Axis, Disjoint, exact};
use crate::arithmetic::Embeds;
use crate::robust::Predicate;
use crate::scalar::Scalar;
use crate::shape::{Aabb, AabbForm, Triangle, Vec3};

/// The question whether one axis separates.
struct SeparatedBy<'a, S> {
    shapes: Disjoint<'a, S>,
    axis: Axis,
}

impl<S: Scalar> Predicate<S> for SeparatedBy<'_, S> {
    type Answer = bool;

    fn filter<N: Embeds<S>>(&self) -> Option<bool> {
        if !self.shapes.is_held::<N>() {
            return None;
        }
        let triangle = self.shapes.triangle;
        let frame = match self.shapes.aabb.form() {
            AabbForm::Center { center, half } => in_frame_of_center::<S, N>(triangle, center, half),
            AabbForm::Corners { min, max } => {
                in_frame_of_corners::<S, N>(triangle, min, max, &Vec3::splat(S::ZERO))
            }
        };
        let size = frame.size_across_gap();
        let bound = error_bound::<N>(size)?;
        let n = normal(&frame);
        match self.axis {
            Axis::Face(i) => one_face(&frame, usize::from(i % 3)),
            Axis::Normal if N::is_narrow(size) => narrow_plane::<N>(n, frame.v[0], frame.h),
            Axis::Normal => plane::<N>(&n, &frame.v[0], &frame.h, bound.plane),
            Axis::Edge { axis, edge } => {
                one_edge(&frame, &n, bound.edge, usize::from(axis % 3), usize::from(edge % 3))
            }
        }
        .verdict()
    }

    fn exact(&self) -> bool {
        exact::separates(self.shapes.triangle, self.shapes.aabb, self.axis)
    }
}

impl<S: Scalar> Triangle<S> {
    /// An axis on which the projections of triangle and box are disjoint, or
    /// `None` if the two overlap: a witness that anyone can check.
    ///
    /// *Contact*: projections that touch are not disjoint.
    ///
    /// *Numerics*: exact for every valid input. It is the first such axis in the order of
    /// [`Axis::ALL`], so it is the same on every machine.
    ///
    /// *Panics*: never. *Cost*: [`overlaps`](Self::overlaps), and if that is
    /// `false` up to 13 tests of one axis.
    ///
    /// Bodies that move little between frames are kept apart by the same axis:
    /// ask for it first with [`is_separated_by`](Self::is_separated_by).
    ///
    /// ```
    /// use septum::{Aabb, Axis, Triangle};
    ///
    /// let cell = Aabb::from_min_max([0.0; 3], [1.0; 3])?;
    /// let t = Triangle::new([2.5, 0.0, 0.5], [0.0, 2.5, 0.5], [3.0, 3.0, 0.5])?;
    /// let axis = t.separating_axis(&cell);
    /// assert_eq!(axis, Some(Axis::Edge { axis: 2, edge: 0 }));
    /// assert!(t.is_separated_by(&cell, axis.unwrap()));
    /// # Ok::<(), septum::ShapeError>(())
    /// ```
    pub fn separating_axis(&self, aabb: &Aabb<S>) -> Option<Axis> {
        if self.overlaps(aabb) {
            return None;
        }
        Axis::ALL.into_iter().find(|&axis| self.is_separated_by(aabb, axis))
    }

    /// Whether the projections of triangle and box on one axis are disjoint.
    ///
    /// *Contact*: projections that touch are not disjoint.
    ///
    /// *Numerics*: exact for every valid input. An axis that is zero, of an edge along a
    /// coordinate axis or of a degenerate triangle, separates nothing. Indices count
    /// modulo 3.
    ///
    /// *Panics*: never. *Cost*: at most that of [`overlaps`](Self::overlaps).
    #[must_use]
    pub fn is_separated_by(&self, aabb: &Aabb<S>, axis: Axis) -> bool {
        S::evaluate(&SeparatedBy { shapes: Disjoint { triangle: self, aabb }, axis })
    }
}
