//! Triangle against triangle.
//!
//! O. Devillers, P. Guigue, "Faster Triangle-Triangle Intersection Tests", INRIA RR-4488, 2002. At
//! most eight signs of volumes decide, and name the ends of the segment in which the triangles cross.

mod kernel;

use super::Overlaps;
use super::orientation::in_doubt;
use super::relation::{Asked, Relate, Relation};
use crate::arithmetic::{Each, Embeds, pick, three};
use crate::robust::{ExactSum, Predicate, add_minor, differences};
use crate::scalar::Scalar;
use crate::shape::{Segment, Triangle, Vec3};
use kernel::{Ends, clear_sides, crossing, ends, is_beyond};

/// The question for the relation of two triangles.
struct Lie<'a, S> {
    first: &'a Triangle<S>,
    second: &'a Triangle<S>,
    asked: Asked,
}

impl<S: Scalar> Predicate<S> for Lie<'_, S> {
    type Answer = Relation;

    #[inline]
    fn filter<N: Embeds<S>>(&self) -> Option<Relation> {
        let points = self.points::<N>()?;
        let (first, second) = (points.first_chunk()?, points.last_chunk()?);
        match clear_sides::<N>(first, second) {
            Err(Some(relation)) => Some(relation),
            sides => self.across_plane::<N>(sides.ok()),
        }
    }
}

impl<S: Scalar> Lie<'_, S> {
    #[inline(always)]
    fn points<N: Embeds<S>>(&self) -> Option<[[N::Length; 3]; 6]> {
        let ([a, b, c], [d, e, f]) = (self.first.points(), self.second.points());
        N::embed(&[a, b, c, d, e, f])
    }

    /// The answer for a first triangle that is not beyond the plane of the second, with the signs
    /// of its vertices if they are clear. Out of line: the first plane settles half of all pairs,
    /// and then needs no point in memory.
    #[inline(never)]
    fn across_plane<N: Embeds<S>>(&self, sides: Option<[i8; 3]>) -> Option<Relation> {
        let points = self.points::<N>()?;
        let (first, second) = (points.first_chunk()?, points.last_chunk()?);
        let settled = sides.and_then(|sides| crossing::<N>(first, second, sides));
        if settled.is_some() {
            return settled;
        }
        // In floats, most doubts are shared vertices, or triangles side by side in one plane.
        let found = in_doubt::<N>(first, second, self.asked);
        // There is an answer.
        if N::CERTAIN {
            return found;
        }
        found.or_else(|| is_beyond::<N>(second, first).then_some(Relation::Disjoint))
    }
}

impl<S: Scalar> Overlaps<Triangle<S>> for Triangle<S> {
    /// Do two triangles have a point in common?
    ///
    /// *Geometry*: closed sets in one frame and unit. Either may be a segment or a point.
    ///
    /// *Contact*: touching is overlap. Triangles that share a vertex or part of an edge overlap,
    /// and so does a triangle that lies within its partner, in one plane too.
    ///
    /// *Numerics*: exact for every valid input, in every scalar. Either order of the
    /// triangles and of their vertices gives the same answer.
    ///
    /// *Range*: all finite floats, all fixed-point values. The fast stage decides floats with spans
    /// between 2⁻³² and 2⁴⁰ (`f32`) or 2⁻³²⁰ and 2³²⁰ (`f64`), and fixed point below 2²⁸ (32 bits)
    /// or 2⁶⁰ (64 bits) units in the last place; with 8 and 16 bits it always decides. Other
    /// inputs, and floats within rounding of contact, take wider numbers and last exact integers,
    /// up to a thousand times slower.
    ///
    /// *Panics*: never. *Cost*: 48 multiplications, or 15 or 30 if a triangle lies on one side of
    /// the other's plane.
    ///
    /// *Source*: O. Devillers, P. Guigue, INRIA RR-4488, 2002. The error bound, the exact stages,
    /// and the treatment of segments, points and triangles in one plane are ours.
    ///
    /// ```
    /// use septum::Triangle;
    ///
    /// let floor = Triangle::new([0.0, 0.0, 0.0], [4.0, 0.0, 0.0], [0.0, 4.0, 0.0])?;
    /// let spike = Triangle::new([2.0, 2.0, 0.0], [2.0, 3.0, 1.0], [3.0, 2.0, 1.0])?;
    /// assert!(floor.overlaps(&spike)); // its tip is on the long edge
    /// let off = Triangle::new([2.0, 2.0000000000000004, 0.0], [2.0, 3.0, 1.0], [3.0, 2.0, 1.0])?;
    /// assert!(!floor.overlaps(&off)); // one unit in the last place farther out
    /// # Ok::<(), septum::ShapeError>(())
    /// ```
    #[inline]
    fn overlaps(&self, other: &Triangle<S>) -> bool {
        let question = Lie { first: self, second: other, asked: Asked::Overlaps };
        S::evaluate(&question) != Relation::Disjoint
    }

    /// May two triangles have a point in common?
    ///
    /// *Numerics*: `false` is certain. Fixed point is exact, except that 64 bits return `true`
    /// beyond 2⁶⁰ units in the last place. Floats return `true` within a few roundings of contact,
    /// and outside the range of the first stage of [`overlaps`](Overlaps::overlaps).
    ///
    /// *Panics*: never. *Cost*: bounded. In floats it is the first stage of
    /// [`overlaps`](Overlaps::overlaps); in fixed point of up to 32 bits it is
    /// [`overlaps`](Overlaps::overlaps) itself.
    #[inline]
    fn may_overlap(&self, other: &Triangle<S>) -> bool {
        let question = Lie { first: self, second: other, asked: Asked::MayOverlap };
        S::evaluate_bounded(&question) != Some(Relation::Disjoint)
    }
}

impl<S: Scalar> Relate<Triangle<S>> for Triangle<S> {
    fn relation(&self, other: &Triangle<S>) -> Relation {
        S::evaluate(&Lie { first: self, second: other, asked: Asked::Relation })
    }
}

/// The question for the edges on which the segment ends.
struct Cross<'a, S>([&'a Triangle<S>; 2]);

impl<S: Scalar> Predicate<S> for Cross<'_, S> {
    type Answer = Option<Ends>;

    #[inline]
    fn filter<N: Embeds<S>>(&self) -> Option<Option<Ends>> {
        let [[a, b, c], [d, e, f]] = self.0.each(Triangle::points);
        let [a, b, c, d, e, f] = N::embed(&[a, b, c, d, e, f])?;
        ends::<N>(&[a, b, c], &[d, e, f])
    }
}

impl<S: Scalar> Triangle<S> {
    /// The segment in which two triangles cross, or `None` if they do not cross in one.
    ///
    /// *Geometry*: two triangles in different planes have a segment in common, a point or nothing.
    /// The segment is returned, also where it lies on an edge of a triangle. With the normals m of
    /// this triangle and n of `other`, counterclockwise, it runs along m × n; so
    /// `other.crossing(&self)` is the same segment from its end to its beginning.
    ///
    /// *Contact*: `None` for triangles that touch in a single point, for triangles in one plane, and
    /// if either is a segment or a point. [`overlaps`](Self::overlaps) and
    /// [`relation`](crate::relation::Relate::relation) answer for these.
    ///
    /// *Numerics*: whether there is a segment is exact, and so is the choice of the edges on which
    /// it ends. Each end is the crossing of an edge p q and a plane: (h·q − k·p)/(h − k), with the
    /// volumes h of p and k of q over the plane's triangle. Numerators and h − k are exact sums,
    /// and each coordinate is one quotient. In fixed point it is the nearest number, ties to even.
    /// In floats the quotient is cut to at least 62 bits, with an error below 2⁻⁶¹ of it, and then
    /// rounded: it is within 0.51 units in the last place. Below the least normal number it is
    /// rounded twice, and within 0.76 units. An end at a vertex is that vertex. The ends lie in the
    /// bounding boxes of both triangles, and may be equal once rounded.
    ///
    /// An edge that two triangles of a mesh share crosses a plane in one point with the same bits
    /// for both, so the segments of adjacent triangles join without a gap. In fixed point they also
    /// do where an edge crosses an edge; floats may round that point differently from either edge.
    ///
    /// *Range*: all finite floats, all fixed-point values. *Panics*: never.
    ///
    /// *Cost*: 6 multiplications more than [`overlaps`](Self::overlaps). If there is a segment,
    /// two normals and four volumes in a long accumulator, and six quotients.
    ///
    /// *Source*: O. Devillers, P. Guigue, INRIA RR-4488, 2002, section 4; the exact stages and the
    /// rounding are ours.
    ///
    /// ```
    /// use septum::{Segment, Triangle};
    ///
    /// let floor = Triangle::new([0.0, 0.0, 0.0], [4.0, 0.0, 0.0], [0.0, 4.0, 0.0])?;
    /// let wall = Triangle::new([1.0, -1.0, -1.0], [1.0, 9.0, -1.0], [1.0, 1.0, 1.0])?;
    /// assert_eq!(floor.crossing(&wall), Some(Segment::new([1.0, 0.0, 0.0], [1.0, 3.0, 0.0])?));
    /// let tip = Triangle::new([1.0, 1.0, 0.0], [1.0, 0.0, 1.0], [1.0, 2.0, 1.0])?;
    /// assert!(floor.overlaps(&tip) && floor.crossing(&tip).is_none()); // it touches in a point
    /// # Ok::<(), septum::ShapeError>(())
    /// ```
    #[doc(alias = "intersection")]
    #[doc(alias = "intersection segment")]
    #[must_use]
    pub fn crossing(&self, other: &Triangle<S>) -> Option<Segment<S>> {
        let triangles = [self, other];
        let [from, to] = S::evaluate(&Cross(triangles))?;
        Some(Segment::unchecked(
            point_of_crossing(triangles, from),
            point_of_crossing(triangles, to),
        ))
    }
}

/// The point in which an edge of either triangle crosses the opposite plane.
#[inline(never)]
fn point_of_crossing<S: Scalar>(
    triangles: [&Triangle<S>; 2],
    (of, ends): (usize, [usize; 2]),
) -> Vec3<S> {
    let [first, second] = triangles.each(Triangle::points);
    let (edges, [base, b, c]) = if of == 0 { (&first, &second) } else { (&second, &first) };
    let (e, f) = (differences(b, base), differences(c, base));
    let normal = three(|i| {
        let mut area = S::SeptumSum::new();
        add_minor(&mut area, &e, &f, i, false);
        area
    });
    let [p, q] = ends.each(|k| {
        let p = *pick(edges, k);
        let mut height = S::SeptumSum::new();
        for ((area, p), base) in normal.iter().zip(p).zip(base) {
            height.add_multiple(area, p.parts());
            height.add_multiple(area, base.parts().negated());
        }
        (p, height)
    });
    // From the lower end to the upper, so that the divisor is above zero.
    let [(p, h), (q, k)] = if p.1 < q.1 { [q, p] } else { [p, q] };
    let mut span = S::SeptumSum::new();
    span.add_multiple(&(h - k), S::ONE);
    let [x, y, z] = three(|i| {
        let mut numerator = S::SeptumSum::new();
        numerator.add_multiple(&h, q[i].parts());
        numerator.add_multiple(&k, p[i].parts().negated());
        S::quotient(&numerator, &span)
    });
    Vec3::new(x, y, z)
}
