//! Spheres that move past triangles and boxes.
//!
//! A sphere that moves covers the capsule of its centre's way. Whether that meets a shape is asked as
//! of any [capsule](crate::query::capsule), but its second end is a sum that is not rounded. The
//! centre enters all points within the radius of the shape: those over a face, around an edge, or
//! around a vertex. `triangle` and `aabb` say when, and which.
//!
//! The vectors to the end of the way are sums of the vectors to its start and of the way, and err by a
//! roundoff of each and of themselves: the slack, where it is asked whether a shape lies farther from
//! the way than the radius, is the sum of these sizes.

mod aabb;
mod triangle;

use super::{Motion, Sweep};
use crate::arithmetic::{Arithmetic, Embeds, Number, largest, pick, three, two};
use crate::query::capsule::{box_lies_beyond, triangle_lies_beyond};
use crate::query::orientation::{Vector, from};
use crate::query::relation::Relation;
use crate::query::sphere::{Ball, Reach, around, largest_of, of_ball, to_corners};
use crate::query::surd::Question;
use crate::query::{Feature, Overlaps};
use crate::robust::{Numeric, Predicate, Uncertain};
use crate::scalar::Scalar;
use crate::shape::{Aabb, Sphere, Triangle};

/// When and where a moving sphere first meets a shape.
///
/// ```
/// use septum::sweep::{Motion, Sweep};
/// use septum::{Aabb, Feature, Sphere, Triangle};
///
/// let ball = Sphere::new([0.0_f32, 0.0, 9.0], 5.0)?;
/// let fall = Motion::new([0.0, 0.0, 9.0], [0.0, 0.0, 1.0])?;
/// let roof = Triangle::new([-8.0, 3.0, 2.0], [8.0, 3.0, 2.0], [0.0, 9.0, 2.0])?;
/// let first = ball.first_contact(&fall, &roof).unwrap();
/// assert_eq!((first.t, first.part), (0.375, Some(Feature::Edge(0)))); // 3 beside it, 4 above it
/// let cell = Aabb::from_min_max([-1.0, -1.0, 0.0], [1.0, 1.0, 2.0])?;
/// let first = ball.first_contact(&fall, &cell).unwrap();
/// assert_eq!((first.t, first.part), (0.25, Some([0, 0, 1]))); // on its upper face
/// # Ok::<(), septum::ShapeError>(())
/// ```
#[doc(alias = "time of impact")]
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(deny_unknown_fields))]
pub struct SphereContact<S, P> {
    /// The time of the first contact, as [`FirstContact::t`](super::FirstContact::t): the greatest
    /// number of the scalar that is not above the true time.
    pub t: S,
    /// The part of the shape that the sphere touches at that time; `None` if they meet at the start.
    ///
    /// A triangle has a [`Feature`]. A box has a side on each axis: −1 and 1 for the low and the high
    /// face, 0 between the two. Three sides are a corner, two an edge, and one a face.
    ///
    /// If several parts of a triangle are met at the same number of the scalar, an edge comes before
    /// a vertex, and the lower number first. Of a box, the sides are those of the sphere's centre at
    /// that moment. A centre exactly between two sides has the one that it comes from, or 0 if it does not
    /// move on that axis.
    pub part: Option<P>,
}

/// A sphere that moves past a shape.
struct Passing<'a, S, T> {
    sphere: &'a Sphere<S>,
    motion: &'a Motion<S>,
    shape: &'a T,
}

impl<S: Scalar, T> Passing<'_, S, T> {
    /// The centre, three times the radius, and both ends of the motion.
    fn way(&self) -> [[S; 3]; 4] {
        let (from, to) = (self.motion.from().to_array(), self.motion.to().to_array());
        [self.sphere.center().to_array(), [self.sphere.radius(); 3], from, to]
    }
}

impl<'a, S: Scalar, T> Passing<'a, S, T>
where
    Beyond<'a, S, T>: Predicate<S, Answer = bool>,
    Aabb<S>: Sweep<T, Scalar = S>,
    Sphere<S>: Overlaps<T>,
{
    /// Whether the sphere meets the shape on its way, or its points nearer than the radius.
    fn meets(&self, ball: Ball) -> bool {
        let passing = Passing { ..*self };
        !S::evaluate_numeric(&Beyond { passing, ball })
            || self.center().is_some_and(|center| center.meets_along(self.motion, self.shape))
    }

    /// The centre, as a box. It is finite.
    fn center(&self) -> Option<Aabb<S>> {
        Aabb::from_min_max(self.sphere.center(), self.sphere.center()).ok()
    }

    fn relation(&self) -> Relation {
        let of_center = || {
            let center = self.center();
            center.map_or(Relation::Disjoint, |c| c.relation_along(self.motion, self.shape))
        };
        of_ball(self.sphere.radius() > S::ZERO, |ball| self.meets(ball), of_center)
    }

    fn first_contact<P, const K: usize>(&self) -> Option<SphereContact<S, P>>
    where
        Self: Question<S, K, Answer = SphereContact<S, P>>,
    {
        if !self.meets(Ball::Closed) {
            return None;
        }
        let at_start = SphereContact { t: S::ZERO, part: None };
        if self.sphere.overlaps(self.shape) {
            return Some(at_start);
        }
        // Exact numbers always have an answer.
        Some(self.settle().unwrap_or(at_start))
    }
}

impl<S: Scalar> Sweep<Triangle<S>> for Sphere<S> {
    type Scalar = S;
    type Contact = SphereContact<S, Feature>;

    fn meets_along(&self, motion: &Motion<S>, triangle: &Triangle<S>) -> bool {
        Passing { sphere: self, motion, shape: triangle }.meets(Ball::Closed)
    }

    fn first_contact(&self, motion: &Motion<S>, triangle: &Triangle<S>) -> Option<Self::Contact> {
        Passing { sphere: self, motion, shape: triangle }.first_contact()
    }

    fn relation_along(&self, motion: &Motion<S>, triangle: &Triangle<S>) -> Relation {
        Passing { sphere: self, motion, shape: triangle }.relation()
    }
}

impl<S: Scalar> Sweep<Aabb<S>> for Sphere<S> {
    type Scalar = S;
    type Contact = SphereContact<S, [i8; 3]>;

    fn meets_along(&self, motion: &Motion<S>, aabb: &Aabb<S>) -> bool {
        Passing { sphere: self, motion, shape: aabb }.meets(Ball::Closed)
    }

    fn first_contact(&self, motion: &Motion<S>, aabb: &Aabb<S>) -> Option<Self::Contact> {
        Passing { sphere: self, motion, shape: aabb }.first_contact()
    }

    fn relation_along(&self, motion: &Motion<S>, aabb: &Aabb<S>) -> Relation {
        Passing { sphere: self, motion, shape: aabb }.relation()
    }
}

/// Roundoffs of a component less the radius, of slack and radius. To first order 4: 2 of the
/// component, and 2 of the difference. `beyond.g` proves it.
const ASIDE: u16 = 8;

/// The question whether the boundary of a shape lies farther from the way of a sphere's centre than
/// its radius.
struct Beyond<'a, S, T> {
    passing: Passing<'a, S, T>,
    ball: Ball,
}

/// Whether a coordinate alone keeps all points to which these vectors go beyond the radius.
#[inline(always)]
fn lie_aside<N: Arithmetic, const K: usize>(
    vectors: [&[Vector<N>; K]; 2],
    radius: N::Length,
    slack: N::Length,
) -> bool {
    let error = (slack + radius).error(ASIDE);
    let is_above = |sign: fn(N::Length) -> N::Length| {
        three(|i| {
            let of = |v: &Vector<N>| sign(*pick(v, i)) - radius;
            vectors.iter().copied().flatten().all(|v| Uncertain::above(of(v), error).certain)
        })
    };
    is_above(|x| x).contains(&true) || is_above(|x| -x).contains(&true)
}

impl<S: Scalar> Predicate<S> for Beyond<'_, S, Triangle<S>> {
    type Answer = bool;

    #[inline]
    fn filter<N: Embeds<S>>(&self) -> Option<bool> {
        let ([center, radius, start, end], [a, b, c]) =
            (self.passing.way(), self.passing.shape.points());
        let [center, [r, ..], start, end, a, b, c] =
            N::embed(&[center, radius, start, end, a, b, c])?;
        let d = from::<N>(&end, &start);
        let [to_start, edges] = around::<N>(&center, &[a, b, c]);
        let to_end = three(|k| three(|i| to_start[k][i] + d[i]));
        let slack =
            if N::CERTAIN { N::Length::ZERO } else { largest_of::<N, 3>(&to_start) + largest(&d) };
        if lie_aside::<N, 3>([&to_start, &to_end], r, slack) {
            return Some(true);
        }
        let reach = Reach::<N>::new(r, self.ball);
        triangle_lies_beyond::<N>(&reach, [&to_start, &to_end], &edges, &d, slack)
    }
}

impl<S: Scalar> Predicate<S> for Beyond<'_, S, Aabb<S>> {
    type Answer = bool;

    #[inline]
    fn filter<N: Embeds<S>>(&self) -> Option<bool> {
        let (p, q, is_by_center) = self.passing.shape.numbers();
        let [center, radius, start, end] = self.passing.way();
        let [center, [r, ..], start, end, p, q] = N::embed(&[center, radius, start, end, p, q])?;
        let (d, to_p) = (from::<N>(&end, &start), from::<N>(&p, &center));
        // From each end to both extreme corners.
        let at_start = to_corners::<N>(&center, [&p, &q], is_by_center);
        let extents = if is_by_center { three(|i| q[i] + q[i]) } else { from::<N>(&q, &p) };
        let at_end = two(|k| from::<N>(&at_start[k], &d));
        let slack = if N::CERTAIN {
            N::Length::ZERO
        } else {
            largest(&to_p) + largest_of::<N, 2>(&at_start) + largest(&d)
        };
        if lie_aside::<N, 2>([&at_start, &at_end], r, slack) {
            return Some(true);
        }
        let reach = Reach::<N>::new(r, self.ball);
        box_lies_beyond::<N>(&reach, &[at_start, at_end], &extents, &d, slack)
    }
}

impl<S, T> Numeric<S> for Beyond<'_, S, T> where Self: Predicate<S> {}
