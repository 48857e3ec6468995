use super::Hits;
use super::triangles::lane;
use crate::published::moller_trumbore::moller_trumbore;
use crate::published::stored_normal::{NormalTriangle, Stored, store, stored_normal};
use crate::published::{Limits, Triple, resolve, rounded};
use crate::query::{Cull, Facing};
use crate::scalar::Scalar;
use crate::shape::{Ray, Triangle};

/// N rays for one triangle, with an array for each coordinate.
///
/// Use them if many rays meet the same triangles, such as the rays of a camera.
/// [`hit_stored_normal`](Self::hit_stored_normal) is the fastest.
///
/// ```
/// use septum::lanes::Rays;
/// use septum::{Cull, Ray, Triangle};
///
/// let floor = Triangle::new([0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0])?;
/// let down = |x: f32| Ray::new([x, 0.25, 1.0], [0.0, 0.0, -1.0]);
/// let four = Rays::new(&[down(0.25)?, down(0.5)?, down(0.75)?, down(1.0)?]);
/// assert_eq!(four.hit_volumes(&floor, Cull::Nothing).mask, [true, true, true, false]);
/// # Ok::<(), septum::ShapeError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Rays<S, const N: usize> {
    pub(super) origin: [[S; N]; 3],
    pub(super) direction: [[S; N]; 3],
    t_min: [S; N],
    t_max: [S; N],
    /// Whether the range of t is unbounded below, and above.
    open: [[bool; N]; 2],
}

impl<S: Scalar, const N: usize> Rays<S, N> {
    /// One ray in each lane.
    #[inline]
    #[must_use]
    pub fn new(rays: &[Ray<S>; N]) -> Self {
        let (zero, three) = ([S::ZERO; N], [[S::ZERO; N]; 3]);
        let mut all = Self {
            origin: three,
            direction: three,
            t_min: zero,
            t_max: zero,
            open: [[false; N]; 2],
        };
        for k in 0..N {
            let _ = all.set(k, &rays[k]);
        }
        all
    }

    /// Puts a ray into lane `k`. Returns `false`, and changes nothing, if `k` is not below N.
    ///
    /// *Panics*: never.
    #[inline]
    #[must_use]
    pub fn set(&mut self, k: usize, ray: &Ray<S>) -> bool {
        if k >= N {
            return false;
        }
        let (origin, direction) = (ray.origin().to_array(), ray.direction().to_array());
        for i in 0..3 {
            self.origin[i][k] = origin[i];
            self.direction[i][k] = direction[i];
        }
        let limits = Limits::new(ray, Cull::Nothing);
        (self.t_min[k], self.t_max[k]) = (limits.t_min, limits.t_max);
        (self.open[0][k], self.open[1][k]) = (limits.open[0], limits.open[1]);
        true
    }

    /// The ray in lane `k`, or `None` if `k` is not below N.
    #[inline]
    #[must_use]
    pub fn get(&self, k: usize) -> Option<Ray<S>> {
        if k >= N {
            return None;
        }
        let end = |open: bool, t: S| if open { None } else { Some(t) };
        Ray::new(lane(&self.origin, k), lane(&self.direction, k))
            .and_then(|ray| {
                ray.with_range(
                    end(self.open[0][k], self.t_min[k]),
                    end(self.open[1][k], self.t_max[k]),
                )
            })
            .ok()
    }

    #[inline(always)]
    pub(super) fn at(&self, k: usize) -> (Triple<S>, Triple<S>) {
        (rounded(lane(&self.origin, k)), rounded(lane(&self.direction, k)))
    }

    /// The limits on t in lane `k`, with culling of front and back faces as in `all`.
    #[inline(always)]
    pub(super) fn limits(&self, k: usize, all: (bool, bool)) -> Limits<S> {
        Limits {
            t_min: self.t_min[k],
            t_max: self.t_max[k],
            open: [self.open[0][k], self.open[1][k]],
            front: all.0,
            back: all.1,
        }
    }
}

impl<S: Scalar, const N: usize> Rays<S, N> {
    /// [`moller_trumbore::hit`](crate::published::moller_trumbore::hit) for N rays at once: the
    /// same verdicts, the same bits.
    ///
    /// *Panics*: never. *Cost*: for each vector of rays, as for one ray.
    #[inline]
    #[must_use]
    pub fn hit_moller_trumbore(&self, triangle: &Triangle<S>, cull: Cull) -> Hits<S, N> {
        let keeps = (cull.keeps(Facing::Front), cull.keeps(Facing::Back));
        let triangle = triangle.points();
        Hits::each(|k| resolve(moller_trumbore(self.at(k), triangle), &self.limits(k, keeps)))
    }

    /// [`stored_normal::hit`](crate::published::stored_normal::hit) for N rays at once: the
    /// same verdicts, the same bits.
    ///
    /// *Panics*: never. *Cost*: for each vector of rays, as for one ray.
    #[inline]
    #[must_use]
    pub fn hit_stored_normal(&self, triangle: &NormalTriangle<S>, cull: Cull) -> Hits<S, N> {
        self.hit_stored(triangle.rounded(), cull)
    }

    /// [`volumes::hit`](crate::published::volumes::hit) for N rays at once: the same
    /// verdicts, the same bits.
    ///
    /// *Panics*: never. *Cost*: for each vector of rays, as for one ray.
    #[inline]
    #[must_use]
    pub fn hit_volumes(&self, triangle: &Triangle<S>, cull: Cull) -> Hits<S, N> {
        self.hit_stored(store(triangle.points()), cull)
    }

    #[inline(always)]
    fn hit_stored(&self, triangle: Stored<S>, cull: Cull) -> Hits<S, N> {
        let keeps = (cull.keeps(Facing::Front), cull.keeps(Facing::Back));
        Hits::each(|k| resolve(stored_normal(self.at(k), triangle), &self.limits(k, keeps)))
    }
}
