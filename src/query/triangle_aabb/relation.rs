//! Whether a triangle and a box touch or overlap, and which axis separates them: the 13 axes again,
//! apart from the verdict. The witness tests the axes in a fixed order, each exactly, so the answer
//! is the same on every machine.

use super::Disjoint;
use super::error_bound::error_bound;
use super::frame::{Frame, range};
use super::kernel::{
    in_frame_of_center, in_frame_of_corners, narrow_plane, normal, one_edge, one_face, plane,
};
use crate::arithmetic::{Arithmetic, Embeds, InWord, Number, REGISTERS_ARE_WIDE, Word};
use crate::arithmetic::{Each, dot, greatest, of_two};
use crate::query::Axis;
use crate::query::relation::{Nearness, Reading, Relate, Relation};
use crate::robust::{Predicate, WordKernel};
use crate::scalar::{FixedBackend, Scalar};
#[cfg(feature = "fixed")]
use crate::shape::Near;
use crate::shape::{Aabb, AabbForm, Triangle, Vec3};

/// The triangle in the frame of the box, if `N` holds the shapes.
#[inline(always)]
fn in_frame<S: Scalar, N: Embeds<S>>(shapes: &Disjoint<'_, S>) -> Option<Frame<N>> {
    if !shapes.is_held::<N>() {
        return None;
    }
    let triangle = shapes.triangle;
    Some(match shapes.aabb.form() {
        AabbForm::Center { center, half } => in_frame_of_center::<S, N>(triangle, center, half),
        AabbForm::Corners { min, max } => {
            in_frame_of_corners::<S, N>(triangle, min, max, &Vec3::splat(S::ZERO))
        }
    })
}

/// How do the shapes lie to each other?
struct Lie<'a, S>(Disjoint<'a, S>);

impl<S: Scalar> Predicate<S> for Lie<'_, S> {
    type Answer = Relation;

    fn filter<N: Embeds<S>>(&self) -> Option<Relation> {
        all_axes(&in_frame::<S, N>(&self.0)?)
    }

    #[inline(always)]
    fn in_words(&self, _: bool) -> Option<Relation>
    where
        S: FixedBackend,
    {
        S::in_machine_words(self)
    }
}

impl<S: Scalar> WordKernel<S> for Lie<'_, S> {
    #[inline(always)]
    fn narrow<W: Word>(&self) -> Option<Relation>
    where
        S: InWord<W>,
    {
        self.0.relation_in_words()
    }
}

#[inline(never)]
fn all_axes<N: Arithmetic>(frame: &Frame<N>) -> Option<Relation> {
    let bound = error_bound::<N>(frame.size_across_gap())?;
    let mut found = Nearness::NONE;
    let n = normal(frame);
    for i in 0..3 {
        let h = frame.h[i];
        if N::CERTAIN {
            let (low, high) = range(&frame.v, i);
            found.add(greatest(low, -high) - h, (high - low) + h, N::Length::ZERO);
        } else {
            // The sign of a gap is right unless it is zero.
            found.add_known(false, frame.gaps[i] >= N::Length::ZERO);
        }

        // See `kernel::edges`.
        let (j, l) = ((i + 1) % 3, (i + 2) % 3);
        let middle = of_two::<N, _>(n[i]);
        for k in 0..3 {
            let (e, v) = (&frame.e[k], &frame.v[k]);
            let p = N::area(e[j], v[l]) - N::area(e[l], v[j]);
            let r = N::area(e[l].magnitude(), frame.h[j]) + N::area(e[j].magnitude(), frame.h[l]);
            let reach = middle.magnitude() + r;
            // An edge along the axis gives no axis.
            if e[j] != N::Length::ZERO || e[l] != N::Length::ZERO {
                found.add((p + middle).magnitude() - reach, reach, bound.edge);
            }
        }
    }

    // See `kernel::plane`.
    let distance = dot::<N>(&n, &frame.v[0]);
    let reach = dot::<N>(&n.each(N::Area::magnitude), &frame.h);
    // A box that is a point in the triangle's plane has no reach off it.
    found.add(distance.magnitude() - reach, reach, bound.plane);
    found.answer(N::CERTAIN)
}

impl<S: Scalar> Relate<Aabb<S>> for Triangle<S> {
    fn relation(&self, aabb: &Aabb<S>) -> Relation {
        // Words find all three relations together.
        let is_in_words = !REGISTERS_ARE_WIDE && S::FLOAT.is_none();
        if is_in_words || self.overlaps(aabb) {
            S::evaluate(&Lie(Disjoint { triangle: self, aabb }))
        } else {
            Relation::Disjoint
        }
    }
}

#[cfg(feature = "fixed")]
impl<S: Scalar + InWord<i32>> Relate<Near<Aabb<S>>> for Near<Triangle<S>> {
    /// Are a triangle and an axis-aligned box near the origin disjoint, touching or overlapping?
    ///
    /// *Numerics*: exact, in 32-bit words alone. *Panics*: never.
    #[inline]
    fn relation(&self, aabb: &Near<Aabb<S>>) -> Relation {
        Disjoint { triangle: self.get(), aabb: aabb.get() }.relation_in_any_words::<i32>()
    }
}

/// Does one axis separate the triangle and the box?
struct SeparatedBy<'a, S> {
    shapes: Disjoint<'a, S>,
    axis: Axis,
}

impl<S: Scalar> Predicate<S> for SeparatedBy<'_, S> {
    type Answer = bool;

    fn filter<N: Embeds<S>>(&self) -> Option<bool> {
        let frame = in_frame::<S, N>(&self.shapes)?;
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
}

impl<S: Scalar> Triangle<S> {
    /// An axis on which the projections of triangle and box are disjoint, or `None` if the two
    /// overlap. It is a witness that a caller can verify.
    ///
    /// *Contact*: projections that touch are not disjoint.
    ///
    /// *Numerics*: exact for every valid input. The axis is the first in the order of
    /// [`Axis::ALL`], so it is the same on every machine.
    ///
    /// *Panics*: never. *Cost*: as for [`overlaps`](Self::overlaps), and if that is `false` up to
    /// 13 tests of one axis.
    ///
    /// If the bodies move little between frames, the same axis usually separates them again. Test
    /// it first with [`is_separated_by`](Self::is_separated_by).
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

    /// Are the projections of triangle and box on one axis disjoint?
    ///
    /// *Contact*: projections that touch are not disjoint.
    ///
    /// *Numerics*: exact for every valid input. An edge along a coordinate axis and a degenerate
    /// triangle can make an axis zero; a zero axis separates nothing. Indices count modulo 3.
    ///
    /// *Panics*: never. *Cost*: at most as for [`overlaps`](Self::overlaps).
    #[must_use]
    pub fn is_separated_by(&self, aabb: &Aabb<S>, axis: Axis) -> bool {
        S::evaluate(&SeparatedBy { shapes: Disjoint { triangle: self, aabb }, axis })
    }
}
