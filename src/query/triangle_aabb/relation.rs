//! Whether a triangle and a box touch or overlap, and which axis separates them: the 13 axes again,
//! apart from the verdict. The witness tests the axes in a fixed order, each exactly, so the answer
//! is the same on every machine.

use super::Disjoint;
use super::error_bound::error_bound;
use super::frame::{Frame, range};
use super::kernel::{edge_axis, in_frame, normal, one_edge, one_face, plane_of_size};
use crate::arithmetic::{
    Arithmetic, Double, Each, Embeds, InRaw, Number, REGISTERS_ARE_WIDE, Word, dot, greatest, least,
};
use crate::query::Axis;
use crate::query::relation::{Nearness, Reading, Relate, Relation};
use crate::robust::{Predicate, WordKernel};
use crate::scalar::{FixedBackend, Scalar};
#[cfg(feature = "fixed")]
use crate::shape::Near;
use crate::shape::{Aabb, Triangle};

/// The triangle in the frame of the box, if `N` holds the shapes.
#[inline(always)]
fn frame_if_held<S: Scalar, N: Embeds<S>>(shapes: &Disjoint<'_, S>) -> Option<Frame<N>> {
    if shapes.is_held::<N>() { Some(in_frame(shapes.triangle, shapes.aabb.form())) } else { None }
}

/// How do the shapes lie to each other?
struct Lie<'a, S>(Disjoint<'a, S>);

impl<S: Scalar> Predicate<S> for Lie<'_, S> {
    type Answer = Relation;

    fn filter<N: Embeds<S>>(&self) -> Option<Relation> {
        let found = all_axes(&frame_if_held::<S, N>(&self.0)?);
        // The shapes are known to have a point in common.
        if REGISTERS_ARE_WIDE && !N::CERTAIN && found.is_none() && self.0.touch_on_a_face() {
            return Some(Relation::Touching);
        }
        found
    }

    #[inline(always)]
    fn in_words(&self, _: bool) -> Option<Relation>
    where
        S: FixedBackend,
    {
        S::in_machine_words(self)
    }
}

impl<S: Scalar> Disjoint<'_, S> {
    fn touch_on_a_face(&self) -> bool {
        (0..3).any(|i| touches_face(self.triangle, self.aabb, i))
    }
}

impl<S: Scalar + InRaw> WordKernel<S> for Lie<'_, S> {
    #[inline(always)]
    fn narrow<W: Word>(&self) -> Option<Relation> {
        if S::is_always_near::<W>() {
            return Some(self.0.relation_in_any_words::<W>());
        }
        self.0.relation_in_near_words::<W>()
    }
}

/// Whether a face of the box touches the triangle's projection on axis i, so that the shapes do not overlap.
/// `false` too if `f64` does not hold the scalar.
pub(in crate::query) fn touches_face<S: Scalar>(
    triangle: &Triangle<S>,
    aabb: &Aabb<S>,
    i: usize,
) -> bool {
    let [a, b, c] = triangle.points().each(|p| p[i].in_double());
    let (low, high) = (least(least(a, b), c), greatest(greatest(a, b), c));
    let (p, q, is_by_center) = aabb.numbers();
    let (p, q) = (p[i].in_double(), q[i].in_double());
    // Exact in two words. A sum that one word does not hold differs from every coordinate.
    let face = |half: f64| {
        let face = Double::difference(p, -half);
        if face.low == 0.0 { face.high } else { f64::NAN }
    };
    let (min, max) = if is_by_center { (face(-q), face(q)) } else { (p, q) };
    // In a plane that both lie in, they may overlap.
    S::IS_IN_DOUBLE && (low == max || high == min) && !(low == high && min == max)
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

        for k in 0..3 {
            let (far, reach, is_axis) = edge_axis(frame, &n, i, k);
            if is_axis() {
                found.add(far - reach, reach, bound.edge);
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
        let shapes = Disjoint { triangle: self, aabb };
        if let Some(relation) = shapes.relation_in_short_words() {
            return relation;
        }
        // Words find all three relations together.
        let is_in_words = !REGISTERS_ARE_WIDE && S::FLOAT.is_none();
        let overlap =
            || if REGISTERS_ARE_WIDE { self.overlaps(aabb) } else { !S::evaluate(&shapes) };
        if is_in_words || overlap() { S::evaluate(&Lie(shapes)) } else { Relation::Disjoint }
    }
}

#[cfg(feature = "fixed")]
impl<S: Scalar + InRaw<Raw = i32>> Relate<Near<Aabb<S>>> for Near<Triangle<S>> {
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
        let frame = frame_if_held::<S, N>(&self.shapes)?;
        let size = frame.size_across_gap();
        let bound = error_bound::<N>(size)?;
        let n = normal(&frame);
        match self.axis {
            Axis::Face(i) => one_face(&frame, usize::from(i % 3)),
            Axis::Normal => plane_of_size(&frame, n, size, bound.plane),
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
