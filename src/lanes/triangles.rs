use crate::linear::Vec3;
use crate::scalar::Scalar;
use crate::shape::Triangle;

/// N triangles, an array for each coordinate of each vertex, for one ray to meet at
/// once.
///
/// Choose it for the leaves of a tree, or for any mesh that is met whole: with N = 8
/// and AVX-512, `f32` takes 0.07 of the time of
/// [`hit_moller_trumbore`](crate::Ray::hit_moller_trumbore) one by one for each triangle, 0.09
/// watertight, 0.20 exact, where half of the rays hit; 0.12, 0.16 and 0.35 where a tenth
/// do. [`hit_each`](crate::Ray::hit_each), which is exact, takes 0.3 of the time of
/// [`hit`](crate::Ray::hit), in I16F16 too. That is in the cache: from memory it takes up to
/// twice as long.
/// N = 4 fits SSE2, NEON and simd128. Fill up with any triangle twice, or with one of
/// three equal vertices, which no ray hits.
///
/// ```
/// use septum::{Cull, Ray, Triangle, Triangles};
///
/// let at = |z: f32| Triangle::new([0.0, 0.0, z], [1.0, 0.0, z], [0.0, 1.0, z]);
/// let four = Triangles::new(&[at(1.0)?, at(-1.0)?, at(0.5)?, at(9.0)?]);
/// let ray = Ray::new([0.25, 0.25, 0.0], [0.0, 0.0, 1.0])?;
///
/// let hits = ray.hit_each_moller_trumbore(&four, Cull::Nothing);
/// assert_eq!(hits.mask, [true, false, true, true]);
/// let (lane, hit) = hits.nearest().unwrap();
/// assert_eq!((lane, hit.t), (2, 0.5));
/// # Ok::<(), septum::ShapeError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Triangles<S, const N: usize> {
    /// By vertex, coordinate, lane.
    pub(super) points: [[[S; N]; 3]; 3],
}

impl<S: Scalar, const N: usize> Triangles<S, N> {
    /// The triangles, each in its lane.
    #[inline]
    pub fn new(triangles: &[Triangle<S>; N]) -> Self {
        let mut all = Self { points: [[[S::ZERO; N]; 3]; 3] };
        for k in 0..N {
            all.set(k, &triangles[k]);
        }
        all
    }

    /// Puts a triangle into lane `k`.
    ///
    /// *Panics*: where there is no lane `k`, as an array does.
    #[inline]
    pub fn set(&mut self, k: usize, triangle: &Triangle<S>) {
        let points = triangle.points();
        for v in 0..3 {
            for i in 0..3 {
                self.points[v][i][k] = points[v][i];
            }
        }
    }

    /// The triangle in lane `k`, if there is that lane.
    #[inline]
    pub fn get(&self, k: usize) -> Option<Triangle<S>> {
        (k < N).then(|| Triangle::from_rounded(self.at(k).map(Vec3::from)))
    }

    #[inline(always)]
    pub(super) fn at(&self, k: usize) -> [[S; 3]; 3] {
        let [a, b, c] = &self.points;
        [lane(a, k), lane(b, k), lane(c, k)]
    }
}

#[inline(always)]
pub(super) fn lane<S: Copy, const N: usize>([x, y, z]: &[[S; N]; 3], k: usize) -> [S; 3] {
    [x[k], y[k], z[k]]
}
