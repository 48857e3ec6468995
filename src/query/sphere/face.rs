//! Sphere against triangle: whether a triangle or a parallelogram lies farther from a point than a
//! radius.

use super::error_bound::{Errors, PRODUCT};
use super::kernel::{Ball, Reach, along, around, largest_of, minors, squared, volume};
use super::{Beyond, meet};
#[cfg(feature = "fixed")]
use crate::arithmetic::Int16;
use crate::arithmetic::{Arithmetic, Embeds, Number, greatest, largest, part};
use crate::query::Overlaps;
use crate::query::orientation::Vector;
use crate::query::triangle_obb::lie_along_one_axis;
use crate::robust::{Predicate, Uncertain};
use crate::scalar::Scalar;
#[cfg(feature = "fixed")]
use crate::shape::Near;
use crate::shape::{Sphere, Triangle};

/// Whether a point lies outside of an edge or over it, with the normal of the face, and the cross
/// product of the edge and the vector to the point.
#[inline(always)]
fn lies_outside<N: Arithmetic>(
    n: &[N::Area; 3],
    c: &[N::Area; 3],
    errors: &Errors<N>,
) -> Uncertain {
    match N::short_sign(n, c) {
        Some(side) => Uncertain::known(side.is_le()),
        None => Uncertain::not_below(-along::<N>(n, c), errors.side),
    }
}

/// Roundoffs of the square of the longer edge, up to which the normal of a thin face is long.
const THIN: u16 = 60_000;

impl<N: Arithmetic> Reach<N> {
    /// Whether a triangle or a parallelogram lies beyond, with vectors from its vertices to the
    /// point, and edges in the same order; `None` in doubt. The vectors err as `excludes` says.
    #[inline(always)]
    pub(in crate::query) fn excludes_face<const K: usize>(
        &self,
        vectors: &[Vector<N>; K],
        edges: &[Vector<N>; K],
        slack: N::Length,
    ) -> Option<bool> {
        if slack == N::Length::ZERO && self.is_beyond(vectors) {
            return Some(true);
        }
        let size = greatest(largest_of::<N, K>(vectors), largest_of::<N, K>(edges));
        let size = greatest(size, slack);
        if N::is_narrow(greatest(size, self.radius)) {
            let errors = Errors::<N::Narrow>::new(size, self.radius)?;
            self.narrow().excludes_near_face(vectors, edges, slack, &errors)
        } else {
            self.excludes_near_face(vectors, edges, slack, &Errors::new(size, self.radius)?)
        }
    }

    /// The same reach, in narrow volumes.
    #[inline(always)]
    pub(in crate::query) fn narrow(&self) -> Reach<N::Narrow> {
        Reach { radius: self.radius, square: self.square, ball: self.ball }
    }

    /// As [`excludes_face`](Self::excludes_face), for sizes that the errors cover.
    #[inline(always)]
    pub(in crate::query) fn excludes_near_face<const K: usize>(
        &self,
        vectors: &[Vector<N>; K],
        edges: &[Vector<N>; K],
        slack: N::Length,
        errors: &Errors<N>,
    ) -> Option<bool> {
        let n = minors::<N>(&edges[0], &edges[1]);
        let [by_plane] = self.excludes_planes(&n, [volume::<N>(&n, &vectors[0])], errors);
        if by_plane.certain {
            return Some(true);
        }
        self.excludes_point_near(&n, by_plane, vectors, edges, slack, errors).0
    }

    /// The same, if the plane does not answer; and a bit for each edge that the point is certainly
    /// inside of. These are all such edges unless the answer is `Some(false)`.
    #[inline(always)]
    pub(in crate::query) fn excludes_point_near<const K: usize>(
        &self,
        n: &[N::Area; 3],
        by_plane: Uncertain,
        vectors: &[Vector<N>; K],
        edges: &[Vector<N>; K],
        slack: N::Length,
        errors: &Errors<N>,
    ) -> (Option<bool>, u8) {
        let (mut is_outside, mut by_edges) = (Uncertain::NONE, Uncertain::known(true));
        let mut inside_of = 0;
        for k in 0..K {
            let (d, e) = (&vectors[k], &edges[k]);
            let c = minors::<N>(e, d);
            let is_out = lies_outside::<N>(n, &c, errors);
            inside_of |= u8::from(!is_out.possible) << k;
            if is_out.possible {
                let ends = [d, &vectors[(k + 1) % K]];
                let by_edge = self.excludes_edge(ends, e, &c, slack, errors);
                if !by_edge.possible {
                    return (Some(false), inside_of);
                }
                (is_outside, by_edges) = (is_outside.or(is_out), by_edges.and(by_edge));
            }
        }
        let verdict = by_plane.or(is_outside).and(by_edges).verdict();
        let is_in_doubt = verdict.is_none() && by_edges.certain;
        if !N::CERTAIN && is_in_doubt && self.excludes_thin_face(n, vectors, edges, slack, errors) {
            return (Some(true), inside_of);
        }
        (verdict, inside_of)
    }

    /// Whether a face with little or no area certainly lies beyond, if its edges do: as of segments that are nearly
    /// parallel.
    ///
    /// No point of a convex face is farther from its outline than half of its width, the length of the normal by
    /// that of an edge. Its three components are at most [`THIN`] roundoffs of the square of the greatest
    /// component of an edge. So half of the width is at most √3/2 of as many roundoffs of that component, and
    /// the same number of roundoffs of it and of the radius leaves room for rounding, as `face.g` proves. The
    /// error of the normal is a part of the bound, so the edge is at least 1/256 of the greatest length, and in range.
    #[cold]
    #[inline(never)]
    fn excludes_thin_face<const K: usize>(
        &self,
        n: &[N::Area; 3],
        vectors: &[Vector<N>; K],
        edges: &[Vector<N>; K],
        slack: N::Length,
        errors: &Errors<N>,
    ) -> bool {
        // Edges that are products may have lost numbers to underflow: it is then thinner than any error.
        if lie_along_one_axis(&edges[0], &edges[1]) {
            return true;
        }
        let edge = greatest(largest(&edges[0]), largest(&edges[1]));
        let most = N::area(edge, edge).error(THIN);
        if !n.iter().all(|x| x.magnitude() + errors.minor <= most) {
            return false;
        }
        let wider = Self::new(self.radius + (edge + self.radius).error(THIN), self.ball);
        wider.square.in_range()
            && (0..K).all(|k| {
                let (d, e) = (&vectors[k], &edges[k]);
                let c = minors::<N>(e, d);
                wider.excludes_edge([d, &vectors[(k + 1) % K]], e, &c, slack, errors).certain
            })
    }

    /// Whether a plane with normal `n` lies beyond, for each of these n·d.
    #[inline(always)]
    pub(in crate::query) fn excludes_planes<const K: usize>(
        &self,
        n: &[N::Area; 3],
        volumes: [N::Volume; K],
        errors: &Errors<N>,
    ) -> [Uncertain; K] {
        let normal = squared::<N>(n, errors.minor);
        let near = part(|| N::sextic_of_areas(normal.value, self.square));
        let mut are_beyond = [Uncertain::NONE; K];
        for (volume, is_beyond) in volumes.into_iter().zip(&mut are_beyond) {
            let far = part(|| N::sextic(volume, volume));
            *is_beyond = if N::CERTAIN {
                // A normal of zero excludes nothing.
                let by_plane = self.ball.excludes(far - near, N::Sextic::ZERO);
                by_plane.and(Uncertain::known(normal.value > N::Quartic::ZERO))
            } else {
                let most = volume.magnitude() + volume.magnitude() + errors.volume;
                let error = N::sextic(errors.volume, most)
                    + N::sextic_of_areas(normal.error, self.square)
                    + (far + near).error(PRODUCT);
                self.ball.excludes(far - near, error)
            };
        }
        are_beyond
    }
}

impl<S: Scalar> Predicate<S> for Beyond<'_, Sphere<S>, Triangle<S>> {
    type Answer = bool;

    #[inline]
    fn filter<N: Embeds<S>>(&self) -> Option<bool> {
        let [a, b, c] = self.shape.points();
        let [center, [r, ..], a, b, c] = N::embed(&[self.center(), self.radius(), a, b, c])?;
        let [vectors, edges] = around::<N>(&center, &[a, b, c]);
        Reach::<N>::new(r, self.ball).excludes_face(&vectors, &edges, N::Length::ZERO)
    }
}

impl<S: Scalar> Overlaps<Triangle<S>> for Sphere<S> {
    /// Do a sphere and a triangle have a point in common?
    ///
    /// *Geometry*: closed sets in one frame and unit. The radius may be zero, the triangle a segment
    /// or a point.
    ///
    /// *Contact*: touching is overlap.
    ///
    /// *Numerics*: exact for every valid input, in every scalar. A squared distance is compared with
    /// the square of the radius, in products of up to six lengths.
    ///
    /// *Range*: all finite floats, all fixed-point values; 64-bit fixed point beyond 2⁶⁰ units in
    /// the last place takes wider integers. In floats, distances within rounding of the radius take
    /// exact integers.
    ///
    /// *Panics*: never. *Cost*: 9 comparisons if a coordinate separates; 14 multiplications if the
    /// plane does; 41 over the face, and 19 more for each edge that the centre lies outside of.
    ///
    /// ```
    /// use septum::{Sphere, Triangle};
    ///
    /// let t = Triangle::new([0.0_f32, 0.0, 0.0], [4.0, 0.0, 0.0], [0.0, 4.0, 0.0])?;
    /// let over_face = Sphere::new([1.0, 1.0, 2.0], 2.0)?;
    /// assert!(over_face.overlaps(&t)); // touches
    /// let past_edge = Sphere::new([5.0, 5.0, 0.0], 4.2426405)?;
    /// assert!(!past_edge.overlaps(&t)); // the radius is just below √18
    /// let past_edge = Sphere::new([5.0, 5.0, 0.0], 4.242641)?;
    /// assert!(past_edge.overlaps(&t));
    /// # Ok::<(), septum::ShapeError>(())
    /// ```
    #[inline]
    fn overlaps(&self, triangle: &Triangle<S>) -> bool {
        meet(self, triangle, Ball::Closed)
    }
}

#[cfg(feature = "fixed")]
impl<S: Scalar> Overlaps<Near<Sphere<S>>> for Near<Triangle<S>>
where
    Int16: Embeds<S>,
{
    /// Do a triangle and a sphere near the origin have a point in common?
    ///
    /// *Numerics*: exact, in integers of up to 128 bits. *Panics*: never.
    #[inline]
    fn overlaps(&self, sphere: &Near<Sphere<S>>) -> bool {
        let (sphere, shape) = (sphere.get(), self.get());
        Beyond { round: sphere, shape, ball: Ball::Closed }.filter::<Int16>() != Some(true)
    }
}
