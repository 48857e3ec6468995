use crate::scalar::Scalar;
use crate::shape::{Triangle, Vec3};

/// N triangles, an array for each coordinate of each vertex, for one ray to meet at
/// once.
///
/// Choose it for the leaves of a tree, or for any mesh that is met whole. [`hit`](Self::hit),
/// which is exact, gains most in `f32`, and the rounded methods more (`docs/speed.md` in the
/// repository has the figures); from memory that is not in the cache both gain less. N = 8 fits
/// AVX2 and AVX-512, N = 4 SSE2, NEON and simd128.
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
    pub const fn new(triangles: &[Triangle<S>; N]) -> Self {
        Self { points: in_lanes(triangles) }
    }

    /// The triangles of a slice, and the last of them in all lanes that are left over. `None`
    /// where the slice is empty or longer than N.
    #[inline]
    #[must_use]
    pub const fn from_slice(triangles: &[Triangle<S>]) -> Option<Self> {
        if triangles.is_empty() || triangles.len() > N {
            return None;
        }
        Some(Self { points: in_lanes(triangles) })
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

/// The vertices of the triangles, and of the last one in all lanes that are left over.
#[inline(always)]
const fn in_lanes<S: Scalar, const N: usize>(triangles: &[Triangle<S>]) -> [[[S; N]; 3]; 3] {
    let mut points = [[[S::ZERO; N]; 3]; 3];
    let (mut left, mut k) = (triangles, 0);
    let mut last = &[Vec3::splat(S::ZERO); 3];
    while k < N {
        // No index into the slice: nothing that could panic is linked.
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
