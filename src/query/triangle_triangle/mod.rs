//! Triangle against triangle.
//!
//! O. Devillers, P. Guigue, "Faster Triangle-Triangle Intersection Tests", INRIA RR-4488, 2002. At
//! most eight signs of volumes decide.

mod kernel;
mod segment;

use self::kernel::{clear_sides, crossing, is_beyond};
use super::Overlaps;
use super::orientation::in_doubt;
use super::relation::{Asked, Relate, Relation};
use crate::arithmetic::Embeds;
use crate::robust::Predicate;
use crate::scalar::Scalar;
use crate::shape::Triangle;

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
        let [first, second] = self.points::<N>()?;
        match clear_sides::<N>(&first, &second) {
            Err(Some(relation)) => Some(relation),
            sides => self.across_plane::<N>(sides.ok()),
        }
    }
}

impl<S: Scalar> Lie<'_, S> {
    #[inline(always)]
    fn points<N: Embeds<S>>(&self) -> Option<[[[N::Length; 3]; 3]; 2]> {
        let ([a, b, c], [d, e, f]) = (self.first.points(), self.second.points());
        let [a, b, c, d, e, f] = N::embed(&[a, b, c, d, e, f])?;
        Some([[a, b, c], [d, e, f]])
    }

    /// The answer for a first triangle that is not beyond the plane of the second, with the signs
    /// of its vertices if they are clear. Out of line: the first plane settles half of all pairs,
    /// and then needs no point in memory.
    #[inline(never)]
    fn across_plane<N: Embeds<S>>(&self, sides: Option<[i8; 3]>) -> Option<Relation> {
        let [first, second] = self.points::<N>()?;
        let settled = sides.and_then(|sides| crossing::<N>(&first, &second, sides));
        if settled.is_some() {
            return settled;
        }
        // In floats, most doubts are shared vertices, or triangles side by side in one plane.
        in_doubt::<N>(&first, &second, self.asked)
            .or_else(|| is_beyond::<N>(&second, &first).then_some(Relation::Disjoint))
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
