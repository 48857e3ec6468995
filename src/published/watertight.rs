//! Ray and triangle so that no ray slips between two triangles.

use super::degenerate_view::degenerate_view;
use super::resolve::Limits;
use super::vector::{Triple, by_index, dot, minus, rounded};
use crate::arithmetic::{Number, Rounded, pick, turn};
use crate::query::{Candidate, Cull, Hit};
use crate::scalar::Scalar;
use crate::shape::{Ray, Triangle};

/// A ray prepared for the watertight test: with the shear that stands it upright
/// along its longest coordinate.
///
/// ```
/// use septum::published::watertight::ShearedRay;
/// use septum::{Cull, Ray, Triangle};
///
/// // The ray goes through the edge that the two share: both are hit, never none.
/// let (p, q) = ([0.1_f32, 0.3, 0.7], [0.9, 0.8, 0.2]);
/// let left = Triangle::new(p, q, [0.0, 1.0, 0.0])?;
/// let right = Triangle::new(q, p, [1.0, 0.0, 1.0])?;
/// let ray = ShearedRay::new(&Ray::new([0.5, 0.55, 2.0], [0.0, 0.0, -1.0])?);
/// assert!(ray.hit(&left, Cull::Nothing).or(ray.hit(&right, Cull::Nothing)).is_some());
/// # Ok::<(), septum::ShapeError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ShearedRay<S> {
    pub(crate) ray: Ray<S>,
    /// Which coordinates become x, y and z.
    pub(crate) axes: [u8; 3],
    shear: [S; 2],
    /// The direction along z.
    height: S,
}

impl<S: Scalar> ShearedRay<S> {
    /// The ray with its shear, prepared for [`hit`](Self::hit).
    ///
    /// *Panics*: never. *Cost*: 2 divisions, 2 comparisons.
    #[inline]
    #[must_use]
    pub fn new(ray: &Ray<S>) -> Self {
        let d = ray.direction().to_array();
        // Negative magnitudes: the positive one of the least number does not exist.
        let below = |x: S| if x > S::ZERO { S::ZERO.plain_sub(x) } else { x };
        let [x, y, z] = [below(d[0]), below(d[1]), below(d[2])];
        let longest = if z <= x && z <= y { 2 } else { usize::from(y <= x) };
        let (kz, mut kx, mut ky) = turn(longest);
        let height = *pick(&d, kz);
        // From the other end left is right.
        if height < S::ZERO {
            (kx, ky) = (ky, kx);
        }
        let shear = [pick(&d, kx).plain_div(height), pick(&d, ky).plain_div(height)];
        Self { ray: *ray, axes: [kx as u8, ky as u8, kz as u8], shear, height }
    }

    /// The ray that this was made from.
    #[inline]
    #[must_use]
    pub const fn ray(&self) -> &Ray<S> {
        &self.ray
    }

    /// Where the ray crosses the triangle, in the scalar's own arithmetic and so that
    /// no ray slips between two triangles: watertight, but not exact.
    ///
    /// Choose it where a closed mesh must not leak and a verdict that is off by a
    /// rounding does no harm, and above all eight at once, by
    /// [`Triangles`](crate::lanes::Triangles). One by one [`Ray::hit`], which is exact
    /// and watertight too, takes less time.
    ///
    /// *Geometry*: both sides count, but for `cull`; t in the ray's range. It is the
    /// crossing of a ray and a triangle that are moved by a rounding, a corner by as
    /// much in all triangles that share it. A triangle seen edge on has no hit: its
    /// neighbours have.
    ///
    /// *Contact*: an edge or vertex is a hit of all triangles around it.
    ///
    /// *Numerics*: the sign of an edge function is right for the moved corners or
    /// zero, and zero counts as inside. Where all three are zero they are found
    /// exactly. In fixed point the shear has as many bits as a fraction has, so that
    /// the ray is moved sideways by up to a unit in the last place for each unit of
    /// distance.
    ///
    /// *Range*: while products of two coordinates, from the origin of the ray, stay in
    /// the type: 2⁶³ in `f32`, 128 in I16F16. Beyond it may leak.
    ///
    /// *Panics*: never. *Cost*: 15 multiplications, 4 divisions.
    ///
    /// *Source*: S. Woop, C. Benthin, I. Wald, "Watertight Ray/Triangle Intersection",
    /// *JCGT* 2(1), 2013. They turn to double precision where an edge function is
    /// zero, to tell the sides apart; that is not needed to be watertight, only where
    /// all are. t is a mean of the corners' heights, which neither overflows nor leaves
    /// the triangle.
    #[inline]
    #[must_use]
    pub fn hit(&self, triangle: &Triangle<S>, cull: Cull) -> Option<Hit<S>> {
        let [a, b, c] = triangle.points();
        let [a, b, c] = [self.turned(&a), self.turned(&b), self.turned(&c)];
        self.seen(self.turned(&self.ray.origin().to_array()), [a, b, c], &self.limits(cull))
            .into_hit()
    }

    #[inline(always)]
    pub(crate) fn limits(&self, cull: Cull) -> Limits<S> {
        Limits::new(&self.ray, cull)
    }

    /// The coordinates in the order of the frame. By index: which it is, no
    /// branch could foresee.
    #[inline(always)]
    pub(crate) fn turned<T: Copy>(&self, v: &[T; 3]) -> [T; 3] {
        let [x, y, z] = self.turned_lanes(v);
        [*x, *y, *z]
    }

    #[inline(always)]
    pub(crate) fn turned_lanes<'a, T>(&self, v: &'a [T; 3]) -> [&'a T; 3] {
        let [x, y, z] = self.axes;
        [by_index(v, x), by_index(v, y), by_index(v, z)]
    }

    /// The verdict on one triangle, its coordinates turned.
    #[inline(always)]
    pub(crate) fn seen(
        &self,
        origin: [S; 3],
        triangle: [[S; 3]; 3],
        limits: &Limits<S>,
    ) -> Candidate<S> {
        let corners = self.corners(origin, triangle);
        let edges = edge_functions(corners);
        if are_zero(edges) {
            return degenerate_view(corners, self.height, limits);
        }
        self.resolve(corners, edges, limits)
    }

    /// The corners in the frame in which the ray is the z axis. One that two
    /// triangles share has the same coordinates in both.
    #[inline(always)]
    pub(crate) fn corners(&self, origin: [S; 3], [a, b, c]: [[S; 3]; 3]) -> [Triple<S>; 3] {
        let corner = |p: [S; 3]| {
            let [x, y, z] = minus(rounded(p), rounded(origin));
            [x - Rounded(self.shear[0]) * z, y - Rounded(self.shear[1]) * z, z]
        };
        [corner(a), corner(b), corner(c)]
    }

    /// From corners and edge functions to a hit.
    #[inline(always)]
    pub(crate) fn resolve(
        &self,
        [a, b, c]: [Triple<S>; 3],
        [of_a, of_b, of_c]: Triple<S>,
        limits: &Limits<S>,
    ) -> Candidate<S> {
        let zero = Rounded::ZERO;
        let det = of_a + of_b + of_c;
        let front = det > zero;
        let upright = |x: Rounded<S>| Rounded(x.0.flip_sign_by(det.0));
        let (w, u, v) = (upright(of_a), upright(of_b), upright(of_c));
        let det = upright(det);
        let inside = (w >= zero) & (u >= zero) & (v >= zero) & (det > zero) & limits.keep(front);
        let part = |x: Rounded<S>| x.0.plain_div(if inside { det.0 } else { S::ZERO });
        let weights = [part(w), part(u), part(v)];
        // A mean of heights: it can leave neither the triangle nor the type.
        let z = dot(rounded(weights), [a[2], b[2], c[2]]);
        let t = z.0.plain_div(if inside { self.height } else { S::ZERO });
        let zeros = [w == zero, u == zero, v == zero];
        Candidate::new(inside & limits.hold(t), [t, weights[1], weights[2]], front, zeros)
    }
}

/// Twice the areas that the ray spans with the edges bc, ca and ab.
///
/// The two triangles along an edge get numbers that are exact negatives of each
/// other: the same two products, rounded alike, in a difference the other way
/// round. Rounding never changes the order of two products, so the sign is right
/// or zero, and zero is inside. Contraction to a fused multiplication would
/// undo both.
#[inline(always)]
pub(crate) fn edge_functions<S: Scalar>([a, b, c]: [Triple<S>; 3]) -> Triple<S> {
    [c[0] * b[1] - c[1] * b[0], a[0] * c[1] - a[1] * c[0], b[0] * a[1] - b[1] * a[0]]
}

#[inline(always)]
pub(crate) fn are_zero<S: Scalar>([a, b, c]: Triple<S>) -> bool {
    let zero = Rounded::ZERO;
    (a == zero) & (b == zero) & (c == zero)
}
