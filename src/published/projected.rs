//! Ray and triangle by the plane, and then in two dimensions.

use super::stored_normal::store;
use super::{Limits, by_index, line, none_below_zero, rounded};
use crate::arithmetic::{Number, Rounded, dot3, minus3, pick, turn};
use crate::query::{Candidate, Cull, Hit};
use crate::scalar::Scalar;
use crate::shape::{Ray, Triangle};

/// A triangle prepared for [`hit`]: its plane, and its edges in the coordinate plane in which it
/// looks largest, all rounded.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ProjectedTriangle<S> {
    a: [S; 3],
    normal: [S; 3],
    // Oriented so that the area is above zero.
    edges: [[S; 2]; 2],
    area: S,
    /// The two coordinates of the projection.
    left: [u8; 2],
}

impl<S: Scalar> ProjectedTriangle<S> {
    /// The triangle with its plane and its projection, prepared for [`hit`].
    ///
    /// *Panics*: never. *Cost*: 6 multiplications, 9 differences, 4 comparisons.
    #[inline]
    #[must_use]
    pub fn new(triangle: &Triangle<S>) -> Self {
        let points = triangle.points();
        let [_, e1, e2, n] = store(points);
        let [x, y, z] = [n[0].magnitude(), n[1].magnitude(), n[2].magnitude()];
        let dropped = if x >= y && x >= z {
            0
        } else if y >= z {
            1
        } else {
            2
        };
        let (i, j, k) = turn(dropped);
        let area = *pick(&n, i);
        let up = |x: Rounded<S>| if area < Rounded::ZERO { (-x).0 } else { x.0 };
        let flat = |e| [up(*pick(&e, j)), up(*pick(&e, k))];
        Self {
            a: points[0],
            normal: [n[0].0, n[1].0, n[2].0],
            edges: [flat(e1), flat(e2)],
            area: up(area),
            left: [j as u8, k as u8],
        }
    }
}

/// Where does the ray cross the triangle? The plane first, then the point in it in two dimensions,
/// in the scalar's own arithmetic; occasionally wrong.
///
/// Choose it where multiplications are expensive, as on a core without a floating-point unit, or
/// where most rays miss the plane and divisions are cheap. In floats it gains little on
/// [`moller_trumbore`](super::moller_trumbore::hit), whose page compares the methods: it must
/// divide before it can evaluate the point. In I16F16 its u and v stay in range the longest,
/// because they come from areas and not from volumes.
///
/// *Geometry*, *Contact*: as for [`moller_trumbore`](super::moller_trumbore::hit). *Numerics*: the
/// error of t moves the point, so it grows with the distance.
///
/// *Panics*: never. *Cost*: 12 multiplications, 3 divisions.
///
/// *Source*: D. Badouel, "An Efficient Ray-Polygon Intersection", *Graphics Gems*, 1990; E.
/// Haines's survey of such methods. Ours keeps the area and divides last for u and v.
#[inline]
#[must_use]
pub fn hit<S: Scalar>(ray: &Ray<S>, triangle: &ProjectedTriangle<S>, cull: Cull) -> Option<Hit<S>> {
    projected(ray, triangle, &Limits::new(ray, cull)).into_hit()
}

#[inline(always)]
fn projected<S: Scalar>(
    ray: &Ray<S>,
    triangle: &ProjectedTriangle<S>,
    limits: &Limits<S>,
) -> Candidate<S> {
    let zero = Rounded::ZERO;
    let ProjectedTriangle { a, normal, edges: [e1, e2], area, left: [j, k] } = *triangle;
    let (o, d) = line(ray);
    let s = minus3(&o, &rounded(a));
    let n = rounded(normal);
    let det = zero - dot3(&d, &n);
    let front = det > zero;
    let crosses = ((det > zero) | (det < zero)) & limits.keep(front);
    let t = dot3(&s, &n).0.plain_div(if crosses { det.0 } else { S::ZERO });

    let on = |i| *by_index(&s, i) + Rounded(t) * *by_index(&d, i);
    let (x, y) = (on(j), on(k));
    let u = x * Rounded(e2[1]) - y * Rounded(e2[0]);
    let v = y * Rounded(e1[0]) - x * Rounded(e1[1]);
    let w = Rounded(area) - u - v;
    let inside = crosses & limits.hold(t) & none_below_zero(u, v, w);
    let divisor = if inside { area } else { S::ZERO };
    Candidate::new(
        inside,
        [t, u.0.plain_div(divisor), v.0.plain_div(divisor)],
        front,
        [w == zero, u == zero, v == zero],
    )
}
