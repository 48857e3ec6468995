use super::triangles::lane;
use crate::published::rounded;
use crate::published::stored_normal::{NormalTriangle, Stored};
use crate::scalar::Scalar;

/// N triangles with their normals, for one ray, with an array for each coordinate.
///
/// They are faster than [`Triangles`](super::Triangles) if they are queried often and stay in the
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
        if k >= N {
            return false;
        }
        for v in 0..4 {
            for i in 0..3 {
                self.stored[v][i][k] = triangle.stored[v][i];
            }
        }
        true
    }

    /// The triangle in lane `k`, or `None` if `k` is not below N.
    #[inline]
    #[must_use]
    pub fn get(&self, k: usize) -> Option<NormalTriangle<S>> {
        let [a, e1, e2, n] = &self.stored;
        (k < N)
            .then(|| NormalTriangle { stored: [lane(a, k), lane(e1, k), lane(e2, k), lane(n, k)] })
    }

    #[inline(always)]
    pub(super) fn at(&self, k: usize) -> Stored<S> {
        let [a, e1, e2, n] = &self.stored;
        [rounded(lane(a, k)), rounded(lane(e1, k)), rounded(lane(e2, k)), rounded(lane(n, k))]
    }
}
