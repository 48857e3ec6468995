use super::Hits;
use crate::arithmetic::Each;
use crate::published::moller_trumbore::moller_trumbore;
use crate::published::stored_normal::{NormalTriangle, Stored, store, stored_normal};
use crate::published::watertight::{ShearedRay, are_zero, edge_functions};
use crate::published::{Limits, line, resolve, rounded};
use crate::query::Cull;
use crate::scalar::Scalar;
use crate::shape::{Ray, Triangle, Vec3};

/// N triangles for one ray or one box, with an array for each coordinate of each vertex.
///
/// Use them for the leaves of a tree, or for a mesh that is tested whole. The exact
/// [`hit`](Self::hit) gains most in `f32`, and the rounded methods gain more; `docs/speed.md` in
/// the repository has the figures. Both gain less on data outside the cache. N = 8 suits AVX2 and
/// AVX-512, N = 4 suits SSE2, NEON and simd128.
///
/// ```
/// use septum::lanes::Triangles;
/// use septum::{Cull, Ray, Triangle};
///
/// let at = |z: f32| Triangle::new([0.0, 0.0, z], [1.0, 0.0, z], [0.0, 1.0, z]);
/// let four = Triangles::new(&[at(1.0)?, at(-1.0)?, at(0.5)?, at(9.0)?]);
/// let ray = Ray::new([0.25, 0.25, 0.0], [0.0, 0.0, 1.0])?;
///
/// let hits = four.hit_moller_trumbore(&ray, Cull::Nothing);
/// assert_eq!(hits.mask, [true, false, true, true]);
/// let (lane, hit) = hits.nearest().unwrap();
/// assert_eq!((lane, hit.t), (2, 0.5));
/// # Ok::<(), septum::ShapeError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Triangles<S, const N: usize> {
    /// Indexed by vertex, coordinate, lane.
    pub(super) points: [[[S; N]; 3]; 3],
}

impl<S: Scalar, const N: usize> Triangles<S, N> {
    /// One triangle in each lane.
    #[inline]
    #[must_use]
    pub const fn new(triangles: &[Triangle<S>; N]) -> Self {
        Self { points: in_lanes(triangles) }
    }

    /// The triangles of a slice; spare lanes repeat the last triangle. `None` if the slice is empty
    /// or longer than N.
    #[inline]
    #[must_use]
    pub const fn from_slice(triangles: &[Triangle<S>]) -> Option<Self> {
        if triangles.is_empty() || triangles.len() > N {
            return None;
        }
        Some(Self { points: in_lanes(triangles) })
    }

    /// Puts a triangle into lane `k`. Returns `false`, and changes nothing, if `k` is not below N.
    ///
    /// *Panics*: never.
    #[inline]
    #[must_use]
    pub fn set(&mut self, k: usize, triangle: &Triangle<S>) -> bool {
        put(&mut self.points, k, &triangle.points())
    }

    /// The triangle in lane `k`, or `None` if `k` is not below N.
    #[inline]
    #[must_use]
    pub fn get(&self, k: usize) -> Option<Triangle<S>> {
        (k < N).then(|| self.triangle(k))
    }

    #[inline(always)]
    pub(super) fn triangle(&self, k: usize) -> Triangle<S> {
        Triangle::unchecked(self.at(k).each(Vec3::from))
    }

    #[inline(always)]
    pub(super) fn at(&self, k: usize) -> [[S; 3]; 3] {
        let [a, b, c] = &self.points;
        [lane(a, k), lane(b, k), lane(c, k)]
    }
}

/// The vertices of the triangles; spare lanes repeat the last triangle.
#[inline(always)]
const fn in_lanes<S: Scalar, const N: usize>(triangles: &[Triangle<S>]) -> [[[S; N]; 3]; 3] {
    let mut points = [[[S::ZERO; N]; 3]; 3];
    let (mut left, mut k) = (triangles, 0);
    let mut last = &[Vec3::splat(S::ZERO); 3];
    while k < N {
        // Without an index into the slice no panic is linked.
        if let [first, rest @ ..] = left {
            (last, left) = (first.vertices(), rest);
        }
        let mut v = 0;
        while v < 3 {
            let Vec3 { x, y, z } = last[v];
            (points[v][0][k], points[v][1][k], points[v][2][k]) = (x, y, z);
            v += 1;
        }
        k += 1;
    }
    points
}

#[inline(always)]
pub(super) fn lane<S: Copy, const N: usize>([x, y, z]: &[[S; N]; 3], k: usize) -> [S; 3] {
    [x[k], y[k], z[k]]
}

/// Puts vectors into lane `k`. Returns `false`, and changes nothing, if `k` is not below N.
#[inline(always)]
fn put<S: Copy, const N: usize, const V: usize>(
    lanes: &mut [[[S; N]; 3]; V],
    k: usize,
    vectors: &[[S; 3]; V],
) -> bool {
    if k >= N {
        return false;
    }
    for v in 0..V {
        for i in 0..3 {
            lanes[v][i][k] = vectors[v][i];
        }
    }
    true
}

/// N triangles with their normals, for one ray, with an array for each coordinate.
///
/// They are faster than [`Triangles`] if they are queried often and stay in the
/// cache. They are a third larger, and slower if they come from memory.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct NormalTriangles<S, const N: usize> {
    stored: [[[S; N]; 3]; 4],
}

impl<S: Scalar, const N: usize> NormalTriangles<S, N> {
    /// One triangle in each lane.
    #[inline]
    #[must_use]
    pub fn new(triangles: &[NormalTriangle<S>; N]) -> Self {
        let mut all = Self { stored: [[[S::ZERO; N]; 3]; 4] };
        for k in 0..N {
            let _ = all.set(k, &triangles[k]);
        }
        all
    }

    /// Puts a triangle into lane `k`. Returns `false`, and changes nothing, if `k` is not below N.
    ///
    /// *Panics*: never.
    #[inline]
    #[must_use]
    pub fn set(&mut self, k: usize, triangle: &NormalTriangle<S>) -> bool {
        put(&mut self.stored, k, &triangle.stored)
    }

    /// The triangle in lane `k`, or `None` if `k` is not below N.
    #[inline]
    #[must_use]
    pub fn get(&self, k: usize) -> Option<NormalTriangle<S>> {
        (k < N).then(|| NormalTriangle { stored: self.lane(k) })
    }

    #[inline(always)]
    fn lane(&self, k: usize) -> [[S; 3]; 4] {
        let [a, e1, e2, n] = &self.stored;
        [lane(a, k), lane(e1, k), lane(e2, k), lane(n, k)]
    }

    #[inline(always)]
    pub(super) fn at(&self, k: usize) -> Stored<S> {
        self.lane(k).each(rounded)
    }

    /// [`stored_normal::hit`](crate::published::stored_normal::hit) on each of N triangles
    /// at once: the same verdicts, the same bits.
    ///
    /// *Panics*: never. *Cost*: for each vector of triangles, as for one triangle.
    #[inline]
    #[must_use]
    pub fn hit(&self, ray: &Ray<S>, cull: Cull) -> Hits<S, N> {
        let limits = Limits::new(ray, cull);
        let line = line(ray);
        Hits::each(|k| resolve(stored_normal(line, self.at(k)), &limits))
    }
}

impl<S: Scalar, const N: usize> Triangles<S, N> {
    /// [`moller_trumbore::hit`](crate::published::moller_trumbore::hit) on each of N
    /// triangles at once: the same verdicts, the same bits.
    ///
    /// *Panics*: never. *Cost*: for each vector of triangles, as for one triangle.
    #[inline]
    #[must_use]
    pub fn hit_moller_trumbore(&self, ray: &Ray<S>, cull: Cull) -> Hits<S, N> {
        let limits = Limits::new(ray, cull);
        let line = line(ray);
        Hits::each(|k| resolve(moller_trumbore(line, self.at(k)), &limits))
    }

    /// [`volumes::hit`](crate::published::volumes::hit) on each of N triangles at once: the
    /// same verdicts, the same bits.
    ///
    /// *Panics*: never. *Cost*: for each vector of triangles, as for one triangle.
    #[inline]
    #[must_use]
    pub fn hit_volumes(&self, ray: &Ray<S>, cull: Cull) -> Hits<S, N> {
        let limits = Limits::new(ray, cull);
        let line = line(ray);
        Hits::each(|k| resolve(stored_normal(line, store(self.at(k))), &limits))
    }

    /// [`ShearedRay::hit`] on each of N triangles at once: the same verdicts, the same
    /// bits.
    ///
    /// *Panics*: never. *Cost*: for each vector of triangles, as for one triangle.
    #[inline]
    #[must_use]
    pub fn hit_watertight(&self, ray: &ShearedRay<S>, cull: Cull) -> Hits<S, N> {
        let limits = ray.limits(cull);
        let origin = ray.turned(&ray.ray().origin().to_array());
        let [a, b, c] = &self.points;
        let turned = [ray.turned_lanes(a), ray.turned_lanes(b), ray.turned_lanes(c)];
        let at = |k: usize| {
            let [a, b, c] = turned;
            [[a[0][k], a[1][k], a[2][k]], [b[0][k], b[1][k], b[2][k]], [c[0][k], c[1][k], c[2][k]]]
        };
        let mut edge_on = false;
        let hits = Hits::each(|k| {
            let corners = ray.corners(origin, at(k));
            let edges = edge_functions(corners);
            edge_on |= are_zero(edges);
            ray.resolve(corners, edges, &limits)
        });
        if edge_on { Hits::each(|k| ray.seen(origin, at(k), &limits)) } else { hits }
    }
}
