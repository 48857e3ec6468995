//! Segment against triangle.

use super::Overlaps;
use super::orientation::{Vector, error_bound, from, in_doubt, sides, size};
use super::relation::{Asked, Relate, Relation};
use crate::arithmetic::{Arithmetic, Embeds, cross, dot, three};
use crate::robust::{Predicate, certain_sign};
use crate::scalar::Scalar;
use crate::shape::{Segment, Triangle};

/// The question for the relation of segment and triangle.
struct Lie<'a, S> {
    segment: &'a Segment<S>,
    triangle: &'a Triangle<S>,
    asked: Asked,
}

/// A segment and a triangle as the vectors between them.
struct Setting<N: Arithmetic> {
    /// From the first vertex to both ends.
    ends: [Vector<N>; 2],
    /// From one end to all vertices.
    vertices: [Vector<N>; 3],
    /// From the first end to the second.
    d: Vector<N>,
    /// The greatest magnitude among the components of these vectors.
    size: N::Length,
}

impl<N: Arithmetic> Setting<N> {
    #[inline(always)]
    fn by_ends([a, b]: [&Vector<N>; 2], [p, q, r]: &[Vector<N>; 3]) -> Self {
        let ends = [from::<N>(a, p), from::<N>(b, p)];
        let vertices = [from::<N>(p, a), from::<N>(q, a), from::<N>(r, a)];
        let d = from::<N>(b, a);
        let [x, y] = ends;
        let [_, z, w] = vertices;
        Self { ends, vertices, d, size: size::<N, 5>(&[x, y, z, w, d]) }
    }

    #[inline(always)]
    fn by_center([c, h]: [&Vector<N>; 2], triangle: &[Vector<N>; 3]) -> Self {
        let [p, q, r] = three(|k| from::<N>(&triangle[k], c));
        // No sum, and no operand of a sum, is greater.
        let size = size::<N, 3>(&[p, q, r]) + (size::<N, 1>(&[*h]) + size::<N, 1>(&[*h]));
        let plus = |v: &Vector<N>| [v[0] + h[0], v[1] + h[1], v[2] + h[2]];
        let to_center = from::<N>(c, &triangle[0]);
        let ends = [from::<N>(&to_center, h), plus(&to_center)];
        Self { ends, vertices: [plus(&p), plus(&q), plus(&r)], d: plus(h), size }
    }

    /// The relation, unless a sign is in doubt or both shapes lie in one plane.
    #[inline(always)]
    fn relation(&self, [p, q, r]: &[Vector<N>; 3]) -> Option<Relation> {
        let Self { ends, vertices: [u, v, w], d, size } = self;
        let (e, f) = (from::<N>(q, p), from::<N>(r, p));
        let [a, b] = sides::<N, 2>([&e, &f], ends, *size)?;
        if a != 0 && a == b {
            return Some(Relation::Disjoint);
        }
        let error = error_bound::<N>([*size; 3])?;
        // The signs of the three volumes say on which side the line passes each edge.
        let [dv, dw] = [cross::<N>(d, v), cross::<N>(d, w)];
        let passes = [
            certain_sign(-dot::<N>(&dv, u), error),
            certain_sign(dot::<N>(&dv, w), error),
            certain_sign(dot::<N>(&dw, u), error),
        ];
        if passes.contains(&1) && passes.contains(&-1) {
            return Some(Relation::Disjoint);
        }
        let is_clear = a != 0 && b != 0 && !passes.contains(&0);
        if is_clear {
            Some(Relation::Overlapping)
        } else if N::CERTAIN && (a != 0 || b != 0) {
            Some(Relation::Touching)
        } else {
            None
        }
    }
}

impl<S: Scalar> Predicate<S> for Lie<'_, S> {
    type Answer = Relation;

    #[inline]
    fn filter<N: Embeds<S>>(&self) -> Option<Relation> {
        let (a, b, is_by_center) = self.segment.numbers();
        let [p, q, r] = self.triangle.points();
        let [a, b, p, q, r] = N::embed(&[a, b, p, q, r])?;
        let triangle = [p, q, r];
        let setting = if is_by_center {
            Setting::<N>::by_center([&a, &b], &triangle)
        } else {
            Setting::<N>::by_ends([&a, &b], &triangle)
        };
        let settled = setting.relation(&triangle);
        if settled.is_some() {
            return settled;
        }
        // In floats these ends are rounded.
        if is_by_center && !N::CERTAIN {
            return None;
        }
        let [a, b] = if is_by_center {
            [from::<N>(&a, &b), [a[0] + b[0], a[1] + b[1], a[2] + b[2]]]
        } else {
            [a, b]
        };
        in_doubt::<N>(&[a, b, b], &triangle, self.asked)
    }
}

/// The question whether a segment meets a triangle whose edges it does not meet and which contains
/// neither of its ends: it passes through the interior, and does not lie in the plane.
pub(super) struct Passes<'a, S> {
    pub(super) ends: [[S; 3]; 2],
    pub(super) triangle: &'a Triangle<S>,
}

impl<S: Scalar> Predicate<S> for Passes<'_, S> {
    type Answer = bool;

    #[inline]
    fn filter<N: Embeds<S>>(&self) -> Option<bool> {
        let ([a, b], [p, q, r]) = (self.ends, self.triangle.points());
        let [a, b, p, q, r] = N::embed(&[a, b, p, q, r])?;
        let triangle = [p, q, r];
        let settled = match Setting::<N>::by_ends([&a, &b], &triangle).relation(&triangle) {
            None if N::CERTAIN => Some(Relation::Disjoint),
            None => in_doubt::<N>(&[a, b, b], &triangle, Asked::Overlaps),
            settled => settled,
        };
        settled.map(|relation| relation != Relation::Disjoint)
    }
}

impl<S: Scalar> Overlaps<Triangle<S>> for Segment<S> {
    /// Do a segment and a triangle have a point in common?
    ///
    /// *Geometry*: closed sets in one frame and unit, the segment in the form in which it was
    /// given: ends or centre and half-vector. The segment may be a point, the triangle a segment or
    /// a point.
    ///
    /// *Contact*: touching is overlap. A segment in the plane of a triangle overlaps it if it meets
    /// an edge or lies inside. [`Ray::hit`](crate::Ray::hit) differs: a ray in the plane has no
    /// hit, because a hit needs a single t.
    ///
    /// *Numerics*: exact for every valid input, in every scalar.
    ///
    /// *Range*: as for [two triangles](Triangle#impl-Overlaps<Triangle<S>>-for-Triangle<S>).
    ///
    /// *Panics*: never. *Cost*: 33 multiplications, or 12 if the segment lies on one side of the
    /// triangle's plane.
    ///
    /// *Source*: the signs are by O. Devillers and P. Guigue, INRIA RR-4488, 2002; the exact stages
    /// are ours.
    ///
    /// ```
    /// use septum::{Segment, Triangle};
    ///
    /// let floor = Triangle::new([0.0, 0.0, 0.0], [4.0, 0.0, 0.0], [0.0, 4.0, 0.0])?;
    /// let lift = Segment::new([2.0, 2.0, -1.0], [2.0, 2.0, 1.0])?;
    /// assert!(lift.overlaps(&floor)); // through the long edge
    /// let along = Segment::new([-1.0, 2.0, 0.0], [9.0, 2.0, 0.0])?;
    /// assert!(along.overlaps(&floor)); // in its plane
    /// # Ok::<(), septum::ShapeError>(())
    /// ```
    #[inline]
    fn overlaps(&self, triangle: &Triangle<S>) -> bool {
        let question = Lie { segment: self, triangle, asked: Asked::Overlaps };
        S::evaluate(&question) != Relation::Disjoint
    }

    /// May a segment and a triangle have a point in common?
    ///
    /// *Numerics*: `false` is certain. Fixed point is exact, except that 64 bits return `true`
    /// beyond 2⁶⁰ units in the last place. Floats return `true` within a few roundings of contact,
    /// and outside the range of the first stage of [`overlaps`](Overlaps::overlaps).
    ///
    /// *Panics*: never. *Cost*: bounded. In floats it is the first stage of
    /// [`overlaps`](Overlaps::overlaps); in fixed point of up to 32 bits it is
    /// [`overlaps`](Overlaps::overlaps) itself.
    #[inline]
    fn may_overlap(&self, triangle: &Triangle<S>) -> bool {
        let question = Lie { segment: self, triangle, asked: Asked::MayOverlap };
        S::evaluate_bounded(&question) != Some(Relation::Disjoint)
    }
}

impl<S: Scalar> Relate<Triangle<S>> for Segment<S> {
    fn relation(&self, triangle: &Triangle<S>) -> Relation {
        S::evaluate(&Lie { segment: self, triangle, asked: Asked::Relation })
    }
}
