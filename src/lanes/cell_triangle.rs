use super::Cells;
use super::each_overlap::each;
use super::triangle_axes::OfOneSize;
use super::triangles::lane;
use crate::arithmetic::FirstFloat;
use crate::scalar::Scalar;
use crate::shape::Triangle;

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
    prepared: Option<OfOneSize<<S as FirstFloat>::SeptumFirst>>,
}

impl<S: Scalar> CellTriangle<S> {
    /// Prepares a triangle for boxes of the size of `cells`.
    ///
    /// *Panics*: never. *Cost*: 34 multiplications.
    #[inline]
    #[must_use]
    pub fn new<const N: usize>(triangle: &Triangle<S>, cells: &Cells<S, N>) -> Self {
        let half = cells.half;
        let prepared =
            if S::IN_QUADS { OfOneSize::new::<S>(triangle.points(), half) } else { None };
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
        match &self.prepared {
            Some(prepared) if cells.half == self.half => {
                each::<S, N>(|k| prepared.apart::<S>(lane(&cells.centers, k)), alone)
            }
            _ => core::array::from_fn(alone),
        }
    }
}
