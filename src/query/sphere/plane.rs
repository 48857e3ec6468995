//! Sphere against plane.
//!
//! A point x lies farther than r from a plane with normal n if (n·x + d)² > r²·n·n, or for a plane
//! through p, (n·(x − p))² > r²·n·n: products of four numbers.

use super::error_bound::PRODUCT;
use super::kernel::{Ball, Reach, product};
use crate::arithmetic::{Each, Embeds, Number, greatest, largest, once, three};
use crate::query::Overlaps;
use crate::query::orientation::Vector;
use crate::robust::{Numeric, Predicate, Profile};
use crate::scalar::Scalar;
use crate::shape::{Plane, Sphere, Vec3};

/// Roundoffs in n·x + d, of the greatest |nᵢ| times the greatest |xᵢ|, plus |d|. To first order 14:
/// for each of 3 terms 1 of the difference and 1 of the product, and 8 of the sums. `plane.g`
/// proves it.
const FROM_PLANE: u16 = 20;

/// The question whether all points within a radius of one or two ends lie on one side of a plane,
/// and none on it.
pub(in crate::query) struct OneSide<'a, S> {
    pub(in crate::query) plane: &'a Plane<S>,
    pub(in crate::query) ends: [[S; 3]; 2],
    pub(in crate::query) radius: S,
    pub(in crate::query) ball: Ball,
}

impl<S: Scalar> Predicate<S> for OneSide<'_, S> {
    type Answer = bool;
    const PROFILE: Profile = Profile::AREAS;

    #[inline]
    fn filter<N: Embeds<S>>(&self) -> Option<bool> {
        let n = self.plane.normal().to_array();
        let (point, offset, unit) = self.plane.numbers();
        let [a, b] = self.ends;
        let all = [n, point, a, b, [self.radius, offset, unit]];
        let [n, point, a, b, [r, d, unit]] = N::embed(&all)?;
        let d = N::times_one(d, unit);
        // Lengths as integers double them, for `times_one`.
        let (r, nn) = (once::<N, _>(r), product::<N>(&n, &n));
        let near = N::quartic(nn, Reach::<N>::new(r, self.ball).square);
        let beyond = |x: &Vector<N>| {
            let x = three(|i| once::<N, _>(x[i] - point[i]));
            let from_plane = product::<N>(&n, &x) + d;
            let far = N::quartic(from_plane, from_plane);
            if N::CERTAIN {
                return Some((from_plane, self.ball.excludes(far - near, N::Quartic::ZERO)));
            }
            let (normal, size) = (largest(&n), greatest(largest(&x), r));
            let area = N::area(normal, size) + d.magnitude();
            let is_known = normal.in_range() & size.in_range() & area.in_range();
            let off = area.error(FROM_PLANE);
            let most = from_plane.magnitude() + from_plane.magnitude() + off;
            let error = N::quartic(off, most) + (far + near).error(PRODUCT);
            is_known.then(|| (from_plane, self.ball.excludes(far - near, error)))
        };
        let (first, found) = beyond(&a)?;
        if !found.possible || self.ends[0] == self.ends[1] {
            return found.verdict();
        }
        let (second, other) = beyond(&b)?;
        let are_beyond = found.and(other).verdict()?;
        Some(are_beyond && (first > N::Area::ZERO) == (second > N::Area::ZERO))
    }
}

impl<S: Scalar> Numeric<S> for OneSide<'_, S> {}

/// Whether a ball, open or not, around a point of a segment meets the plane.
pub(in crate::query) fn meets_plane<S: Scalar>(
    ends: [Vec3<S>; 2],
    radius: S,
    plane: &Plane<S>,
    ball: Ball,
) -> bool {
    let ends = ends.each(|end| end.to_array());
    !S::evaluate_numeric(&OneSide { plane, ends, radius, ball })
}

impl<S: Scalar> Overlaps<Plane<S>> for Sphere<S> {
    /// Do a sphere and a plane have a point in common?
    ///
    /// *Geometry*: a closed ball, and the plane in the form in which it was given. The normal may
    /// have any length except zero, the radius may be zero.
    ///
    /// *Contact*, *Numerics* and *Range*: as for a
    /// [triangle](Sphere#impl-Overlaps<Triangle<S>>-for-Sphere<S>), in products of four numbers.
    ///
    /// *Panics*: never. *Cost*: 11 multiplications.
    ///
    /// ```
    /// use septum::{Plane, Sphere};
    ///
    /// let slope = Plane::from_equation([1.0_f64, 2.0, 2.0], -9.0)?;
    /// assert!(Sphere::new([0.0; 3], 3.0)?.overlaps(&slope)); // 9² = 3²·(1 + 4 + 4)
    /// assert!(!Sphere::new([-1e-15, 0.0, 0.0], 3.0)?.overlaps(&slope));
    /// # Ok::<(), septum::ShapeError>(())
    /// ```
    #[inline]
    fn overlaps(&self, plane: &Plane<S>) -> bool {
        meets_plane([self.center(); 2], self.radius(), plane, Ball::Closed)
    }
}
