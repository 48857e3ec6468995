//! Shapes that move past others: whether they meet, and when first.

mod aabb_aabb;
mod error_bound;
mod exact;
mod in_doubles;
mod instants;
mod kernel;
mod latest;
mod motion;
mod one_axis;
mod rows;
mod time;

pub use motion::Motion;

use self::exact::ExactCourse;
use self::kernel::Course;
use self::time::{Instant, Last, Meets, When};
use super::Axis;
use super::triangle_aabb::frame::{BoxForm, Frame};
use crate::arithmetic::{Arithmetic, Embeds, Float, InFloat, Number};
use crate::robust::Predicate;
use crate::scalar::Scalar;
use crate::shape::{Aabb, AabbForm, Triangle, Vec3};

/// When a shape that moves first meets another, and how.
#[doc(alias = "time of impact")]
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(deny_unknown_fields))]
pub struct FirstContact<S> {
    /// The part of the motion before it, from zero to one: the greatest number of the scalar that
    /// is not above the true time.
    ///
    /// So it is never late, and a float is less than one unit in the last place early. A
    /// fixed-point type that ends below one says its end for what is beyond.
    pub t: S,
    /// The axis on which the shapes are apart until then; none if they meet at the start.
    ///
    /// Of several axes, whose times are one number of the scalar, it is the first in the order of
    /// [`Axis::ALL`]. Axes are those of the triangle, or of two boxes the three
    /// [`Axis::Face`].
    pub axis: Option<Axis>,
}

/// A shape that can be moved past another.
///
/// There is an implementation for each pair that can be asked about. A triangle that moves past a
/// box is the box that moves past the triangle by [`Motion::reversed`].
pub trait Sweep<Other> {
    /// The scalar of both shapes.
    type Scalar;

    /// Whether this shape, as it moves, has a point in common with the other at any time.
    ///
    /// *Geometry*: closed sets in one frame and unit. This one is given as it lies at the start,
    /// and every point of it moves by `to` − `from` of the motion. That is a translation: bodies
    /// that turn need another way, such as a sweep of what encloses them as they turn.
    ///
    /// *Contact*: touching is contact, at the start and at the end too. No motion is
    /// [`overlaps`](crate::Overlaps::overlaps).
    ///
    /// *Numerics*: exact for every valid input, in every scalar: no difference of the motion and
    /// no sum of it and a coordinate is rounded.
    ///
    /// *Range*: all finite floats, all fixed-point values. The fast stage serves what
    /// [`overlaps`](crate::Triangle#impl-Overlaps<Aabb<S>>-for-Triangle<S>) says of the two shapes
    /// and the way together.
    ///
    /// *Panics*: never.
    ///
    /// *Cost*: of a triangle and a box 111 multiplications, unless a face separates all of the way,
    /// and less and five quotients of four floats at once if they meet; of two boxes 12, and no
    /// division. Floats within rounding of contact take it again in wider numbers, at last in exact
    /// sums.
    ///
    /// *Source*: separating axes of sums of convex sets (Gottschalk, Lin and Manocha 1996, for
    /// boxes); that the way is an edge like others, the bounds and the exact stages are ours.
    #[must_use]
    fn meets_along(&self, motion: &Motion<Self::Scalar>, other: &Other) -> bool;

    /// When this shape, as it moves, first has a point in common with the other; nothing if it
    /// [misses](Self::meets_along) it.
    ///
    /// *Contact*: shapes that touch at the start meet at time zero.
    ///
    /// *Numerics*: exact but for one rounding, down: see [`FirstContact`]. If an axis is told, the
    /// shapes are apart until that time, and then apart still or in touch.
    ///
    /// *Panics*: never. *Cost*: [`meets_along`](Self::meets_along), and for shapes that meet one of
    /// its axes once more, in `f64`, and two divisions; for an answer in `f64` in 106 digits, and
    /// in fixed point of 64 bits a division of integers. Where floats are dear, or two axes close
    /// at about the same time, every axis with a gap.
    #[doc(alias = "time of impact")]
    #[doc(alias = "continuous collision")]
    #[must_use]
    fn first_contact(
        &self,
        motion: &Motion<Self::Scalar>,
        other: &Other,
    ) -> Option<FirstContact<Self::Scalar>>;
}

/// A triangle that moves past a box.
struct Passing<'a, S> {
    triangle: &'a Triangle<S>,
    aabb: &'a Aabb<S>,
    /// By reference, as it lies: a copy just made would not be in memory yet when it is loaded as
    /// a vector.
    motion: &'a Motion<S>,
    /// Whether the triangle goes back.
    is_reversed: bool,
}

impl<'a, S: Scalar> Passing<'a, S> {
    #[inline(always)]
    fn new(triangle: &'a Triangle<S>, aabb: &'a Aabb<S>, motion: &'a Motion<S>) -> Self {
        Self { triangle, aabb, motion, is_reversed: false }
    }

    /// The box moves.
    #[inline(always)]
    fn reversed(triangle: &'a Triangle<S>, aabb: &'a Aabb<S>, motion: &'a Motion<S>) -> Self {
        Self { triangle, aabb, motion, is_reversed: true }
    }

    /// From where to where the triangle moves.
    #[inline(always)]
    fn ends(&self) -> [Vec3<S>; 2] {
        let (from, to) = (self.motion.from(), self.motion.to());
        if self.is_reversed { [to, from] } else { [from, to] }
    }

    #[inline(always)]
    fn given<N: Embeds<S>>(&self) -> Option<Given<N>> {
        let [a, b, c] = self.triangle.points();
        let [from, to] = self.ends();
        let (AabbForm::Center { center: p, half: q } | AabbForm::Corners { min: p, max: q }) =
            self.aabb.form();
        let all = [a, b, c, p.to_array(), q.to_array(), from.to_array(), to.to_array()];
        let [a, b, c, p, q, from, to] = N::embed(&all)?;
        let is_by_center = matches!(self.aabb.form(), AabbForm::Center { .. });
        Some(Given { triangle: [a, b, c], p, q, is_by_center, way: [from, to] })
    }

    #[inline(always)]
    fn course<N: Embeds<S>>(&self) -> Option<Course<N>> {
        let Given { triangle, p, q, is_by_center, way: [from, to] } = self.given::<N>()?;
        let form = if is_by_center {
            BoxForm::Center(p, q)
        } else {
            BoxForm::Corners(p, q, [N::Length::ZERO; 3])
        };
        let d = [to[0] - from[0], to[1] - from[1], to[2] - from[2]];
        Some(Course { frame: Frame::new(&triangle, &form), d })
    }

    fn exactly(&self) -> ExactCourse {
        ExactCourse::new(self.triangle, self.aabb, self.ends())
    }
}

/// The numbers of shapes and way in a number system.
struct Given<N: Arithmetic> {
    triangle: [[N::Length; 3]; 3],
    p: [N::Length; 3],
    q: [N::Length; 3],
    /// Whether p and q are centre and half-extents, or corners.
    is_by_center: bool,
    way: [[N::Length; 3]; 2],
}

/// The question whether it misses it.
struct Misses<'a, S>(Passing<'a, S>);

impl<S: Scalar> Predicate<S> for Misses<'_, S> {
    type Answer = bool;

    fn filter<N: Embeds<S>>(&self) -> Option<bool> {
        self.0.course::<N>()?.misses()
    }

    const IN_QUADS: bool = true;

    #[inline(always)]
    fn in_quads<F: Float>(&self) -> Option<bool>
    where
        S: InFloat<F>,
    {
        rows::misses::<S, F>(&self.0)
    }

    fn exact(&self) -> bool {
        self.0.exactly().misses::<S>()
    }
}

impl<S: Scalar> Passing<'_, S> {
    #[inline]
    fn meet(self) -> bool {
        !S::evaluate(&Misses(self))
    }

    fn first_contact(self) -> Option<FirstContact<S>> {
        let instant = if S::IN_QUADS { S::in_quads(&When(&self)) } else { None };
        match instant {
            Some(Instant::Misses) => None,
            Some(Instant::AtStart) => Some(FirstContact::default()),
            Some(Instant::Meets(last)) => Some(S::evaluate_numeric(&Meets { passing: self, last })),
            Some(Instant::Unknown) | None => {
                let misses = Misses(self);
                let is_miss =
                    if S::IN_QUADS { S::without_quads(&misses) } else { S::evaluate(&misses) };
                let passing = misses.0;
                (!is_miss).then(|| S::evaluate_numeric(&Meets { passing, last: None }))
            }
        }
    }
}

impl<S: Scalar> Sweep<Aabb<S>> for Triangle<S> {
    type Scalar = S;

    #[inline]
    fn meets_along(&self, motion: &Motion<S>, aabb: &Aabb<S>) -> bool {
        Passing::new(self, aabb, motion).meet()
    }

    #[inline]
    fn first_contact(&self, motion: &Motion<S>, aabb: &Aabb<S>) -> Option<FirstContact<S>> {
        Passing::new(self, aabb, motion).first_contact()
    }
}

impl<S: Scalar> Sweep<Triangle<S>> for Aabb<S> {
    type Scalar = S;

    #[inline]
    fn meets_along(&self, motion: &Motion<S>, triangle: &Triangle<S>) -> bool {
        Passing::reversed(triangle, self, motion).meet()
    }

    #[inline]
    fn first_contact(&self, motion: &Motion<S>, triangle: &Triangle<S>) -> Option<FirstContact<S>> {
        Passing::reversed(triangle, self, motion).first_contact()
    }
}
