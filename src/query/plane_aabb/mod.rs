//! Plane against axis-aligned box.
//!
//! E. Haines and J. Wallace, "Shaft Culling for Efficient Ray-Traced Radiosity", 1991: only two of
//! the box's eight corners matter, the farthest and the least far along the plane's normal. Here
//! both are tested at once, from the centre of the box and its radius along the normal.

use super::Overlaps;
use crate::arithmetic::{Arithmetic, Embeds, Number, greatest, largest, of_two, once};
use crate::robust::{Predicate, Profile, Uncertain};
use crate::scalar::Scalar;
use crate::shape::{Aabb, Plane};

/// The side of a plane on which a shape lies.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum Side {
    /// The whole shape is in front of the plane, on the side of the normal, and does not touch it.
    Front,
    /// The whole shape is behind the plane, and does not touch it.
    Back,
    /// The shape has points on both sides, or touches the plane.
    Both,
}

/// The question whether the whole box lies on one side.
struct Beyond<'a, S> {
    plane: &'a Plane<S>,
    aabb: &'a Aabb<S>,
    front: bool,
}

impl<S: Scalar> Predicate<S> for Beyond<'_, S> {
    type Answer = bool;
    const PROFILE: Profile = Profile::AREAS;

    #[inline]
    fn filter<N: Embeds<S>>(&self) -> Option<bool> {
        let n = self.plane.normal().to_array();
        let (point, offset, unit) = self.plane.numbers();
        let (p, q, is_by_center) = self.aabb.numbers();
        let all = [point, p, q, n, [offset, unit, S::ZERO]];
        let [point, p, q, n, [d, unit, _]] = N::embed(&all)?;

        // The plane's point and the box's half-extents, in the frame of the box.
        let (mut v, mut h) = ([N::Length::ZERO; 3], [N::Length::ZERO; 3]);
        for i in 0..3 {
            (v[i], h[i]) = if is_by_center {
                (once::<N, _>(point[i] - p[i]), once::<N, _>(q[i]))
            } else {
                let both = (point[i] - p[i]) + (point[i] - q[i]);
                (of_two::<N, _>(both), of_two::<N, _>(q[i] - p[i]))
            };
        }

        // The distances, along n, from the plane to the centre and from the centre to a corner.
        let d_area = N::times_one(d, unit);
        let from_center = N::area(n[0], v[0]) + N::area(n[1], v[1]) + N::area(n[2], v[2]) - d_area;
        let radius = N::area(n[0].magnitude(), h[0])
            + N::area(n[1].magnitude(), h[1])
            + N::area(n[2].magnitude(), h[2]);
        let gap = if self.front { -from_center } else { from_center } - radius;

        if N::CERTAIN {
            return Some(gap > N::Area::ZERO);
        }
        let size = greatest(largest(&v), largest(&h));
        let error_bound = error_bound::<N>(largest(&n), size, d_area.magnitude())?;
        // One axis: two branches take less time than a verdict without one.
        let found = Uncertain::above(gap, error_bound);
        if found.certain {
            Some(true)
        } else if found.possible {
            None
        } else {
            Some(false)
        }
    }
}

impl<S: Scalar> Plane<S> {
    /// The side of the plane on which an axis-aligned box lies.
    ///
    /// *Geometry*: the box is a closed set, and may be flat or a point.
    ///
    /// *Contact*: a box that touches the plane is [`Side::Both`].
    ///
    /// *Numerics*: exact for every valid input, in every scalar.
    ///
    /// *Range*: all finite floats, all fixed-point values; 64-bit fixed point beyond 2⁶⁰ units in
    /// the last place takes wider integers.
    ///
    /// *Panics*: never. *Cost*: 6 multiplications for a box in front, otherwise 12.
    ///
    /// *Source*: Haines and Wallace 1991; the exact stages are ours.
    ///
    /// ```
    /// use septum::{Aabb, Plane, Side};
    ///
    /// let cell = Aabb::from_min_max([0.0_f32; 3], [1.0; 3])?;
    /// let slope = Plane::from_equation([1.0, 1.0, 1.0], -3.0)?;
    /// assert_eq!(slope.side_of(&cell), Side::Both); // touches (1, 1, 1)
    /// let slope = Plane::from_equation([1.0, 1.0, 1.0], -3.0000002)?;
    /// assert_eq!(slope.side_of(&cell), Side::Back);
    /// # Ok::<(), septum::ShapeError>(())
    /// ```
    #[inline]
    #[must_use]
    pub fn side_of(&self, aabb: &Aabb<S>) -> Side {
        if S::evaluate(&Beyond { plane: self, aabb, front: true }) {
            Side::Front
        } else if S::evaluate(&Beyond { plane: self, aabb, front: false }) {
            Side::Back
        } else {
            Side::Both
        }
    }
}

impl<S: Scalar> Overlaps<Aabb<S>> for Plane<S> {
    /// Do a plane and an axis-aligned box have a point in common?
    ///
    /// Exact, closed, and never panics; see [`Plane::side_of`].
    #[inline]
    fn overlaps(&self, aabb: &Aabb<S>) -> bool {
        self.side_of(aabb) == Side::Both
    }
}

// The error of the computed distance between a plane and a corner of a box, in units of u·(N·R +
// |d|), with u the unit roundoff.
//
// N is the greatest magnitude among the components of the normal n. v is the plane's point and h
// the half-extents, both in the box's frame, and R is their greatest magnitude. The kernel
// computes n·v and Σ h·|n| and subtracts them. Each v errs by up to 3 (see
// `triangle_aabb::error_bound`). The count to first order is 36.
//
// For a plane given by its offset d, v is the world's origin in the box's frame and errs by 1.
// Adding d adds 1 rounding, and the count is 33, plus 2 for |d|.
//
// `error_bound.g` proves `PLANE`, second orders and underflow included.

/// Roundoffs in the distance.
const PLANE: u16 = 40;

/// The bound for normals up to `normal`, lengths up to `size`, and an offset times one of up to
/// `offset`. `None` if a size is out of range.
#[inline(always)]
fn error_bound<N: Arithmetic>(
    normal: N::Length,
    size: N::Length,
    offset: N::Area,
) -> Option<N::Area> {
    let sum = N::area(normal, size) + offset;
    (normal.in_range() && size.in_range()).then(|| sum.error(PLANE))
}
