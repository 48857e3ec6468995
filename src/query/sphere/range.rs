//! Where a ray enters a sphere and leaves it.
//!
//! m goes from the ray's origin to the centre, and d along the ray. Then t is a root of d·d·t² −
//! 2·d·m·t + m·m − r², whose discriminant is r²·d·d − |m × d|².

use core::cmp::Ordering;

use crate::arithmetic::{Arithmetic, Enclosed, cross, sign_of};
use crate::query::orientation::from;
use crate::query::surd::{Question, Surd, root};
use crate::scalar::Scalar;
use crate::shape::{Ray, Sphere};

use super::kernel::{along, product};

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
        let (a, p, c) = (product::<N>(d, d), product::<N>(&m, d), product::<N>(&m, &m) - r2);
        let across = cross::<N>(&m, d);
        let root = root(N::quartic(a, r2) - along::<N>(&across, &across))?;
        // The root with the greater magnitude has the sign of p.
        let is_back = sign_of(p)? == Ordering::Less;
        let is_inside = sign_of(c)? == Ordering::Less;
        let p = if is_back { -p } else { p };
        let surd = |is_far: bool| Surd { a, p, c, root, is_far };
        let far = surd(true).rounded(is_back, !is_back)?;
        let near = surd(false).rounded(is_back != is_inside, is_back)?;
        Some(if is_back { (far, near) } else { (near, far) })
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
