//! Sphere against oriented box.
//!
//! The box is the parallelepiped with edges 2·h_i·u_i. In products of a half-extent and an axis it
//! has vertices and edges, and its faces are parallelograms. So the kernel
//! runs in a number system whose lengths are areas of another. The point of a box nearest to a point
//! outside lies on a face beyond whose plane the point is; a point that is beyond none is inside.
//!
//! A box with a half-extent of zero has no inside, and is asked for all faces.

use super::error_bound::Errors;
use super::kernel::{Ball, Reach, largest_of};
use super::{Beyond, meet};
use crate::arithmetic::{
    Arithmetic, Each, Embeds, Number, cross, dot, greatest, least, once, pick, three, turn,
};
use crate::query::Overlaps;
use crate::query::orientation::{Vector, from};
use crate::robust::{Predicate, Profile, Uncertain, certain_sign};
use crate::scalar::Scalar;
use crate::shape::{Obb, Sphere};

/// Roundoffs in a component of the vector from a corner to a point, of the greatest component of d
/// and of the three h_i·u_i: 1 each of these four, and 2, 3 and 4 of the sums. `obb.g` proves
/// both.
const CORNER: u16 = 16;

/// Roundoffs in the gap on a coordinate, of sixteen times that and the radius. To first order less
/// than 2: 1 of the radius, and 17 sixteenths.
const APART: u16 = 2;

/// A parallelepiped, and two points.
pub(in crate::query) struct Corners<M: Arithmetic> {
    /// From the centre to the points.
    pub(in crate::query) d: [Vector<M>; 2],
    /// The halves of the edges.
    half: [Vector<M>; 3],
    /// Vectors from corners err by up to a roundoff of this.
    pub(in crate::query) slack: M::Length,
    pub(in crate::query) errors: Errors<M>,
    /// Whether a half-extent is zero.
    is_flat: bool,
}

/// Corners and a radius, in the number system of areas.
type Held<S, N> = (Corners<<N as Embeds<S>>::OfAreas>, Reach<<N as Embeds<S>>::OfAreas>);

/// An oriented box and two points, and a radius.
#[inline(always)]
pub(in crate::query) fn corners<S: Scalar, N: Embeds<S>>(
    [a, b]: [[S; 3]; 2],
    obb: &Obb<S>,
    radius: S,
    ball: Ball,
) -> Option<Held<S, N>> {
    let [center, u, v, w, half] = obb.numbers();
    let numbers = [radius, S::UNIT_LENGTH, S::ZERO];
    let [a, b, c, u, v, w, h, [r, unit, _]] = N::embed(&[a, b, center, u, v, w, half, numbers])?;
    let times_one = |x: N::Length| N::times_one(x, unit);
    let from_center = |p: &Vector<N>| from::<N>(p, &c).each(times_one);
    let (d, h) = ([from_center(&a), from_center(&b)], h.each(once::<N, _>));
    let along = |h: N::Length, axis: &Vector<N>| three(|i| N::area(h, axis[i]));
    let half = [along(h[0], &u), along(h[1], &v), along(h[2], &w)];
    let mut slack = N::Area::ZERO;
    if !N::CERTAIN {
        slack = greatest(largest_of::<N::OfAreas, 2>(&d), largest_of::<N::OfAreas, 3>(&half));
        // Sixteen times, as `CORNER` says.
        for _ in 0..CORNER.ilog2() {
            slack = slack + slack;
        }
    }
    let is_flat = h.contains(&N::Length::ZERO);
    let reach = Reach::new(times_one(r), ball);
    let errors = Errors::of_corners(slack, reach.radius)?;
    Some((Corners { d, half, slack, errors, is_flat }, reach))
}

impl<M: Arithmetic> Corners<M> {
    /// From a corner to a point; bit k of `at` says on which side of the centre it lies along
    /// edge k.
    #[inline(never)]
    pub(in crate::query) fn way_from_corner(&self, point: usize, at: usize) -> Vector<M> {
        let mut way = if point == 0 { self.d[0] } else { self.d[1] };
        for (k, half) in self.half.iter().enumerate() {
            way = three(|i| if at >> k & 1 == 1 { way[i] - half[i] } else { way[i] + half[i] });
        }
        way
    }

    /// An edge along axis k.
    #[inline(always)]
    pub(in crate::query) fn edge(&self, k: usize) -> Vector<M> {
        pick(&self.half, k).each(|x| x + x)
    }

    /// Whether a coordinate alone keeps the box beyond the reach from both points.
    #[inline(always)]
    pub(in crate::query) fn is_apart(&self, reach: &Reach<M>) -> bool {
        let Self { d: [a, b], half: [u, v, w], slack, .. } = self;
        (0..3).any(|i| {
            let nearer = greatest(least(a[i], b[i]), -greatest(a[i], b[i]));
            let size = u[i].magnitude() + v[i].magnitude() + w[i].magnitude();
            nearer - size - reach.radius > (*slack + reach.radius).error(APART)
        })
    }

    /// Whether a parallelogram lies beyond the reach, with vectors from its vertices to the point, and its
    /// edges; `None` in doubt.
    #[inline(always)]
    pub(in crate::query) fn excludes_face(
        &self,
        reach: &Reach<M>,
        vectors: &[Vector<M>; 4],
        edges: &[Vector<M>; 4],
    ) -> Option<bool> {
        if M::CERTAIN {
            return reach.excludes_face(vectors, edges, self.slack);
        }
        reach.excludes_near_face(vectors, edges, self.slack, &self.errors)
    }

    /// Whether the box lies beyond the reach of a point; `None` in doubt.
    #[inline(never)]
    pub(in crate::query) fn lies_beyond(&self, point: usize, reach: &Reach<M>) -> Option<bool> {
        let edges = three(|k| self.edge(k));
        let error = self.errors.volume;
        let (mut is_outside, mut are_beyond) = (Uncertain::NONE, Uncertain::known(true));
        for i in 0..3 {
            let (i, j, k) = turn(i);
            let (e, f) = (pick(&edges, j), pick(&edges, k));
            let n = cross::<M>(e, f);
            let hand = certain_sign(dot::<M>(&n, pick(&edges, i)), error);
            for side in 0..2 {
                // Around the face.
                let at = |first: usize, second: usize| side << i | first << j | second << k;
                let from = |at: usize| self.way_from_corner(point, at);
                let vectors = [from(at(0, 0)), from(at(1, 0)), from(at(1, 1)), from(at(0, 1))];
                let volume = dot::<M>(&n, &vectors[0]);
                let outward = if (hand > 0) == (side == 1) { volume } else { -volume };
                let is_seen = match hand {
                    _ if self.is_flat => Uncertain::known(true),
                    0 => Uncertain { certain: false, possible: true },
                    _ => Uncertain::above(outward, error),
                };
                if !is_seen.possible {
                    continue;
                }
                let back = |e: &Vector<M>| e.each(|x| -x);
                let around = [*e, *f, back(e), back(f)];
                let found = Uncertain::of(self.excludes_face(reach, &vectors, &around));
                if !found.possible {
                    return Some(false);
                }
                (is_outside, are_beyond) = (is_outside.or(is_seen), are_beyond.and(found));
            }
        }
        is_outside.and(are_beyond).verdict()
    }
}

impl<S: Scalar> Predicate<S> for Beyond<'_, Sphere<S>, Obb<S>> {
    type Answer = bool;
    // The products of an axis would not fit the integers for 18 bits.
    const PROFILE: Profile = Profile::AREAS;

    #[inline]
    fn filter<N: Embeds<S>>(&self) -> Option<bool> {
        let points = [self.center(); 2];
        let (corners, reach) = corners::<S, N>(points, self.shape, self.round.radius(), self.ball)?;
        if corners.is_apart(&reach) { Some(true) } else { corners.lies_beyond(0, &reach) }
    }
}

impl<S: Scalar> Overlaps<Obb<S>> for Sphere<S> {
    /// Do a sphere and an oriented box have a point in common?
    ///
    /// *Geometry*: closed sets, the box namely the parallelepiped that its numbers describe, also if
    /// rounding left its axes slightly short or skewed. The radius may be zero, the box flat.
    ///
    /// *Contact*: touching is overlap.
    ///
    /// *Numerics*: exact for every valid input, in every scalar. A squared distance is compared with
    /// the square of the radius, in products of up to twelve numbers.
    ///
    /// *Range*: all finite floats, all fixed-point values. Integers for the corners are twice as
    /// wide as those of other pairs. In floats they decide distances within rounding of the radius.
    ///
    /// *Panics*: never. *Cost*: 12 multiplications if a coordinate separates. Otherwise a
    /// [parallelogram](Sphere#impl-Overlaps<Triangle<S>>-for-Sphere<S>) for each face that the
    /// centre sees, up to three.
    ///
    /// ```
    /// use septum::{Obb, Sphere};
    ///
    /// let axes = [[0.8, 0.6, 0.0], [-0.6, 0.8, 0.0], [0.0, 0.0, 1.0]];
    /// let tool = Obb::new([10.0, 0.0, 0.0], axes, [2.0, 1.0, 0.5])?;
    /// assert!(Sphere::new([10.0, 0.0, 3.5], 3.0)?.overlaps(&tool)); // touches a face
    /// assert!(!Sphere::new([10.0, 0.0, 3.500_001], 3.0)?.overlaps(&tool));
    /// # Ok::<(), septum::ShapeError>(())
    /// ```
    #[inline]
    fn overlaps(&self, obb: &Obb<S>) -> bool {
        meet(self, obb, Ball::Closed)
    }
}

#[cfg(all(test, feature = "fixed"))]
mod tests {
    use fixed::types::I0F32;

    use crate::arithmetic::Each;
    use crate::shape::{Obb, Sphere};

    /// Numbers of this type are as long as areas allow, and what floats need of them is not computed.
    #[test]
    fn numbers_without_whole_bits_do_not_overflow() {
        let of = |bits: [i32; 3]| bits.each(I0F32::from_bits);
        let axes = [[-12_084, -15_580, -13_157], [48, 1 << 23, -196_608], [13_702, -7_444, -1_397]];
        let center = of([1_024, -6_291_456, -49_152]);
        let obb = Obb::from_skewed_axes(center, axes.each(of), of([6_291_456, 1_536, 0])).unwrap();
        let away = of([8_192, -1_024, -(1 << 27)]);
        let reaches =
            |radius: i32| Sphere::new(away, I0F32::from_bits(radius)).unwrap().overlaps(&obb);
        // The box is a few thousand last places long, at √(134,168,576² + 6,290,432²) of them.
        assert!(!reaches(1 << 27) && !reaches(134_300_000) && reaches(134_330_000));
    }
}
