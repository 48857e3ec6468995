//! Where a ray enters a sphere and leaves it.
//!
//! m goes from the ray's origin to the centre, and d along the ray. Then t is a root of d·d·t² −
//! 2·d·m·t + m·m − r², whose discriminant is r²·d·d − |m × d|².

use core::cmp::Ordering;

use crate::arithmetic::{Arithmetic, Enclosed, cross, sign_of};
use crate::query::orientation::{Vector, from};
use crate::query::surd::{Equation, Question, Surd, root};
use crate::scalar::Scalar;
use crate::shape::{Ray, Sphere};

use super::kernel::{along, product};

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
