//! Ray and triangle by the determinants of Möller and Trumbore.

use super::{Fractions, Limits, Triple, line, resolve, rounded};
use crate::arithmetic::{cross3, dot3, minus3};
use crate::query::{Cull, Hit};
use crate::scalar::Scalar;
use crate::shape::{Ray, Triangle};

/// Where does the ray cross the triangle, by the determinants of Möller and Trumbore? In the
/// scalar's own arithmetic: fast, and occasionally wrong.
///
/// Choose it if each triangle is met once, so that preparing it does not pay, and if a ray lost
/// between two triangles does no harm. The others compare as follows in `f32` on a 64-bit machine
/// (`docs/speed.md` in the repository has the figures):
///
/// * [`Ray::hit`] is exact, faster if half of the rays hit, and a quarter slower if a tenth does.
/// * [`Triangles`](crate::lanes::Triangles), eight at once, take about a seventh of the time.
/// * [`volumes`](super::volumes::hit) takes as long or longer. So do
///   [`stored_normal`](super::stored_normal::hit) and [`projected`](super::projected::hit) on a
///   prepared triangle. [`watertight`](super::watertight::ShearedRay::hit) takes half as long
///   again.
///
/// *Geometry*: both sides count unless `cull` excludes one; t is in the ray's range. A determinant
/// of zero is no hit: the triangle is flat, or the ray lies along its plane.
///
/// *Contact*: an edge or vertex is a hit, as far as rounding allows.
///
/// *Numerics*: wrong near edges, and for rays nearly parallel to the plane. In fixed point,
/// products lose their last bits and wrap around outside the range: coordinates should lie between
/// about 1 and the cube root of the type's greatest value.
///
/// *Panics*: never. *Cost*: 24 multiplications, 3 divisions, no early exit. The published early
/// exits are hard for the processor to predict. They are faster if half of the rays hit and slower
/// if a tenth does.
///
/// *Source*: T. Möller, B. Trumbore, "Fast, Minimum Storage Ray/Triangle Intersection", *Journal of
/// Graphics Tools* 2(1), 1997; *Real-Time Rendering*, section 16.8. Ours divides last, and by the
/// determinant itself.
///
/// ```
/// use septum::published::moller_trumbore;
/// use septum::{Cull, Ray, Triangle};
///
/// let floor = Triangle::new([0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0])?;
/// let ray = Ray::new([0.25, 0.5, 9.0], [0.0, 0.0, -2.0])?;
/// let hit = moller_trumbore::hit(&ray, &floor, Cull::Nothing).unwrap();
/// assert_eq!((hit.t, hit.u, hit.v), (4.5, 0.25, 0.5));
/// # Ok::<(), septum::ShapeError>(())
/// ```
#[inline]
#[must_use]
pub fn hit<S: Scalar>(ray: &Ray<S>, triangle: &Triangle<S>, cull: Cull) -> Option<Hit<S>> {
    // Read before the ray: the other way round takes up to 5 % longer.
    let points = triangle.points();
    resolve(moller_trumbore(line(ray), points), &Limits::new(ray, cull)).into_hit()
}

#[inline(always)]
pub(crate) fn moller_trumbore<S: Scalar>(
    (origin, direction): (Triple<S>, Triple<S>),
    [a, b, c]: [[S; 3]; 3],
) -> Fractions<S> {
    let (a, b, c) = (rounded(a), rounded(b), rounded(c));
    let (e1, e2, s) = (minus3(&b, &a), minus3(&c, &a), minus3(&origin, &a));
    let p = cross3(&direction, &e2);
    let q = cross3(&s, &e1);
    Fractions { det: dot3(&e1, &p), t: dot3(&e2, &q), u: dot3(&s, &p), v: dot3(&direction, &q) }
}
