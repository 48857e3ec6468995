//! Distances: spheres against points, triangles, lines, planes, boxes and spheres; closest points.

mod closest;
mod distance;
mod distance_range;
mod error_bound;
mod face;
mod foot;
mod kernel;
mod obb;
mod plane;
mod ray;
mod relation;

use self::kernel::to_ends;
use super::Overlaps;
use super::orientation::{Vector, from};
use crate::arithmetic::{Embeds, Number, greatest, largest, three};
use crate::robust::{Numeric, Predicate, Profile};
use crate::scalar::Scalar;
use crate::shape::{Aabb, Segment, Sphere, Vec3};

pub use self::closest::Closest;
pub(crate) use self::distance::compare_distances;
pub(super) use self::error_bound::{Errors, PRODUCT, SQUARES};
pub(super) use self::kernel::{Ball, Reach, around, largest_of, minors, to_corners, volume};
pub(crate) use self::kernel::{along, product};
pub(super) use self::obb::{Corners, corners};
pub(super) use self::plane::meets_plane;
pub(super) use self::ray::Way;
pub(super) use self::relation::of_ball;
pub(super) use ray::{at_distance, first_at_distance};

/// The question whether a shape lies outside of a sphere, or its boundary farther from a capsule's
/// segment than the capsule's radius.
pub(super) struct Beyond<'a, R, T> {
    pub(super) round: &'a R,
    pub(super) shape: &'a T,
    pub(super) ball: Ball,
}

impl<S: Scalar, T> Beyond<'_, Sphere<S>, T> {
    fn center(&self) -> [S; 3] {
        self.round.center().to_array()
    }

    fn radius(&self) -> [S; 3] {
        [self.round.radius(); 3]
    }
}

impl<S: Scalar> Predicate<S> for Beyond<'_, Sphere<S>, Segment<S>> {
    type Answer = bool;
    const PROFILE: Profile = Profile::AREAS;

    #[inline]
    fn filter<N: Embeds<S>>(&self) -> Option<bool> {
        lies_beyond::<S, N>(self.center(), self.radius(), self.shape, self.ball, |[r, ..]| r)
    }
}

/// Whether a segment lies farther from a point than a radius, which is made of up to three lengths.
#[inline(always)]
pub(super) fn lies_beyond<S: Scalar, N: Embeds<S>>(
    center: [S; 3],
    radii: [S; 3],
    segment: &Segment<S>,
    ball: Ball,
    radius: impl Fn(Vector<N>) -> N::Length,
) -> Option<bool> {
    let (a, b, is_by_center) = segment.numbers();
    let [center, radii, a, b] = N::embed(&[center, radii, a, b])?;
    let reach = Reach::<N>::new(radius(radii), ball);
    // A path for each form.
    if is_by_center {
        let (ends, e) = to_ends::<N>(&center, [&a, &b], true);
        let slack = greatest(largest(&from::<N>(&center, &a)), largest(&b));
        reach.excludes_segment(&ends, &e, slack)
    } else {
        let (ends, e) = to_ends::<N>(&center, [&a, &b], false);
        reach.excludes_segment(&ends, &e, N::Length::ZERO)
    }
}

impl<S: Scalar> Predicate<S> for Beyond<'_, Sphere<S>, Aabb<S>> {
    type Answer = bool;
    const PROFILE: Profile = Profile::AREAS;

    #[inline]
    fn filter<N: Embeds<S>>(&self) -> Option<bool> {
        let (p, q, is_by_center) = self.shape.numbers();
        let [c, [r, ..], p, q] = N::embed(&[self.center(), self.radius(), p, q])?;
        let above = |x: N::Length| greatest(x, N::Length::ZERO);
        let (d, slack) = if is_by_center {
            let d = from::<N>(&c, &p);
            (three(|i| above(d[i].magnitude() - q[i])), largest(&d))
        } else {
            (three(|i| above(greatest(p[i] - c[i], c[i] - q[i]))), N::Length::ZERO)
        };
        Reach::<N>::new(r, self.ball).excludes_if_in_range(&d, slack)
    }
}

impl<S: Scalar> Predicate<S> for Beyond<'_, Sphere<S>, Vec3<S>> {
    type Answer = bool;
    const PROFILE: Profile = Profile::AREAS;

    #[inline]
    fn filter<N: Embeds<S>>(&self) -> Option<bool> {
        let all = [self.center(), self.radius(), self.shape.to_array()];
        let [center, [r, ..], point] = N::embed(&all)?;
        let d = from::<N>(&center, &point);
        Reach::<N>::new(r, self.ball).excludes_if_in_range(&d, N::Length::ZERO)
    }
}

impl<S: Scalar> Predicate<S> for Beyond<'_, Sphere<S>, Sphere<S>> {
    type Answer = bool;
    const PROFILE: Profile = Profile::AREAS;

    #[inline]
    fn filter<N: Embeds<S>>(&self) -> Option<bool> {
        let (center, r) = (self.shape.center().to_array(), self.shape.radius());
        let radii = [self.round.radius(), r, S::ZERO];
        let [p, q, [r, s, _]] = N::embed(&[self.center(), center, radii])?;
        Reach::<N>::new(r + s, self.ball).excludes_if_in_range(&from::<N>(&p, &q), N::Length::ZERO)
    }
}

impl<S, R, T> Numeric<S> for Beyond<'_, R, T> where Self: Predicate<S> {}

/// Whether the shape, or for a capsule its boundary, meets the round one, or its points nearer than
/// the radius. On hosts `f64` answers for all scalars of up to 32 bits.
#[inline(always)]
pub(super) fn meet<'a, S: Scalar, R, T>(round: &'a R, shape: &'a T, ball: Ball) -> bool
where
    Beyond<'a, R, T>: Predicate<S, Answer = bool>,
{
    !S::evaluate_numeric(&Beyond { round, shape, ball })
}

impl<S: Scalar> Overlaps<Segment<S>> for Sphere<S> {
    /// Do a sphere and a segment have a point in common?
    ///
    /// *Geometry*: closed sets, the segment in the form in which it was given. The radius may be
    /// zero, the segment a point.
    ///
    /// *Contact*, *Numerics* and *Range*: as for a
    /// [triangle](Sphere#impl-Overlaps<Triangle<S>>-for-Sphere<S>), in products of up to four
    /// lengths.
    ///
    /// *Panics*: never. *Cost*: 6 comparisons if a coordinate separates, 7 to 25 multiplications
    /// otherwise.
    ///
    /// ```
    /// use septum::{Segment, Sphere};
    ///
    /// let s = Segment::new([0.0_f64, 0.0, 0.0], [4.0, 3.0, 0.0])?;
    /// assert!(Sphere::new([-3.0, 4.0, 0.0], 5.0)?.overlaps(&s)); // touches the end
    /// assert!(Sphere::new([-1.0, 5.5, 0.0], 5.0)?.overlaps(&s)); // touches the line
    /// assert!(!Sphere::new([-1.0, 5.5, 1e-7], 5.0)?.overlaps(&s));
    /// # Ok::<(), septum::ShapeError>(())
    /// ```
    #[inline]
    fn overlaps(&self, segment: &Segment<S>) -> bool {
        meet(self, segment, Ball::Closed)
    }
}

impl<S: Scalar> Overlaps<Aabb<S>> for Sphere<S> {
    /// Do a sphere and an axis-aligned box have a point in common?
    ///
    /// *Geometry*: closed sets, the box in the form in which it was given. The radius may be zero,
    /// the box flat or a point.
    ///
    /// *Contact*, *Numerics* and *Range*: as for a
    /// [triangle](Sphere#impl-Overlaps<Triangle<S>>-for-Sphere<S>), in products of two lengths.
    ///
    /// *Panics*: never. *Cost*: 4 multiplications.
    ///
    /// *Source*: J. Arvo, "A Simple Method for Box-Sphere Intersection Testing", *Graphics Gems*,
    /// 1990; the exact stages are ours.
    ///
    /// ```
    /// use septum::{Aabb, Sphere};
    ///
    /// let cell = Aabb::from_min_max([0.0_f32; 3], [1.0; 3])?;
    /// assert!(Sphere::new([4.0, 5.0, 13.0], 13.0)?.overlaps(&cell)); // 3² + 4² + 12² = 13²
    /// assert!(!Sphere::new([4.000001, 5.0, 13.0], 13.0)?.overlaps(&cell));
    /// # Ok::<(), septum::ShapeError>(())
    /// ```
    #[inline]
    fn overlaps(&self, aabb: &Aabb<S>) -> bool {
        meet(self, aabb, Ball::Closed)
    }
}

impl<S: Scalar> Overlaps<Self> for Sphere<S> {
    /// Do two spheres have a point in common?
    ///
    /// *Contact*, *Numerics* and *Range*: as for a
    /// [triangle](Sphere#impl-Overlaps<Triangle<S>>-for-Sphere<S>), in products of two lengths. The
    /// sum of the radii is exact.
    ///
    /// *Panics*: never. *Cost*: 4 multiplications.
    ///
    /// ```
    /// use septum::Sphere;
    ///
    /// let ball = Sphere::new([0.0_f32; 3], 1e-8)?;
    /// assert!(Sphere::new([1.0, 0.0, 0.0], 1.0)?.overlaps(&ball));
    /// assert!(!Sphere::new([1.0000001, 0.0, 0.0], 1.0)?.overlaps(&ball));
    /// # Ok::<(), septum::ShapeError>(())
    /// ```
    #[inline]
    fn overlaps(&self, other: &Self) -> bool {
        meet(self, other, Ball::Closed)
    }
}

impl<S: Scalar> Sphere<S> {
    /// Does the sphere contain a point: is that within the radius of the centre?
    ///
    /// *Geometry*: a closed ball. No sphere contains a point with a NaN or infinite coordinate.
    ///
    /// *Contact*: a point on the surface is in the sphere.
    ///
    /// *Numerics*: exact for every valid input, in every scalar.
    ///
    /// *Panics*: never. *Cost*: 4 multiplications.
    ///
    /// ```
    /// use septum::Sphere;
    ///
    /// let ball = Sphere::new([0.0_f32; 3], 7.0)?;
    /// assert!(ball.contains([2.0, 3.0, 6.0])); // 4 + 9 + 36 = 49
    /// assert!(!ball.contains([2.0, 3.0, 6.0000005]));
    /// # Ok::<(), septum::ShapeError>(())
    /// ```
    #[inline]
    #[must_use]
    pub fn contains(&self, point: impl Into<Vec3<S>>) -> bool {
        let point = point.into();
        point.is_finite() && meet(self, &point, Ball::Closed)
    }
}
