//! Capsules against points, planes, spheres, lines, triangles, boxes and capsules.
//!
//! The differences of the points of two segments form a parallelogram, and the segments are as far
//! apart as that is from the origin: the kernel of sphere and triangle serves, with four edges in
//! place of three. A segment that does not meet a triangle or a box is as far from it as one of its
//! ends from the shape, or as the segment from an edge. Therefore a pair asks the segment's own
//! `overlaps`, and a question about distances.

mod boxes;
mod crossing;
mod ray;
mod relation;
mod triangle;

pub(super) use self::boxes::box_lies_beyond;
pub(super) use self::crossing::Crossing;
use self::triangle::meets_triangle;
pub(super) use self::triangle::triangle_lies_beyond;
use super::Overlaps;
use super::orientation::{Vector, from};
use super::sphere::{Ball, Beyond, Errors, Reach, lies_beyond, meet, meets_plane};
use crate::arithmetic::{Arithmetic, Embeds, Number, greatest, largest, three};
use crate::robust::{Numeric, Predicate, Profile};
use crate::scalar::Scalar;
use crate::shape::{Capsule, Plane, Segment, Sphere, Vec3};

impl<S: Scalar, T> Beyond<'_, Capsule<S>, T> {
    fn ends(&self) -> [[S; 3]; 2] {
        let (a, b) = self.round.ends();
        [a.to_array(), b.to_array()]
    }
}

/// Vectors from both ends of a segment to both ends of another, and along both segments.
struct Between<N: Arithmetic> {
    ends: [[Vector<N>; 2]; 2],
    along: [Vector<N>; 2],
}

impl<N: Arithmetic> Between<N> {
    /// Whether the segments lie farther apart than the radius; `None` in doubt. The vectors err as
    /// `Reach::excludes` says.
    #[inline(never)]
    fn is_beyond(&self, reach: &Reach<N>, slack: N::Length) -> Option<bool> {
        self.as_face(|vectors, edges| reach.excludes_face(vectors, edges, slack))
    }

    /// The same, given the greatest magnitude of all.
    #[inline(always)]
    fn is_beyond_by(&self, reach: &Reach<N>, [size, slack]: [N::Length; 2]) -> Option<bool> {
        let errors = Errors::<N>::new(size, reach.radius)?;
        self.as_face(|vectors, edges| {
            if slack == N::Length::ZERO && reach.is_beyond(vectors) {
                return Some(true);
            }
            reach.excludes_near_face(vectors, edges, slack, &errors)
        })
    }

    /// The vectors from its vertices to the origin, and its edges.
    #[inline(always)]
    fn as_face<T>(&self, f: impl FnOnce(&[Vector<N>; 4], &[Vector<N>; 4]) -> T) -> T {
        let ([[ac, ad], [bc, bd]], [d, e]) = (self.ends, self.along);
        let back = |v: &Vector<N>| three(|i| -v[i]);
        // A vector to the origin from a vertex of the parallelogram is minus that vertex, a − c.
        f(&[ac, bc, bd, ad], &[d, back(&e), back(&d), e])
    }
}

/// Whether all parts lie beyond: `None` if some are in doubt, and none is known to be near.
#[inline(always)]
fn all_beyond(parts: impl Iterator<Item = Option<bool>>) -> Option<bool> {
    let mut is_known = true;
    for part in parts {
        match part {
            Some(false) => return Some(false),
            Some(true) => {}
            None => is_known = false,
        }
    }
    is_known.then_some(true)
}

/// The question about two segments, with a second radius.
struct Apart<'a, S> {
    capsule: &'a Capsule<S>,
    segment: &'a Segment<S>,
    radius: S,
    ball: Ball,
}

impl<S: Scalar> Predicate<S> for Apart<'_, S> {
    type Answer = bool;

    #[inline]
    fn filter<N: Embeds<S>>(&self) -> Option<bool> {
        let (c, d, is_by_center) = self.segment.numbers();
        let (a, b) = self.capsule.ends();
        let radii = [self.capsule.radius(), self.radius, S::ZERO];
        let all = [a.to_array(), b.to_array(), c, d, radii];
        let [a, b, c, d, [r, s, _]] = N::embed(&all)?;
        let (reach, e) = (Reach::<N>::new(r + s, self.ball), from::<N>(&b, &a));
        let to_c = [from::<N>(&c, &a), from::<N>(&c, &b)];
        if is_by_center {
            let ends = |v: &Vector<N>| [from::<N>(v, &d), three(|i| v[i] + d[i])];
            let ends = [ends(&to_c[0]), ends(&to_c[1])];
            let slack = greatest(largest(&d), greatest(largest(&to_c[0]), largest(&to_c[1])));
            Between { ends, along: [e, three(|i| d[i] + d[i])] }.is_beyond(&reach, slack)
        } else {
            let ends = [[to_c[0], from::<N>(&d, &a)], [to_c[1], from::<N>(&d, &b)]];
            Between { ends, along: [e, from::<N>(&d, &c)] }.is_beyond(&reach, N::Length::ZERO)
        }
    }
}

impl<S: Scalar> Numeric<S> for Apart<'_, S> {}

impl<S: Scalar> Predicate<S> for Beyond<'_, Capsule<S>, Sphere<S>> {
    type Answer = bool;
    const PROFILE: Profile = Profile::AREAS;

    #[inline]
    fn filter<N: Embeds<S>>(&self) -> Option<bool> {
        let Self { round: capsule, shape: sphere, ball } = *self;
        let radii = [capsule.radius(), sphere.radius(), S::ZERO];
        let center = sphere.center().to_array();
        lies_beyond::<S, N>(center, radii, &capsule.segment(), ball, |[r, s, _]| r + s)
    }
}

// Whether each shape meets the capsule, or its points nearer than the radius.

#[inline(always)]
fn meets_segment<S: Scalar>(
    capsule: &Capsule<S>,
    segment: &Segment<S>,
    radius: S,
    ball: Ball,
) -> bool {
    !S::evaluate_numeric(&Apart { capsule, segment, radius, ball })
}

#[inline(always)]
fn meets_box<'a, S: Scalar, T>(capsule: &'a Capsule<S>, shape: &'a T, ball: Ball) -> bool
where
    Beyond<'a, Capsule<S>, T>: Predicate<S, Answer = bool>,
    Segment<S>: Overlaps<T>,
{
    meet(capsule, shape, ball) || capsule.segment().overlaps(shape)
}

impl<S: Scalar> Overlaps<Segment<S>> for Capsule<S> {
    /// Do a capsule and a segment have a point in common?
    ///
    /// *Geometry*: closed sets, the segment in the form in which it was given. The radius may be
    /// zero, the ends of each may coincide.
    ///
    /// *Contact*, *Numerics* and *Range*: as for a
    /// [triangle](Capsule#impl-Overlaps<Triangle<S>>-for-Capsule<S>).
    ///
    /// *Panics*: never. *Cost*: 12 comparisons if a coordinate separates, 14 multiplications if a
    /// plane does; otherwise 49, and 19 more for each of up to four edges.
    ///
    /// ```
    /// use septum::{Capsule, Segment};
    ///
    /// let s = Segment::new([-1.0_f64, 0.0, 0.0], [1.0, 0.0, 0.0])?;
    /// let across = Capsule::new([0.0, -1.0, 2.0], [0.0, 1.0, 2.0], 2.0)?;
    /// assert!(across.overlaps(&s)); // touches between all ends
    /// assert!(!Capsule::new([0.0, -1.0, 2.0], [0.0, 1.0, 2.000_000_1], 2.0)?.overlaps(&s));
    /// # Ok::<(), septum::ShapeError>(())
    /// ```
    #[inline]
    fn overlaps(&self, segment: &Segment<S>) -> bool {
        meets_segment(self, segment, S::ZERO, Ball::Closed)
    }
}

impl<S: Scalar> Overlaps<Self> for Capsule<S> {
    /// Do two capsules have a point in common?
    ///
    /// *Contact*, *Numerics*, *Range*, *Panics* and *Cost*: as for a
    /// [segment](Capsule#impl-Overlaps<Segment<S>>-for-Capsule<S>). The sum of the radii is exact.
    ///
    /// ```
    /// use septum::Capsule;
    ///
    /// let first = Capsule::new([-1.0_f32, 0.0, 0.0], [1.0, 0.0, 0.0], 2.0)?;
    /// let across = Capsule::new([0.0, -4.0, 3.0], [0.0, 4.0, 3.0], 1.0)?;
    /// assert!(first.overlaps(&across)); // touching is overlap
    /// let thinner = Capsule::new([0.0, -4.0, 3.0], [0.0, 4.0, 3.0], 0.999_999_94)?;
    /// assert!(!first.overlaps(&thinner));
    /// # Ok::<(), septum::ShapeError>(())
    /// ```
    #[inline]
    fn overlaps(&self, other: &Self) -> bool {
        meets_segment(self, &other.segment(), other.radius(), Ball::Closed)
    }
}

impl<S: Scalar> Overlaps<Sphere<S>> for Capsule<S> {
    /// Do a capsule and a sphere have a point in common?
    ///
    /// *Contact*, *Numerics*, *Range*, *Panics* and *Cost*: as for a
    /// [sphere and a segment](Sphere#impl-Overlaps<Segment<S>>-for-Sphere<S>). The sum of the radii
    /// is exact.
    ///
    /// ```
    /// use septum::{Capsule, Sphere};
    ///
    /// let capsule = Capsule::new([0.0_f64, 0.0, 0.0], [4.0, 3.0, 0.0], 2.0)?;
    /// assert!(capsule.overlaps(&Sphere::new([-1.0, 5.5, 0.0], 3.0)?)); // touches
    /// # Ok::<(), septum::ShapeError>(())
    /// ```
    #[inline]
    fn overlaps(&self, sphere: &Sphere<S>) -> bool {
        meet(self, sphere, Ball::Closed)
    }
}

impl<S: Scalar> Overlaps<Plane<S>> for Capsule<S> {
    /// Do a capsule and a plane have a point in common?
    ///
    /// *Contact*, *Numerics*, *Range* and *Panics*: as for a
    /// [sphere](Sphere#impl-Overlaps<Plane<S>>-for-Sphere<S>). *Cost*: 11 multiplications, or 15.
    ///
    /// ```
    /// use septum::{Capsule, Plane};
    ///
    /// let ground = Plane::from_point_normal([0.0_f32; 3], [0.0, 0.0, 9.0])?;
    /// assert!(Capsule::new([0.0, 0.0, -9.0], [0.0, 0.0, 9.0], 1.0)?.overlaps(&ground));
    /// assert!(!Capsule::new([0.0, 0.0, 1.000_000_1], [0.0, 0.0, 9.0], 1.0)?.overlaps(&ground));
    /// # Ok::<(), septum::ShapeError>(())
    /// ```
    #[inline]
    fn overlaps(&self, plane: &Plane<S>) -> bool {
        meets_plane(self.ends().into(), self.radius(), plane, Ball::Closed)
    }
}

impl<S: Scalar> Capsule<S> {
    /// Does the capsule contain a point: is that within the radius of the segment?
    ///
    /// *Geometry*: a closed set. No capsule contains a point with a NaN or infinite coordinate.
    ///
    /// *Contact*: a point on the surface is in the capsule.
    ///
    /// *Numerics*: exact for every valid input, in every scalar. *Panics*: never. *Cost*: as for a
    /// [sphere and a segment](Sphere#impl-Overlaps<Segment<S>>-for-Sphere<S>).
    ///
    /// ```
    /// use septum::Capsule;
    ///
    /// let capsule = Capsule::new([0.0_f32, 0.0, 0.0], [4.0, 3.0, 0.0], 5.0)?;
    /// assert!(capsule.contains([-1.0, 5.5, 0.0]));
    /// assert!(!capsule.contains([-1.0, 5.5, 0.001]));
    /// # Ok::<(), septum::ShapeError>(())
    /// ```
    #[inline]
    #[must_use]
    pub fn contains(&self, point: impl Into<Vec3<S>>) -> bool {
        // A sphere of radius zero.
        Sphere::new(point, S::ZERO).is_ok_and(|point| self.overlaps(&point))
    }
}
