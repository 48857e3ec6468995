use super::each_exactly::each;
use super::triangle_axes::{OfOneSize, is_for_first};
use super::triangles::lane;
use crate::arithmetic::FirstFloat;
use crate::scalar::Scalar;
use crate::shape::{Aabb, AabbForm, Triangle, Vec3};

/// N boxes of one size by their centres, with an array for each coordinate.
///
/// Use them for cells, blocks and particles, with a [`CellTriangle`]: it computes everything that
/// depends only on triangle and box size once, for all boxes. For a triangle that meets N boxes and
/// no more, [`Aabbs`](super::Aabbs) are as fast.
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
