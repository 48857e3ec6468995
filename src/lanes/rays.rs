use super::hits::minus;
use super::triangles::lane;
use super::{Hits, Ranges};
use crate::published::moller_trumbore::moller_trumbore;
use crate::published::slabs::{Faces, SlabRay, plain_interval};
use crate::published::stored_normal::{NormalTriangle, Stored, store, stored_normal};
use crate::published::{Limits, Triple, resolve, rounded};
use crate::query::{Cull, Facing};
use crate::scalar::Scalar;
use crate::shape::{Aabb, AabbForm, Ray, Triangle};

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

/// N rays prepared for boxes, with an array for each coordinate.
///
/// Use them if many rays descend the same tree, such as the rays of a camera.
///
/// ```
/// use septum::lanes::SlabRays;
/// use septum::published::slabs::SlabRay;
/// use septum::{Aabb, Ray};
///
/// let ray = |y: f32| Ray::new([-1.0, y, 0.5], [1.0, 0.25, 0.125]);
/// let four = [ray(0.0)?, ray(0.5)?, ray(1.0)?, ray(-3.0)?].map(|ray| SlabRay::new(&ray));
/// let cell = Aabb::from_min_max([0.0; 3], [1.0; 3])?;
/// let found = SlabRays::new(&four).t_range_rounded(&cell);
/// assert_eq!(found.mask, [true, true, false, false]);
/// assert_eq!(found.get(0), Some((1.0, 2.0)));
/// # Ok::<(), septum::ShapeError>(())
/// ```
#[derive(Clone, Copy, Debug)]
pub struct SlabRays<S, const N: usize> {
    origin: [[S; N]; 3],
    reciprocal: [[S; N]; 3],
    from: [S; N],
    to: [S; N],
    is_plain: bool,
    rays: [SlabRay<S>; N],
}

impl<S: Scalar, const N: usize> SlabRays<S, N> {
    /// One ray in each lane.
    #[inline]
    #[must_use]
    pub fn new(rays: &[SlabRay<S>; N]) -> Self {
        let (zero, three) = ([S::ZERO; N], [[S::ZERO; N]; 3]);
        let (mut origin, mut reciprocal) = (three, three);
        let (mut from, mut to, mut is_plain) = (zero, zero, true);
        for (k, ray) in rays.iter().enumerate() {
            for i in 0..3 {
                origin[i][k] = ray.origin[i];
                reciprocal[i][k] = ray.reciprocal[i];
            }
            (from[k], to[k]) = (ray.from, ray.to);
            is_plain &= ray.is_plain;
        }
        Self { origin, reciprocal, from, to, is_plain, rays: *rays }
    }

    /// The ray in lane `k`, or `None` if `k` is not below N.
    #[inline]
    #[must_use]
    pub fn get(&self, k: usize) -> Option<&SlabRay<S>> {
        self.rays.get(k)
    }

    /// [`SlabRay::t_range_rounded`] for N rays at once: the same verdicts, the same bits.
    ///
    /// *Panics*: never. *Cost*: in floats and narrow fixed point, one vector of rays costs as much
    /// as one ray. If a component of a direction is zero, the rays are tested one by one.
    #[inline]
    #[must_use]
    pub fn t_range_rounded(&self, aabb: &Aabb<S>) -> Ranges<S, N> {
        match *aabb.form() {
            AabbForm::Corners { min, max } => {
                let (min, max) = (min.to_array(), max.to_array());
                self.t_range_between(|o| (minus(min, o), minus(max, o)))
            }
            AabbForm::Center { center, half } => {
                let (center, half) = (center.to_array(), half.to_array());
                self.t_range_between(|o| {
                    let p = minus(center, o);
                    let plus = |i: usize| p[i].plain_add(half[i]);
                    (minus(p, half), [plus(0), plus(1), plus(2)])
                })
            }
        }
    }

    #[inline(always)]
    fn t_range_between(&self, faces: impl Fn([S; 3]) -> Faces<S>) -> Ranges<S, N> {
        if self.is_plain {
            Ranges::each(|k| {
                let (origin, reciprocal) = (lane(&self.origin, k), lane(&self.reciprocal, k));
                plain_interval(reciprocal, [self.from[k], self.to[k]], &faces(origin))
            })
        } else {
            Ranges::each(|k| self.rays[k].interval(&faces(self.rays[k].origin)))
        }
    }
}
