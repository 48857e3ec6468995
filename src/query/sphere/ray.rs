//! Sphere against ray: whether they meet, and where.
//!
//! m goes from the ray's origin to the centre, and d along the ray. The squared distance from the
//! line is |m × d|²/d·d. From the end at t it is |m − t·d|², and the centre lies before that end if
//! (m − t·d)·d < 0. Multiplied out, these compare in products of up to four numbers.
//!
//! Where the ray enters the sphere and leaves it, t is a root of d·d·t² −
//! 2·d·m·t + m·m − r², whose discriminant is r²·d·d − |m × d|².

use core::cmp::Ordering;

use super::error_bound::{Errors, PRODUCT};
use super::kernel::{Ball, Reach, along, product, squared};
use super::{Beyond, meet};
use crate::arithmetic::{
    Arithmetic, Each, Embeds, Enclosed, Number, cross, dot, greatest, largest, once, sign_of, three,
};
use crate::query::Overlaps;
use crate::query::orientation::{Vector, from};
use crate::query::surd::{Equation, Question, Surd, root};
use crate::robust::{Predicate, Profile, Uncertain};
use crate::scalar::Scalar;
use crate::shape::{Ray, Sphere};

/// Roundoffs in a component of m − t·d, of twice the greatest magnitude of m and t·d. To first order
/// 2: half of one each of m and t·d, and 1 of the sum. `ray.g` proves both.
const END: u16 = 4;
/// Roundoffs in (m − t·d)·d, of the same times the greatest |d|. To first order 14: for each of 3
/// terms 2 and 1 of the product, and 5 of the sums.
const ALONG: u16 = 20;

/// Whether a point is closest to an end of a range, or beyond it; and whether that end lies beyond
/// the radius.
struct End {
    is_past: Uncertain,
    lies_beyond: Uncertain,
}

/// The direction of a ray, and the ends of its range.
pub(in crate::query) struct Way<N: Arithmetic> {
    pub(in crate::query) d: Vector<N>,
    pub(in crate::query) ends: [Option<N::Length>; 2],
    pub(in crate::query) unit: N::Length,
}

impl<N: Arithmetic> Way<N> {
    /// From those numbers, with the unit of length.
    #[inline(always)]
    pub(in crate::query) fn new<S: Scalar>(
        ray: &Ray<S>,
        d: Vector<N>,
        [t, u, unit]: Vector<N>,
    ) -> Self {
        Self { d, ends: [ray.t_min().map(|_| t), ray.t_max().map(|_| u)], unit }
    }

    /// Whether the ray lies beyond the reach of a point at `m` from its origin; `None` in doubt.
    #[inline(always)]
    pub(in crate::query) fn lies_beyond<S>(&self, m: &Vector<N>, reach: &Reach<N>) -> Option<bool>
    where
        N: Embeds<S>,
    {
        let d = &self.d;
        let size = greatest(largest(m), reach.radius);
        let errors = Errors::<N>::with_direction(size, largest(d))?;
        let far = squared::<N>(&cross::<N>(m, d), errors.minor);
        let near = N::quartic(product::<N>(d, d), reach.square);
        let error = far.error + near.error(PRODUCT);
        let by_line = reach.ball.excludes(far.value - near, error);
        if by_line.certain {
            return Some(true);
        }
        let (mut by_ends, mut at_ends) = (Uncertain::NONE, Uncertain::known(true));
        for (k, end) in self.ends.into_iter().enumerate() {
            let End { is_past, lies_beyond } = match end {
                None => continue,
                // As for most rays: no product with t.
                Some(t) if t == N::Length::ZERO => {
                    let along = product::<N>(m, d);
                    let is_past = if k == 0 { -along } else { along };
                    End {
                        is_past: Uncertain::not_below(is_past, errors.dot),
                        lies_beyond: reach.excludes(m, N::Length::ZERO),
                    }
                }
                Some(t) => at_end::<S, N>(m, d, [t, self.unit], reach, k == 0)?,
            };
            by_ends = by_ends.or(is_past.and(lies_beyond));
            at_ends = at_ends.and(lies_beyond);
        }
        by_line.or(by_ends).and(at_ends).verdict()
    }
}

impl<S: Scalar> Predicate<S> for Beyond<'_, Sphere<S>, Ray<S>> {
    type Answer = bool;
    // The volume of an end would not fit the integers for 18 bits.
    const PROFILE: Profile = Profile::AREAS;

    #[inline]
    fn filter<N: Embeds<S>>(&self) -> Option<bool> {
        let [o, d, range] = self.shape.numbers_and_unit();
        let [c, [r, ..], o, d, range] = N::embed(&[self.center(), self.radius(), o, d, range])?;
        let way = Way::<N>::new(self.shape, d, range);
        way.lies_beyond(&from::<N>(&c, &o), &Reach::<N>::new(r, self.ball))
    }
}

/// The end of a ray at t.
#[inline(never)]
fn at_end<S, N: Embeds<S>>(
    m: &Vector<N>,
    d: &Vector<N>,
    [t, unit]: [N::Length; 2],
    reach: &Reach<N>,
    is_start: bool,
) -> Option<End> {
    let t = once::<N, _>(t);
    let m = m.each(|x| N::times_one(x, unit));
    let td = three(|i| N::area(t, d[i]));
    let (to, r) = (three(|i| m[i] - td[i]), N::times_one(reach.radius, unit));
    let size = greatest(largest(&m), largest(&td));
    let size = size + size;
    let error = size.error(END);
    let along = dot::<N>(&to, d);
    let is_past = if is_start { -along } else { along };
    let (far, near) = (squared::<N>(&to, error), N::quartic(r, r));
    if !N::CERTAIN && !(greatest(size, r).in_range() & N::area(largest(d), largest(d)).in_range()) {
        return None;
    }
    Some(End {
        is_past: Uncertain::not_below(is_past, N::volume(size, largest(d)).error(ALONG)),
        lies_beyond: reach.ball.excludes(far.value - near, far.error + near.error(PRODUCT)),
    })
}

impl<S: Scalar> Overlaps<Ray<S>> for Sphere<S> {
    /// Do a sphere and a ray have a point in common?
    ///
    /// *Geometry*: a closed ball, and the ray's points for all t of its range. The direction may
    /// have any length except zero, the radius may be zero.
    ///
    /// *Contact*, *Numerics* and *Range*: as for a
    /// [triangle](Sphere#impl-Overlaps<Triangle<S>>-for-Sphere<S>), in products of four numbers.
    ///
    /// *Panics*: never. *Cost*: 14 multiplications if the line passes by, 20 for t ≥ 0, and 13 for
    /// each end of another range.
    ///
    /// ```
    /// use septum::{Ray, Sphere};
    ///
    /// let ray = Ray::new([0.0_f32, 0.0, 0.0], [1.0, 2.0, 2.0])?;
    /// assert!(Sphere::new([4.0, -1.0, 8.0], 7.0)?.overlaps(&ray)); // at t = 2: 2² + 5² + 4² < 7²
    /// let past = Sphere::new([-2.0, -3.0, -6.0], 7.0)?;
    /// assert!(past.overlaps(&ray)); // touches the origin
    /// assert!(!past.overlaps(&ray.with_range(0.000_001, 9.0)?));
    /// # Ok::<(), septum::ShapeError>(())
    /// ```
    #[inline]
    fn overlaps(&self, ray: &Ray<S>) -> bool {
        meet(self, ray, Ball::Closed)
    }
}

/// The equation of the times at which a point is at a distance of √`r2` from the end of m.
#[inline(always)]
pub(crate) fn at_distance<N: Arithmetic>(
    m: &Vector<N>,
    d: &Vector<N>,
    r2: N::Area,
) -> Equation<N::Area> {
    Equation { a: product::<N>(d, d), p: product::<N>(m, d), c: product::<N>(m, m) - r2 }
}

/// The first of these times; the second `None` if there is none, the first in doubt.
#[inline(always)]
pub(crate) fn first_at_distance<N>(
    equation: Equation<N::Area>,
    [m, d]: [&Vector<N>; 2],
    r2: N::Area,
) -> Option<Option<Surd<N::Area>>>
where
    N: Arithmetic<Area: Enclosed, Quartic: Enclosed>,
{
    let across = cross::<N>(m, d);
    let q = N::quartic(equation.a, r2) - along::<N>(&across, &across);
    if sign_of(q)? == Ordering::Less {
        return Some(None);
    }
    Some(Some(equation.lesser(root(q)?)))
}

/// The question where the line of a ray enters and leaves a sphere that it meets.
struct Range<'a, S>(&'a Ray<S>, &'a Sphere<S>);

impl<S: Scalar> Question<S, 4> for Range<'_, S> {
    type Answer = (S, S);

    fn numbers(&self) -> [[S; 3]; 4] {
        let Self(ray, sphere) = self;
        let (o, d) = (ray.origin().to_array(), ray.direction().to_array());
        [o, d, sphere.center().to_array(), [sphere.radius(); 3]]
    }

    fn solve<N>(&self, [o, d, center, [r, ..]]: &[[N::Length; 3]; 4]) -> Option<(S, S)>
    where
        N: Arithmetic<Area: Enclosed, Quartic: Enclosed, Sextic: Enclosed>,
    {
        let (m, r2) = (from::<N>(center, o), N::area(*r, *r));
        let forward = first_at_distance::<N>(at_distance::<N>(&m, d, r2), [&m, d], r2)??;
        // As of a ray in the opposite direction.
        let backward = forward.turned();
        Some((forward.lesser(false, false)?, backward.lesser(true, true)?))
    }
}

impl<S: Scalar> Ray<S> {
    /// Where does the ray enter the sphere, and where does it leave it? As values of t; `None` if it
    /// misses the sphere.
    ///
    /// *Geometry*, *Contact*: as [`t_range`](Self::t_range) for an axis-aligned box.
    ///
    /// *Numerics*: exact, except for one rounding outward: the first value is the greatest number of
    /// the scalar that is not above the truth, the second is the least that is not below. All points
    /// of the ray in the sphere lie between them. A value beyond a fixed-point type is the type's
    /// end; a float may be the greatest number or an infinity. The result is `None` if and only if
    /// [`overlaps`](Sphere#impl-Overlaps<Ray<S>>-for-Sphere<S>) is `false`.
    ///
    /// *Range*: all finite floats and all fixed-point values.
    ///
    /// *Panics*: never. *Cost*: as for `overlaps`; a hit takes 26 multiplications, each with an error
    /// bound, two roots and two divisions of integers. In `f64`, in fixed point on 32-bit cores and
    /// of 64 bits, and where a value is within rounding of a number, it takes exact integers.
    ///
    /// ```
    /// use septum::{Ray, Sphere};
    ///
    /// let ball = Sphere::new([6.0_f32, 0.0, 3.0], 5.0)?;
    /// let ray = Ray::new([0.0, 0.0, 0.0], [2.0, 0.0, 0.0])?;
    /// assert_eq!(ray.t_range_sphere(&ball), Some((1.0, 5.0))); // 6 ± 4, in steps of two
    /// assert_eq!(ray.with_range(2.0, None)?.t_range_sphere(&ball), Some((2.0, 5.0)));
    /// # Ok::<(), septum::ShapeError>(())
    /// ```
    #[must_use]
    pub fn t_range_sphere(&self, sphere: &Sphere<S>) -> Option<(S, S)> {
        if !sphere.overlaps(self) {
            return None;
        }
        // Exact numbers always have an answer.
        let (enter, leave) = Range(self, sphere).settle()?;
        Some(self.clipped(enter, leave))
    }
}
