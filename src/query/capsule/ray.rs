//! Capsule against ray.
//!
//! A segment and a ray are nearest at an end of the segment, at an end of the ray, or between all
//! ends, where the planes through both with the normal n = e × d lie closest to each other. m goes
//! from the ray's origin to an end of the segment, e along the segment and d along the ray. With w =
//! m − t·d from the end of the ray at t, that is nearest to the segment between the segment's ends
//! if w·e has different signs at the two, at a distance of |e × w|²/e·e from its line. The lines are
//! nearest beyond this end if n·(e × w) is not on the side of the range.
//!
//! Multiplied out, these compare in products of six numbers.

use super::all_beyond;
use crate::arithmetic::{
    Arithmetic, Each, Embeds, Number, cross, dot, greatest, largest, once, three, two,
};
use crate::query::Overlaps;
use crate::query::orientation::{Vector, from};
use crate::query::sphere::{
    Ball, Beyond, Errors, PRODUCT, Reach, SQUARES, Way, along, meet, product,
};
use crate::robust::{Predicate, Profile, Uncertain};
use crate::scalar::Scalar;
use crate::shape::{Capsule, Ray};

/// Roundoffs in w·e, of R, the greatest |e|, times W, which is twice the greatest magnitude of m and
/// t·d. To first order 17: for each of 3 terms 2 of w, 1 of e and 1 of the product, and 5 of the
/// sums. `ray.g` proves all of these.
const ALONG: u16 = 24;
/// Roundoffs in a component of e × w, of W·R. To first order 10: 2 terms likewise, and 2 of the
/// difference.
const MINOR: u16 = 14;
/// Roundoffs in (D·n)·(e × w), of D²·W·R², with D the greatest |d|. To first order 140: a component
/// of D·n has 8, and is up to 2; so for each of 3 terms 16 and 20 of its operands and 4 of the
/// product, and 20 of the sums.
const SIDE: u16 = 180;

/// A segment and a ray.
struct Pair<N: Arithmetic> {
    /// From the origin of the ray to the ends of the segment.
    m: [Vector<N>; 2],
    e: Vector<N>,
    way: Way<N>,
    n: [N::Area; 3],
    /// The greatest magnitude of m, e and the radius.
    size: N::Length,
}

/// Whether the lines are nearest beyond an end of the ray, and whether that end lies beyond the
/// radius of the segment between the segment's ends.
struct End {
    is_outside: Uncertain,
    lies_beyond: Uncertain,
}

impl<N: Arithmetic> Pair<N> {
    /// The end at t.
    #[inline(never)]
    fn at_end<S>(&self, t: N::Length, is_start: bool, reach: &Reach<N>) -> Option<End>
    where
        N: Embeds<S>,
    {
        let Self { m, e, way: Way { d, unit, .. }, n, .. } = self;
        let t = once::<N, _>(t);
        let td = three(|i| N::area(t, d[i]));
        let times_one = |x: N::Length| N::times_one(x, *unit);
        let (m, r) = (m.each(|m| m.each(times_one)), times_one(reach.radius));
        let size = greatest(greatest(largest(&m[0]), largest(&m[1])), largest(&td));
        let size = size + size;
        if !N::CERTAIN && !greatest(size, r).in_range() {
            return None;
        }
        let w = two(|k| three(|i| m[k][i] - td[i]));
        let longest = largest(e);

        let error = N::volume(size, longest).error(ALONG);
        let is_before = Uncertain::not_below(dot::<N>(&w[0], e), error);
        let is_after = Uncertain::not_below(-dot::<N>(&w[1], e), error);

        let v = three(|i| {
            let (j, k) = ((i + 1) % 3, (i + 2) % 3);
            N::volume(w[0][k], e[j]) - N::volume(w[0][j], e[k])
        });
        let square = |x: N::Volume| N::sextic(x, x);
        let far = square(v[0]) + square(v[1]) + square(v[2]);
        let near = N::sextic_of_areas(N::quartic(r, r), product::<N>(e, e));
        let error = N::volume(size, longest).error(MINOR);
        let sum = v[0].magnitude() + v[1].magnitude() + v[2].magnitude();
        let most = sum + sum + (error + error + error);
        let error = N::sextic(error, most) + far.error(SQUARES) + near.error(PRODUCT);
        let by_line = reach.ball.excludes(far - near, error);

        let most = largest(d);
        let term = |i: usize| N::sextic(N::volume(n[i], most), v[i]);
        let side = term(0) + term(1) + term(2);
        let error = N::volume(N::area(longest, most), most);
        let error = N::sextic(error, N::volume(size, longest)).error(SIDE);
        Some(End {
            is_outside: Uncertain::not_below(if is_start { -side } else { side }, error),
            lies_beyond: is_before.or(is_after).or(by_line),
        })
    }

    /// The end at zero, as for most rays: no product with t.
    #[inline(always)]
    fn at_origin(&self, is_start: bool, reach: &Reach<N>) -> End {
        let Self { m, e, way: Way { d, .. }, n, size } = self;
        let side = along::<N>(n, &cross::<N>(e, &m[0]));
        let back = two(|k| three(|i| -m[k][i]));
        let error = Errors::<N>::side_of(*size, largest(d));
        End {
            is_outside: Uncertain::not_below(if is_start { -side } else { side }, error),
            lies_beyond: Uncertain::of(reach.excludes_segment(&back, e, N::Length::ZERO)),
        }
    }
}

/// Out of line, because both ends ask it.
#[inline(never)]
fn lies_beyond<S, N: Embeds<S>>(way: &Way<N>, m: &Vector<N>, reach: &Reach<N>) -> Option<bool> {
    way.lies_beyond(m, reach)
}

impl<S: Scalar> Predicate<S> for Beyond<'_, Capsule<S>, Ray<S>> {
    type Answer = bool;
    // As with a sphere.
    const PROFILE: Profile = Profile::AREAS;

    #[inline]
    fn filter<N: Embeds<S>>(&self) -> Option<bool> {
        let ([a, b], [o, d, range]) = (self.ends(), self.shape.numbers_and_unit());
        let all = [a, b, o, d, range, [self.round.radius(); 3]];
        let [a, b, o, d, range, [r, ..]] = N::embed(&all)?;
        let (m, e) = ([from::<N>(&a, &o), from::<N>(&b, &o)], from::<N>(&b, &a));
        let reach = Reach::<N>::new(r, self.ball);
        let size = greatest(greatest(largest(&m[0]), largest(&m[1])), greatest(largest(&e), r));
        let errors = Errors::<N>::with_direction(size, largest(&d))?;
        let n = cross::<N>(&e, &d);
        let [by_plane] = reach.excludes_planes(&n, [dot::<N>(&n, &m[0])], &errors);
        if by_plane.certain {
            return Some(true);
        }

        let pair = Pair { m, e, way: Way::new(self.shape, d, range), n, size };
        let Pair { m, way, .. } = &pair;
        let of_ends = all_beyond(m.iter().map(|m| lies_beyond(way, m, &reach)));
        if of_ends == Some(false) {
            return Some(false);
        }
        let (mut is_outside, mut are_beyond) = (Uncertain::NONE, Uncertain::of(of_ends));
        for (k, m) in m.iter().enumerate() {
            let side = along::<N>(&n, &cross::<N>(&d, m));
            let side = if k == 0 { -side } else { side };
            is_outside = is_outside.or(Uncertain::not_below(side, errors.side));
        }
        for (k, end) in way.ends.into_iter().enumerate() {
            let end = match end {
                None => continue,
                Some(t) if t == N::Length::ZERO => pair.at_origin(k == 0, &reach),
                Some(t) => pair.at_end(t, k == 0, &reach)?,
            };
            is_outside = is_outside.or(end.is_outside);
            are_beyond = are_beyond.and(end.lies_beyond);
        }
        by_plane.or(is_outside).and(are_beyond).verdict()
    }
}

impl<S: Scalar> Overlaps<Ray<S>> for Capsule<S> {
    /// Do a capsule and a ray have a point in common?
    ///
    /// *Geometry*: closed sets, the ray with its points for all t of its range. The direction may
    /// have any length except zero, the radius may be zero, the ends of the capsule may coincide.
    ///
    /// *Contact*, *Numerics* and *Range*: as for a
    /// [triangle](Capsule#impl-Overlaps<Triangle<S>>-for-Capsule<S>).
    ///
    /// *Panics*: never. *Cost*: 26 multiplications if the planes through both lines lie apart;
    /// otherwise two [spheres](crate::Sphere#impl-Overlaps<Ray<S>>-for-Sphere<S>) at the ends, and
    /// 40 to 60 for each end of the ray.
    ///
    /// ```
    /// use septum::{Capsule, Ray};
    ///
    /// let walker = Capsule::new([4.0_f32, 0.0, 0.5], [4.0, 0.0, 1.5], 0.5)?;
    /// let past = Ray::new([0.0, 0.5, 1.0], [1.0, 0.0, 0.0])?;
    /// assert!(walker.overlaps(&past)); // touches between all ends
    /// assert!(!walker.overlaps(&past.with_range(4.000_001, None)?));
    /// # Ok::<(), septum::ShapeError>(())
    /// ```
    #[inline]
    fn overlaps(&self, ray: &Ray<S>) -> bool {
        meet(self, ray, Ball::Closed)
    }
}
