//! Ray and triangle, so that no ray slips between two triangles.

use core::cmp::Ordering;

use super::{Limits, Triple, by_index, rounded};
use crate::arithmetic::{Each, Number, Rounded, dot3, minus3, pick, turn};
use crate::query::{Candidate, Cull, Hit};
use crate::robust::ExactSum;
use crate::scalar::Scalar;
use crate::shape::{Ray, Triangle};

/// A ray prepared for the watertight test, with a shear that aligns it with its longest coordinate.
///
/// ```
/// use septum::published::watertight::ShearedRay;
/// use septum::{Cull, Ray, Triangle};
///
/// // The ray goes through the edge that the two triangles share: it hits at least one.
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
    /// The direction's z component.
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
        // Negative magnitudes, because the least number has no positive one.
        let below = |x: S| if x > S::ZERO { S::ZERO.plain_sub(x) } else { x };
        let [x, y, z] = [below(d[0]), below(d[1]), below(d[2])];
        let longest = if z <= x && z <= y { 2 } else { usize::from(y <= x) };
        let (kz, mut kx, mut ky) = turn(longest);
        let height = *pick(&d, kz);
        // Seen from the opposite end, left is right.
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

    /// Where does the ray cross the triangle? In the scalar's own arithmetic, and so that no ray
    /// slips between two triangles: watertight, but not exact.
    ///
    /// Choose it where a closed mesh must not leak and a verdict that is wrong by a rounding does
    /// no harm, above all for eight triangles at once, by [`Triangles`](crate::lanes::Triangles).
    /// One by one, [`Ray::hit`] takes less time; it is exact and watertight too.
    ///
    /// *Geometry*: both sides count unless `cull` excludes one; t is in the ray's range. The test
    /// decides for a ray and corners that are moved by a rounding, and a corner moves alike in all
    /// triangles that share it. A triangle seen edge on has no hit; its neighbours have.
    ///
    /// *Contact*: an edge or vertex is a hit of all triangles around it.
    ///
    /// *Numerics*: the sign of an edge function is right for the moved corners, or the function is
    /// zero, which counts as inside. If all three are zero, their signs are computed exactly. In
    /// fixed point the shear has the bits of a fraction, so the ray moves sideways by up to a unit
    /// in the last place for each unit of distance.
    ///
    /// *Range*: coordinates relative to the ray's origin whose products stay within the type, so up
    /// to 2⁶³ in `f32` and 128 in I16F16. Outside it may leak.
    ///
    /// *Panics*: never. *Cost*: 15 multiplications, 4 divisions.
    ///
    /// *Source*: S. Woop, C. Benthin, I. Wald, "Watertight Ray/Triangle Intersection", *JCGT* 2(1),
    /// 2013. They turn to double precision when an edge function is zero, to decide the side.
    /// Watertightness does not need that, unless all three are zero. Our t is a mean of the
    /// corners' heights, which neither overflows nor leaves the triangle.
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

    /// The coordinates in the order of the frame, by index, because a branch on the order would be
    /// unpredictable.
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

    /// The verdict on one triangle, with its coordinates in the order of the frame.
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

    /// The corners in the frame whose z axis is the ray. A corner that two triangles share has the
    /// same coordinates in both.
    #[inline(always)]
    pub(crate) fn corners(&self, origin: [S; 3], [a, b, c]: [[S; 3]; 3]) -> [Triple<S>; 3] {
        let corner = |p: [S; 3]| {
            let [x, y, z] = minus3(&rounded(p), &rounded(origin));
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
        // A mean of heights stays within the triangle and the type.
        let z = dot3(&rounded(weights), &[a[2], b[2], c[2]]);
        let t = z.0.plain_div(if inside { self.height } else { S::ZERO });
        let zeros = [w == zero, u == zero, v == zero];
        Candidate::new(inside & limits.hold(t), [t, weights[1], weights[2]], front, zeros)
    }
}

/// Twice the areas that the ray spans with the edges bc, ca and ab.
///
/// The two triangles along an edge get exact negatives of each other, from the same two rounded
/// products in a difference the other way round. Rounding keeps the order of two products, so the
/// sign is right or zero, and zero is inside. Contraction to a fused multiplication would destroy
/// both properties.
#[inline(always)]
pub(crate) fn edge_functions<S: Scalar>([a, b, c]: [Triple<S>; 3]) -> Triple<S> {
    [c[0] * b[1] - c[1] * b[0], a[0] * c[1] - a[1] * c[0], b[0] * a[1] - b[1] * a[0]]
}

#[inline(always)]
pub(crate) fn are_zero<S: Scalar>([a, b, c]: Triple<S>) -> bool {
    let zero = Rounded::ZERO;
    (a == zero) & (b == zero) & (c == zero)
}

/// The verdict on a triangle that the ray sees so nearly edge on that rounding erased its area.
///
/// The signs of the edge functions are computed exactly. If they agree, the triangle seen from the
/// ray is its longest side, within rounding, and the ray crosses that side.
#[cold]
#[inline(never)]
pub(super) fn degenerate_view<S: Scalar>(
    corners: [Triple<S>; 3],
    height: S,
    limits: &Limits<S>,
) -> Candidate<S> {
    let [a, b, c] = corners;
    let signs = [edge(c, b), edge(a, c), edge(b, a)];
    let front = signs.contains(&Ordering::Greater);
    let one_sided = front != signs.contains(&Ordering::Less);
    let (weights, z) = along_longest(corners);
    let t = z.0.plain_div(height);
    let hit = one_sided && limits.keep(front) && limits.hold(t);
    Candidate::new(hit, [t, weights[1].0, weights[2].0], front, signs.each(Ordering::is_eq))
}

/// The sign of p.x·q.y − p.y·q.x.
fn edge<S: Scalar>(p: Triple<S>, q: Triple<S>) -> Ordering {
    let mut sum = S::SeptumSum::new();
    sum.add(&[p[0].0.parts(), q[1].0.parts()]);
    sum.add(&[p[1].0.parts().negated(), q[0].0.parts()]);
    sum.sign()
}

/// The point of the longest side, as seen, that is nearest to the z axis: its weights of the three
/// corners, and its height.
fn along_longest<S: Scalar>(corners: [Triple<S>; 3]) -> (Triple<S>, Rounded<S>) {
    let (mut from, mut to, mut axis) = (0, 1, 0);
    let mut longest = Rounded::ZERO;
    for (p, q) in [(0, 1), (1, 2), (2, 0)] {
        for i in 0..2 {
            let length = (corners[q][i] - corners[p][i]).magnitude();
            if length > longest {
                (from, to, axis, longest) = (p, q, i, length);
            }
        }
    }
    let (p, q) = (corners[from], corners[to]);
    let one = Rounded(S::plain_one());
    let share = Rounded((-p[axis]).0.plain_div((q[axis] - p[axis]).0));
    let share = if share > Rounded::ZERO { share } else { Rounded::ZERO };
    let share = if share < one { share } else { one };
    let mut weights = [Rounded::ZERO; 3];
    weights[to] = share;
    weights[from] = one - share;
    (weights, p[2] + share * (q[2] - p[2]))
}
