//! Shapes that move past others: whether they meet, and when first.

mod aabb_aabb;
mod error_bound;
mod exact;
mod in_doubles;
mod instants;
mod kernel;
mod latest;
mod motion;
#[cfg(feature = "fixed")]
mod near;
mod passing;
mod rows;
mod short;
mod sphere;
mod time;
mod words;

use core::cmp::Ordering;

pub use motion::Motion;
#[cfg(feature = "fixed")]
pub use near::Moving;
pub use sphere::SphereContact;

use self::latest::{Instant, Last};
use self::passing::{Given, Passing};
use super::axis::negated;
use super::relation::Relation;
use super::{Axis, HasAxes};
use crate::scalar::Scalar;
use crate::shape::{Aabb, Triangle, Vec3};

/// When and how a moving shape first meets another.
#[doc(alias = "time of impact")]
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(deny_unknown_fields))]
pub struct FirstContact<S> {
    /// The time of the first contact, as a part of the motion from zero to one: the greatest number
    /// of the scalar that is not above the true time.
    ///
    /// The time is therefore never late, and a float is early by less than one unit in the last
    /// place. In a fixed-point type that ends below one, a later time is the greatest value of the
    /// type.
    pub t: S,
    /// The axis on which the shapes are apart until that time; `None` if they meet at the start.
    ///
    /// If several axes close at the same number of the scalar, this is the first in the
    /// order of [`Axis::ALL`]. They are the triangle's axes; between two boxes they are the
    /// three [`Axis::Face`].
    pub axis: Option<Axis>,
}

impl<S: Scalar> FirstContact<S> {
    /// The outward normal of the obstacle where the moving shape meets it; `None` if they meet at
    /// the start. It is not normalised.
    ///
    /// `motion` is the motion of the query. `shape` is its triangle, whether that moves or stands;
    /// for two boxes it is either box. A box in place of the triangle has no slanted axes, and the
    /// normal is then zero.
    ///
    /// *Numerics*: [`Axis::vector`] of the axis, rounded as described there, with the sign by which
    /// the motion leads against the exact axis. A motion that grazes may be perpendicular to the
    /// rounded vector or lead slightly along it; in fixed point the vector of a small triangle may
    /// be zero, and a component may wrap. *Panics*: never. *Cost*: for a slanted axis an exact sum.
    ///
    /// ```
    /// use septum::sweep::{Motion, Sweep};
    /// use septum::{Aabb, Vec3};
    ///
    /// let floor = Aabb::from_min_max([-9.0, -9.0, -1.0], [9.0, 9.0, 0.0])?;
    /// let body = Aabb::from_center_half_extents([0.0, 0.0, 4.0], [0.5; 3])?;
    /// let fall = Motion::new([0.0, 0.0, 4.0], [1.0, 0.0, -4.0])?;
    /// let first = body.first_contact(&fall, &floor).unwrap();
    /// assert_eq!(first.normal(&fall, &floor), Some(Vec3::new(0.0, 0.0, 1.0)));
    /// # Ok::<(), septum::ShapeError>(())
    /// ```
    #[must_use]
    pub fn normal(&self, motion: &Motion<S>, shape: &impl HasAxes<S>) -> Option<Vec3<S>> {
        let axis = self.axis?;
        let normal = axis.vector(shape);
        let is_along = shape.along(axis, [motion.from(), motion.to()]) == Ordering::Greater;
        Some(if is_along { negated(normal) } else { normal })
    }
}

/// A shape that can be moved past another.
///
/// Each pair of shapes has an implementation. To move a triangle past a box is to move the box past
/// the triangle by [`Motion::reversed`].
#[diagnostic::on_unimplemented(
    message = "septum cannot sweep `{Self}` past `{Other}`",
    label = "no such pair",
    note = "both shapes need the same scalar; `septum::sweep` lists the pairs"
)]
pub trait Sweep<Other> {
    /// The scalar of the two shapes.
    type Scalar;

    /// When and how the two shapes first meet.
    type Contact;

    /// Does this shape, as it moves, have a point in common with `other` at any time?
    ///
    /// *Geometry*: closed sets in one frame and one unit. This shape is given at the start of the
    /// motion, and each of its points moves by `to` − `from`. The motion is a translation; for a
    /// body that turns, sweep a shape that encloses it in all its orientations.
    ///
    /// *Contact*: touching counts as contact, also at the start and at the end. Without motion the
    /// answer equals [`overlaps`](crate::Overlaps::overlaps).
    ///
    /// *Numerics*: exact for every valid input, in every scalar. The differences within the motion,
    /// and their sums with coordinates, are not rounded.
    ///
    /// *Range*: all finite floats and all fixed-point values. The fast stage serves the range that
    /// [`overlaps`](crate::Triangle#impl-Overlaps<Aabb<S>>-for-Triangle<S>) names, here of the two
    /// shapes and the motion together.
    ///
    /// *Panics*: never.
    ///
    /// *Cost*: a sphere takes as much as a [capsule](crate::Capsule), and the sweep of its centre as a
    /// box. A triangle and a box take 111 multiplications, unless a face separates them all the
    /// way. If they meet, the query takes fewer, and five quotients of four floats at once. Two
    /// boxes take 12 multiplications and no division. On 32-bit cores fixed point of up to 32 bits has
    /// a kernel of its own for a triangle and a box (`docs/target.csv`), and floats that functions
    /// compute are cut to words first. Floats within rounding of contact are decided in wider numbers, at last
    /// in exact integers.
    ///
    /// *Source*: separating axes of sums of convex sets (Gottschalk, Lin and Manocha 1996, for
    /// boxes). Ours: the motion as one more edge, the error bounds and the exact stages.
    #[must_use]
    fn meets_along(&self, motion: &Motion<Self::Scalar>, other: &Other) -> bool;

    /// When does this shape, as it moves, first have a point in common with `other`? `None` if it
    /// [misses](Self::meets_along) `other`.
    ///
    /// *Contact*: shapes that touch at the start meet at time zero.
    ///
    /// *Numerics*: exact except for one rounding, downwards: see [`FirstContact`] and
    /// [`SphereContact`]. If the result names an axis or a part, the shapes are apart before that
    /// time; at that time they touch or are still apart.
    ///
    /// *Panics*: never. *Cost*: as for [`meets_along`](Self::meets_along). A sphere that meets a box
    /// also takes up to 100 multiplications, each with an error bound, a root and a division of
    /// integers; past a triangle up to six times as many, and up to six roots. In `f64`, in fixed
    /// point on 32-bit cores and of 64 bits, and within rounding of a number, these are exact
    /// integers. Two boxes that meet take three axes again, in `f64` in integers of up to 256 bits, with three
    /// divisions. A triangle and a box take one of the axes again in `f64`, and two divisions. A
    /// result in `f64` takes that axis in 106 digits, and one in fixed point of 64 bits a division
    /// of integers. Where two axes close at about the same time, and on 32-bit cores, every axis with a gap is
    /// computed, each with a division; `f32` with an FPU selects the last axis there too. Where functions
    /// compute `f64`, floats first ask whether the shapes touch at the start.
    #[doc(alias = "time of impact")]
    #[doc(alias = "continuous collision")]
    #[must_use]
    fn first_contact(&self, motion: &Motion<Self::Scalar>, other: &Other) -> Option<Self::Contact>;

    /// Are the two shapes disjoint, touching or overlapping when they are nearest to each other on
    /// the way?
    ///
    /// The motion is free unless the shapes are [`Overlapping`](Relation::Overlapping) at some time
    /// from start to end. A body that begins in touch may therefore slide along the surface, or
    /// leave it.
    ///
    /// *Contact*: the relation is that of [`Relate`](crate::relation::Relate), at the nearest time.
    /// It is [`Disjoint`](Relation::Disjoint) if and only if
    /// [`meets_along`](Self::meets_along) is `false`.
    ///
    /// *Numerics* and *Range*: as for [`meets_along`](Self::meets_along). *Panics*: never.
    ///
    /// *Cost*: as for [`meets_along`](Self::meets_along); shapes that meet take the same axes again
    /// without vectors. In floats, contact that is not certain takes wider integers.
    ///
    /// ```
    /// use septum::relation::Relation;
    /// use septum::sweep::{Motion, Sweep};
    /// use septum::Aabb;
    ///
    /// let floor = Aabb::from_min_max([-9.0, -9.0, -1.0], [9.0, 9.0, 0.0])?;
    /// let body = Aabb::from_center_half_extents([0.0, 0.0, 0.5], [0.5; 3])?; // on the floor
    /// let to = |p: [f64; 3]| Motion::new([0.0, 0.0, 0.5], p);
    /// assert_eq!(body.relation_along(&to([5.0, 1.0, 0.5])?, &floor), Relation::Touching);
    /// assert_eq!(body.relation_along(&to([5.0, 1.0, 0.75])?, &floor), Relation::Touching);
    /// assert_eq!(body.relation_along(&to([5.0, 1.0, 0.25])?, &floor), Relation::Overlapping);
    /// # Ok::<(), septum::ShapeError>(())
    /// ```
    #[must_use]
    fn relation_along(&self, motion: &Motion<Self::Scalar>, other: &Other) -> Relation;

    /// Where on its way can this shape stop, at the latest, without overlapping `other`? `None` if
    /// the two overlap at the start.
    ///
    /// The result is a [`place`](Motion::place) of the motion: the place after the last step that
    /// is free, or [`to`](Motion::to) if the whole motion is free. A step is free if the straight
    /// way from the start to its place is: [`relation_along`](Self::relation_along) is not
    /// [`Overlapping`](Relation::Overlapping). Shapes may touch at the result. The next step is
    /// not free.
    ///
    /// Places are rounded, so ways to places that graze an obstacle may be free and blocked in
    /// turn. The result is then one of the free places before a blocked one.
    ///
    /// *Numerics*: exact for a shape moved by exactly `place − from`. To move a box without rounding,
    /// give it by its centre, and begin the motion there: the box at the place is
    /// [`Aabb::from_center_half_extents`] of the place. In fixed point every shape moves exactly.
    ///
    /// *Range*: as for [`meets_along`](Self::meets_along). *Panics*: never.
    ///
    /// *Cost*: [`relation_along`](Self::relation_along) once if the motion is free, otherwise once
    /// for each binary digit of the number of steps: up to 34 times in `f32`, 66 in `f64`.
    ///
    /// ```
    /// use septum::relation::{Relate, Relation};
    /// use septum::sweep::{Motion, Sweep};
    /// use septum::Aabb;
    ///
    /// let wall = Aabb::from_min_max([-9.0, -9.0, -1.0], [9.0, 9.0, 0.1])?;
    /// let cube = |center| Aabb::from_center_half_extents(center, [0.375; 3]);
    /// let shot = Motion::new([0.0, 0.0, 4.49], [0.0, 0.0, -4.49])?;
    /// let body = cube(shot.from())?;
    ///
    /// let t = body.first_contact(&shot, &wall).unwrap().t;
    /// assert_eq!(cube(shot.at(t))?.relation(&wall), Relation::Overlapping); // by rounding
    /// let stop = body.last_free(&shot, &wall).unwrap();
    /// assert!(cube(stop)?.relation(&wall) < Relation::Overlapping);
    /// # Ok::<(), septum::ShapeError>(())
    /// ```
    #[doc(alias = "shape cast")]
    #[must_use]
    fn last_free(&self, motion: &Motion<Self::Scalar>, other: &Other) -> Option<Vec3<Self::Scalar>>
    where
        Self::Scalar: Scalar,
    {
        motion.last_free(|way| self.relation_along(way, other) != Relation::Overlapping)
    }
}

impl<S: Scalar> Sweep<Aabb<S>> for Triangle<S> {
    type Scalar = S;
    type Contact = FirstContact<S>;

    #[inline]
    fn meets_along(&self, motion: &Motion<S>, aabb: &Aabb<S>) -> bool {
        Passing::new(self, aabb, motion).meet()
    }

    #[inline]
    fn first_contact(&self, motion: &Motion<S>, aabb: &Aabb<S>) -> Option<FirstContact<S>> {
        Passing::new(self, aabb, motion).first_contact()
    }

    fn relation_along(&self, motion: &Motion<S>, aabb: &Aabb<S>) -> Relation {
        Passing::new(self, aabb, motion).relation()
    }
}

impl<S: Scalar> Sweep<Triangle<S>> for Aabb<S> {
    type Scalar = S;
    type Contact = FirstContact<S>;

    #[inline]
    fn meets_along(&self, motion: &Motion<S>, triangle: &Triangle<S>) -> bool {
        Passing::reversed(triangle, self, motion).meet()
    }

    #[inline]
    fn first_contact(&self, motion: &Motion<S>, triangle: &Triangle<S>) -> Option<FirstContact<S>> {
        Passing::reversed(triangle, self, motion).first_contact()
    }

    fn relation_along(&self, motion: &Motion<S>, triangle: &Triangle<S>) -> Relation {
        Passing::reversed(triangle, self, motion).relation()
    }
}
