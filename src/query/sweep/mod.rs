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
use crate::arithmetic::{Arithmetic, Embeds, Float, InFloat, Number, REGISTERS_ARE_WIDE};
use crate::robust::{Predicate, Profile, in_exact_numbers};
use crate::scalar::Scalar;
use crate::shape::{Aabb, AabbForm, Triangle, Vec3};

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

/// A shape that can be moved past another.
///
/// Each pair of shapes has an implementation. To move a triangle past a box is to move the box past
/// the triangle by [`Motion::reversed`].
pub trait Sweep<Other> {
    /// The scalar of the two shapes.
    type Scalar;

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
    /// *Cost*: a triangle and a box take 111 multiplications, unless a face separates them all the
    /// way. If they meet, the query takes fewer, and five quotients of four floats at once. Two
    /// boxes take 12 multiplications and no division. Floats within rounding of contact are decided
    /// in wider numbers, at last in exact integers.
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
    /// *Numerics*: exact except for one rounding, downwards: see [`FirstContact`]. If the result
    /// names an axis, the shapes are apart before that time; at that time they touch or are still
    /// apart.
    ///
    /// *Panics*: never. *Cost*: as for [`meets_along`](Self::meets_along). Shapes that meet also
    /// take one of its axes again in `f64`, and two divisions. A result in `f64` takes that axis in
    /// 106 digits, and one in fixed point of 64 bits a division of integers. On 32-bit cores, and
    /// where two axes close at about the same time, every axis with a gap is computed.
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
    /// Borrowed in place. A fresh copy would not have reached memory when it is loaded as a vector,
    /// and the load would wait.
    motion: &'a Motion<S>,
    /// Whether the triangle moves backwards, because the box is what moves.
    is_reversed: bool,
}

impl<'a, S: Scalar> Passing<'a, S> {
    #[inline(always)]
    fn new(triangle: &'a Triangle<S>, aabb: &'a Aabb<S>, motion: &'a Motion<S>) -> Self {
        Self { triangle, aabb, motion, is_reversed: false }
    }

    /// The box moves, so in its frame the triangle goes back.
    #[inline(always)]
    fn reversed(triangle: &'a Triangle<S>, aabb: &'a Aabb<S>, motion: &'a Motion<S>) -> Self {
        Self { triangle, aabb, motion, is_reversed: true }
    }

    /// Where the triangle's motion begins and ends.
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

/// The coordinates of the shapes and the motion in a number system.
struct Given<N: Arithmetic> {
    triangle: [[N::Length; 3]; 3],
    p: [N::Length; 3],
    q: [N::Length; 3],
    /// Whether p and q are centre and half-extents; otherwise they are corners.
    is_by_center: bool,
    way: [[N::Length; 3]; 2],
}

/// Does the triangle miss the box?
struct Misses<'a, S>(Passing<'a, S>);

impl<S: Scalar> Predicate<S> for Misses<'_, S> {
    type Answer = bool;

    fn filter<N: Embeds<S>>(&self) -> Option<bool> {
        self.0.course::<N>()?.misses()
    }

    const PROFILE: Profile = Profile::QUADS;

    #[inline(always)]
    fn in_quads<F: Float>(&self) -> Option<bool>
    where
        S: InFloat<F>,
    {
        rows::misses::<S, F>(&self.0)
    }

    fn exact(&self) -> bool {
        if REGISTERS_ARE_WIDE {
            return in_exact_numbers(self);
        }
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
