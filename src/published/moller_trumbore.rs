//! Ray and triangle by the determinants of Möller and Trumbore.

use super::resolve::{Fractions, Limits, resolve};
use super::vector::{Triple, cross, dot, minus, rounded};
use crate::query::{Cull, Hit};
use crate::scalar::Scalar;
use crate::shape::{Ray, Triangle};

/// Where the ray crosses the triangle, by the determinants of Möller and Trumbore
/// in the scalar's own arithmetic: fast, and now and then wrong.
///
/// Choose it where triangles are met once, so that nothing can be prepared, and
/// a ray lost between two triangles does no harm. What measures otherwise (`f32` on a
/// 64-bit machine; `docs/speed.md` in the repository has the figures):
///
/// * [`Ray::hit`] is exact, faster where half of the rays hit, and a quarter slower where a
///   tenth does.
/// * [`Triangles`](crate::lanes::Triangles), eight at once, take about a seventh.
/// * [`volumes`](super::volumes::hit), and [`stored_normal`](super::stored_normal::hit) and
///   [`projected`](super::projected::hit) on a triangle prepared, take as long or longer,
///   [`watertight`](super::watertight::ShearedRay::hit) half as long again.
///
/// *Geometry*: both sides count, but for `cull`; t in the ray's range. A
/// determinant of zero, of a flat triangle or a ray along the plane, is no hit.
///
/// *Contact*: an edge or vertex is a hit, as far as rounding lets it.
///
/// *Numerics*: wrong near edges and near the plane's own directions. In fixed
/// point products lose their last bits and wrap beyond the range: there it is
/// for coordinates between about 1 and the cube root of the type's end.
///
/// *Panics*: never. *Cost*: 24 multiplications, 3 divisions, no early exit. The
/// published early exits, which the processor cannot foresee, win where half of the rays
/// hit and lose where a tenth does.
///
/// *Source*: T. Möller, B. Trumbore, "Fast, Minimum Storage Ray/Triangle
/// Intersection", *Journal of Graphics Tools* 2(1), 1997; *Real-Time Rendering*,
/// section 16.8. Ours divides last, and by the determinant itself.
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
    let [a, b, c] = triangle.points();
    let fractions = moller_trumbore(
        rounded(ray.origin().to_array()),
        rounded(ray.direction().to_array()),
        [rounded(a), rounded(b), rounded(c)],
    );
    resolve(fractions, &Limits::new(ray, cull)).into_hit()
}

#[inline(always)]
pub(crate) fn moller_trumbore<S: Scalar>(
    origin: Triple<S>,
    direction: Triple<S>,
    [a, b, c]: [Triple<S>; 3],
) -> Fractions<S> {
    let (e1, e2, s) = (minus(b, a), minus(c, a), minus(origin, a));
    let p = cross(direction, e2);
    let q = cross(s, e1);
    Fractions { det: dot(e1, p), t: dot(e2, q), u: dot(s, p), v: dot(direction, q) }
}
