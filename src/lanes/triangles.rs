use crate::scalar::Scalar;
use crate::shape::{Triangle, Vec3};

/// N triangles, an array for each coordinate of each vertex, for one ray to meet at
/// once.
///
/// Choose it for the leaves of a tree, or for any mesh that is met whole. With N = 8 and
/// AVX-512 [`hit`](Self::hit), which is exact, takes a third of the time of
/// [`Ray::hit`](crate::Ray::hit) for each triangle in `f32`, `f64` and I16F16; the rounded
/// methods take about a tenth of theirs in `f32`. That is in the cache: from memory it
/// takes up to twice as long. N = 4 fits SSE2, NEON and simd128. Fill up with any triangle
/// twice, or with one of three equal vertices, which no ray hits.
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
    /// By vertex, coordinate, lane.
    pub(super) points: [[[S; N]; 3]; 3],
}

impl<S: Scalar, const N: usize> Triangles<S, N> {
    /// The triangles, each in its lane.
    #[inline]
    #[must_use]
    pub fn new(triangles: &[Triangle<S>; N]) -> Self {
        let mut all = Self { points: [[[S::ZERO; N]; 3]; 3] };
        for k in 0..N {
            let _ = all.set(k, &triangles[k]);
        }
        all
    }

    /// Puts a triangle into lane `k`, and says whether there is that lane. Without it nothing
    /// changes.
    ///
    /// *Panics*: never.
    #[inline]
    #[must_use]
    pub fn set(&mut self, k: usize, triangle: &Triangle<S>) -> bool {
        if k >= N {
            return false;
        }
        let points = triangle.points();
        for v in 0..3 {
            for i in 0..3 {
                self.points[v][i][k] = points[v][i];
            }
        }
        true
    }

    /// The triangle in lane `k`, if there is that lane.
    #[inline]
    #[must_use]
    pub fn get(&self, k: usize) -> Option<Triangle<S>> {
        (k < N).then(|| self.triangle(k))
    }

    #[inline(always)]
    pub(super) fn triangle(&self, k: usize) -> Triangle<S> {
        Triangle::unchecked(self.at(k).map(Vec3::from))
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
