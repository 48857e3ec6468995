use super::Ranges;
use super::each_exactly::each;
use super::hits::minus;
use super::triangle_axes::{OfOneSize, is_for_first};
use super::triangles::lane;
use crate::arithmetic::FirstFloat;
use crate::published::slabs::SlabRay;
use crate::scalar::Scalar;
use crate::shape::{Aabb, AabbForm, Triangle, Vec3};

/// N boxes by their corners, with an array for each coordinate.
///
/// ```
/// use septum::lanes::Aabbs;
/// use septum::published::slabs::SlabRay;
/// use septum::{Aabb, Ray};
///
/// let cell = |x: f32| Aabb::from_min_max([x, 0.0, 0.0], [x + 1.0, 1.0, 1.0]);
/// let cells = Aabbs::new(&[cell(0.0)?, cell(2.0)?, cell(-3.0)?, cell(4.0)?]).unwrap();
/// let ray = SlabRay::new(&Ray::new([-1.0, 0.5, 0.5], [1.0, 0.0, 0.0])?);
/// let found = cells.t_range_rounded(&ray);
/// assert_eq!(found.mask, [true, true, false, true]);
/// assert_eq!(found.get(1), Some((3.0, 4.0)));
/// # Ok::<(), septum::ShapeError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Aabbs<S, const N: usize> {
    pub(super) min: [[S; N]; 3],
    pub(super) max: [[S; N]; 3],
}

impl<S: Scalar, const N: usize> Aabbs<S, N> {
    /// One box in each lane. `None` if a box was given by its centre: its corners may lie between
    /// two numbers of the scalar.
    #[inline]
    #[must_use]
    pub const fn new(aabbs: &[Aabb<S>; N]) -> Option<Self> {
        Self::from_slice(aabbs)
    }

    /// The boxes of a slice; spare lanes repeat the last box. `None` if the slice is empty or
    /// longer than N, or if a box was given by its centre.
    ///
    /// With it, a list of any length goes through lanes chunk by chunk. It is `const`, for tables
    /// in flash.
    ///
    /// ```
    /// use septum::lanes::Aabbs;
    /// use septum::{Aabb, Triangle};
    ///
    /// let cells: Vec<_> = (0..11)
    ///     .map(|k| Aabb::from_min_max([k as f32, 0.0, 0.0], [k as f32 + 1.0, 1.0, 1.0]))
    ///     .collect::<Result<_, _>>()?;
    /// let triangle = Triangle::new([6.5, 0.5, 0.2], [9.5, 0.5, 0.2], [6.5, 0.8, 0.2])?;
    /// let mut met = Vec::new();
    /// for chunk in cells.chunks(8) {
    ///     let Some(eight) = Aabbs::<_, 8>::from_slice(chunk) else { continue };
    ///     met.extend_from_slice(&eight.overlaps(&triangle)[..chunk.len()]);
    /// }
    /// let first_and_last = (met.iter().position(|&x| x), met.iter().rposition(|&x| x));
    /// assert_eq!(first_and_last, (Some(6), Some(9)));
    /// # Ok::<(), septum::ShapeError>(())
    /// ```
    #[inline]
    #[must_use]
    pub const fn from_slice(aabbs: &[Aabb<S>]) -> Option<Self> {
        let mut all = Self { min: [[S::ZERO; N]; 3], max: [[S::ZERO; N]; 3] };
        let (mut left, mut k) = (aabbs, 0);
        let mut last = None;
        while k < N {
            // Without an index into the slice no panic is linked.
            if let [first, rest @ ..] = left {
                (last, left) = (first.given_corners(), rest);
            }
            let Some((min, max)) = last else { return None };
            (all.min[0][k], all.min[1][k], all.min[2][k]) = (min.x, min.y, min.z);
            (all.max[0][k], all.max[1][k], all.max[2][k]) = (max.x, max.y, max.z);
            k += 1;
        }
        if left.is_empty() { Some(all) } else { None }
    }

    /// The box in lane `k`, or `None` if `k` is not below N.
    #[inline]
    #[must_use]
    pub fn get(&self, k: usize) -> Option<Aabb<S>> {
        (k < N).then(|| self.at(k))
    }

    #[inline(always)]
    pub(super) fn at(&self, k: usize) -> Aabb<S> {
        Aabb::between(lane(&self.min, k).into(), lane(&self.max, k).into())
    }

    /// The rounded entry and exit of a prepared ray on each of N boxes:
    /// [`SlabRay::t_range_rounded`] at once.
    ///
    /// *Numerics*: the same bits as for single boxes.
    ///
    /// *Panics*: never. *Cost*: in floats and narrow fixed point, one vector of boxes costs as much
    /// as one box. If a component of the direction is zero, the boxes are tested one by one.
    #[inline]
    #[must_use]
    pub fn t_range_rounded(&self, ray: &SlabRay<S>) -> Ranges<S, N> {
        let o = ray.origin;
        let faces = |k: usize| {
            let (min, max) = (lane(&self.min, k), lane(&self.max, k));
            (minus(min, o), minus(max, o))
        };
        if ray.is_plain {
            Ranges::each(|k| ray.plain_interval(&faces(k)))
        } else {
            Ranges::each(|k| ray.interval(&faces(k)))
        }
    }
}

/// N boxes of one size by their centres, with an array for each coordinate.
///
/// Use them for cells, blocks and particles, with a [`CellTriangle`]: it computes everything that
/// depends only on triangle and box size once, for all boxes. For a triangle that meets N boxes and
/// no more, [`Aabbs`] are as fast.
///
/// ```
/// use septum::lanes::Cells;
/// use septum::{Aabb, Triangle};
///
/// let cell = |x: f32| Aabb::from_center_half_extents([x + 0.5, 0.5, 0.5], [0.5; 3]);
/// let cells = Cells::new(&[cell(0.0)?, cell(1.0)?, cell(2.0)?, cell(3.0)?]).unwrap();
/// let triangle = Triangle::new([0.5, 0.5, 0.2], [2.0, 0.5, 0.2], [0.5, 3.5, 0.2])?;
/// assert_eq!(cells.overlaps(&triangle), [true, true, true, false]);
/// # Ok::<(), septum::ShapeError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Cells<S, const N: usize> {
    pub(super) centers: [[S; N]; 3],
    pub(super) half: [S; 3],
}

impl<S: Scalar, const N: usize> Cells<S, N> {
    /// One box in each lane. `None` if half-extents differ, or if a box was given by its corners:
    /// its centre may lie between two numbers of the scalar.
    #[inline]
    #[must_use]
    pub fn new(aabbs: &[Aabb<S>; N]) -> Option<Self> {
        Self::from_slice(aabbs)
    }

    /// The boxes of a slice; spare lanes repeat the last box. `None` if the slice is empty or
    /// longer than N, if half-extents differ, or if a box was given by its corners.
    ///
    /// *Panics*: never.
    #[inline]
    #[must_use]
    pub fn from_slice(aabbs: &[Aabb<S>]) -> Option<Self> {
        let by_center = |aabb: &Aabb<S>| match *aabb.form() {
            AabbForm::Center { center, half } => Some((center, half)),
            AabbForm::Corners { .. } => None,
        };
        let (mut last, half) = by_center(aabbs.first()?)?;
        let mut centers = [[S::ZERO; N]; 3];
        let mut left = aabbs.iter();
        for k in 0..N {
            if let Some(aabb) = left.next() {
                let (center, size) = by_center(aabb)?;
                if size != half {
                    return None;
                }
                last = center;
            }
            for (row, x) in centers.iter_mut().zip(last.to_array()) {
                row[k] = x;
            }
        }
        left.next().is_none().then_some(Self { centers, half: half.to_array() })
    }

    /// The box in lane `k`, or `None` if `k` is not below N.
    #[inline]
    #[must_use]
    pub fn get(&self, k: usize) -> Option<Aabb<S>> {
        (k < N).then(|| self.at(k))
    }

    #[inline(always)]
    pub(super) fn at(&self, k: usize) -> Aabb<S> {
        Aabb::around(lane(&self.centers, k).into(), Vec3::from(self.half))
    }

    /// [`Triangle::overlaps`](crate::Overlaps::overlaps) with each of N boxes at once.
    ///
    /// *Contact*, *Numerics*, *Range*, *Panics*: as [`Aabbs::overlaps`](super::Aabbs::overlaps).
    ///
    /// *Cost*: as [`CellTriangle::new`] plus one [`CellTriangle::overlaps`].
    #[inline]
    #[must_use]
    pub fn overlaps(&self, triangle: &Triangle<S>) -> [bool; N] {
        CellTriangle::new(triangle, self).overlaps(self)
    }
}

/// A triangle prepared for many boxes of one size.
///
/// Use it for a triangle that is tested against several [`Cells`].
///
/// ```
/// use septum::lanes::{CellTriangle, Cells};
/// use septum::{Aabb, Triangle};
///
/// let cell = |x: f32| Aabb::from_center_half_extents([x + 0.5, 0.5, 0.5], [0.5; 3]);
/// let left = Cells::new(&[cell(0.0)?, cell(1.0)?]).unwrap();
/// let right = Cells::new(&[cell(2.0)?, cell(3.0)?]).unwrap();
/// let triangle = Triangle::new([0.5, 0.5, 0.2], [2.0, 0.5, 0.2], [0.5, 3.5, 0.2])?;
/// let prepared = CellTriangle::new(&triangle, &left);
/// assert_eq!(prepared.overlaps(&left), [true, true]);
/// assert_eq!(prepared.overlaps(&right), [true, false]);
/// # Ok::<(), septum::ShapeError>(())
/// ```
#[derive(Clone, Copy, Debug)]
pub struct CellTriangle<S: Scalar> {
    triangle: Triangle<S>,
    half: [S; 3],
    prepared: Option<Prepared<S>>,
}

/// What is the same for all boxes, in the float that holds the triangle.
#[derive(Clone, Copy, Debug)]
enum Prepared<S: FirstFloat> {
    First(OfOneSize<S::SeptumFirst>),
    Second(OfOneSize<S::SeptumSecond>),
}

impl<S: Scalar> CellTriangle<S> {
    /// Prepares a triangle for boxes of the size of `cells`.
    ///
    /// *Panics*: never. *Cost*: 34 multiplications.
    #[inline]
    #[must_use]
    pub fn new<const N: usize>(triangle: &Triangle<S>, cells: &Cells<S, N>) -> Self {
        let half = cells.half;
        let points = triangle.points();
        let prepared = if !S::IN_QUADS {
            None
        } else if is_for_first(&points) {
            OfOneSize::new(points, half).map(Prepared::First)
        } else {
            OfOneSize::new(points, half).map(Prepared::Second)
        };
        Self { triangle: *triangle, half, prepared }
    }

    /// The triangle.
    #[inline]
    #[must_use]
    pub const fn triangle(&self) -> &Triangle<S> {
        &self.triangle
    }

    /// [`Triangle::overlaps`](crate::Overlaps::overlaps) with each of N boxes at once.
    ///
    /// *Contact*, *Numerics*, *Range*, *Panics*: as [`Aabbs::overlaps`](super::Aabbs::overlaps).
    /// Boxes of a size other than the prepared one get the same exact answers, but one by one.
    ///
    /// *Cost*: 21 multiplications for a vector of boxes.
    #[inline]
    #[must_use]
    pub fn overlaps<const N: usize>(&self, cells: &Cells<S, N>) -> [bool; N] {
        let alone = |k: usize| self.triangle.overlaps(&cells.at(k));
        let center = |k: usize| lane(&cells.centers, k);
        match &self.prepared {
            Some(Prepared::First(prepared)) if cells.half == self.half => {
                each::<S, N>(|k| prepared.apart(center(k)), alone)
            }
            Some(Prepared::Second(prepared)) if cells.half == self.half => {
                each::<S, N>(|k| prepared.apart(center(k)), alone)
            }
            _ => core::array::from_fn(alone),
        }
    }
}
