use super::Ranges;
use super::ranges::minus;
use super::triangles::lane;
use crate::query::SlabRay;
use crate::scalar::Scalar;
use crate::shape::Aabb;

/// N boxes by their corners, an array for each coordinate.
///
/// ```
/// use septum::{Aabb, Aabbs, Ray};
///
/// let cell = |x: f32| Aabb::from_min_max([x, 0.0, 0.0], [x + 1.0, 1.0, 1.0]);
/// let cells = Aabbs::new(&[cell(0.0)?, cell(2.0)?, cell(-3.0)?, cell(4.0)?]).unwrap();
/// let ray = Ray::new([-1.0, 0.5, 0.5], [1.0, 0.0, 0.0])?.for_slabs();
/// let found = ray.t_range_each_rounded(&cells);
/// assert_eq!(found.mask, [true, true, false, true]);
/// assert_eq!(found.get(1), Some((3.0, 4.0)));
/// # Ok::<(), septum::ShapeError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Aabbs<S, const N: usize> {
    min: [[S; N]; 3],
    max: [[S; N]; 3],
}

impl<S: Scalar, const N: usize> Aabbs<S, N> {
    /// The boxes, each in its lane. `None` where one was given by its centre: its
    /// corners need not be numbers of the scalar.
    #[inline]
    pub fn new(aabbs: &[Aabb<S>; N]) -> Option<Self> {
        let mut all = Self { min: [[S::ZERO; N]; 3], max: [[S::ZERO; N]; 3] };
        for k in 0..N {
            let (min, max) = aabbs[k].min_max()?;
            let (min, max) = (min.to_array(), max.to_array());
            for i in 0..3 {
                all.min[i][k] = min[i];
                all.max[i][k] = max[i];
            }
        }
        Some(all)
    }

    /// The box in lane `k`, if there is that lane.
    #[inline]
    pub fn get(&self, k: usize) -> Option<Aabb<S>> {
        if k >= N {
            return None;
        }
        Aabb::from_min_max(lane(&self.min, k), lane(&self.max, k)).ok()
    }
}

impl<S: Scalar> SlabRay<S> {
    /// [`t_range_rounded`](Self::t_range_rounded) on each of N boxes.
    ///
    /// *Numerics*: the same bits as one by one.
    ///
    /// *Panics*: never. *Cost*: that of one for a vector of them, in floats and
    /// narrow fixed point. Where a component of the direction is nought, the boxes
    /// go one by one.
    #[inline]
    pub fn t_range_each_rounded<const N: usize>(&self, aabbs: &Aabbs<S, N>) -> Ranges<S, N> {
        let o = self.origin;
        let faces = |k: usize| {
            let (min, max) = (lane(&aabbs.min, k), lane(&aabbs.max, k));
            (minus(min, o), minus(max, o))
        };
        if self.is_plain {
            Ranges::each(|k| self.plain_interval(&faces(k)))
        } else {
            Ranges::each(|k| self.interval(&faces(k)))
        }
    }
}
