use super::Ranges;
use super::hits::minus;
use super::triangles::lane;
use crate::published::slabs::{Faces, SlabRay, plain_interval};
use crate::scalar::Scalar;
use crate::shape::{Aabb, AabbForm};

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
