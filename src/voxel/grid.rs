use core::cmp::Ordering;
use core::fmt;
use core::ops::Range;

use super::place::Level;
use super::sign::middle;
use crate::arithmetic::{Each, compare, greatest, three};
use crate::scalar::{PlanesError, Scalar};
use crate::shape::{Aabb, Vec3};

/// A grid of voxels of one size: the frame of every voxelization.
///
/// *Geometry*: the planes of the grid are numbers of the scalar. On each axis plane k is
/// `origin + k·cell`, where floats round the product and the sum, and fixed point rounds
/// nothing. Voxel (i, j, k) is the box between planes i and i + 1, j and j + 1, k and k + 1;
/// [`voxel`](Self::voxel) returns it. Every answer of this module is about these boxes.
///
/// A [`part`](Self::part) of a grid is a grid and keeps the planes of the whole. Every answer
/// about a part is the answer about the whole, restricted to the part.
///
/// ```
/// use septum::voxel::{Grid, GridError};
/// use septum::Vec3;
///
/// let grid = Grid::new([-1.0, -1.0, 0.0], [0.5; 3], [4, 4, 2])?;
/// let (min, max) = grid.voxel([3, 0, 1]).unwrap().min_max().unwrap();
/// assert_eq!((min, max), (Vec3::new(0.5, -1.0, 0.5), Vec3::new(1.0, -0.5, 1.0)));
/// assert_eq!(grid.voxel([4, 0, 1]), None);
///
/// let slab = grid.part([0..4, 0..4, 1..2]).unwrap();
/// assert_eq!(slab.voxel([3, 0, 0]), grid.voxel([3, 0, 1]));
/// # Ok::<(), GridError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Grid<S> {
    origin: Vec3<S>,
    cell: Vec3<S>,
    /// The number of the first plane on each axis.
    first: [u32; 3],
    resolution: [u32; 3],
    /// The reciprocal of the cell, and the greatest distance between a plane and its place, in
    /// cells.
    per_cell: [f64; 3],
    deviation: [f64; 3],
}

impl<S: Scalar> Grid<S> {
    /// The most voxels along an axis.
    pub const MOST: u32 = 1 << 30;

    /// Makes the grid with its least corner at `origin`, voxels of size `cell`, and `resolution`
    /// voxels along each axis.
    ///
    /// # Errors
    /// [`GridError::NotFinite`] if a number is NaN or infinite,
    /// [`GridError::CellNotPositive`], [`GridError::NoVoxels`] if an axis has none,
    /// [`GridError::TooManyVoxels`] if an axis has more than [`MOST`](Self::MOST),
    /// [`GridError::OutOfRange`] if the scalar does not hold the greatest corner, or in floats the
    /// distance |origin| + resolution·cell, and in floats [`GridError::CellTooSmall`] if a cell is
    /// less than 8 roundoffs of that distance, for then two planes might round to one number.
    ///
    /// *Panics*: never.
    pub fn new(
        origin: impl Into<Vec3<S>>,
        cell: impl Into<Vec3<S>>,
        resolution: [u32; 3],
    ) -> Result<Self, GridError> {
        let (origin, cell) = (origin.into(), cell.into());
        let (from, step) = (origin.to_array(), cell.to_array());
        if !from.iter().chain(&step).all(|x| x.is_finite()) {
            return Err(GridError::NotFinite);
        }
        let (mut per_cell, mut deviation) = ([0.0; 3], [0.0; 3]);
        for i in 0..3 {
            if step[i].partial_cmp(&S::ZERO) != Some(Ordering::Greater) {
                return Err(GridError::CellNotPositive);
            }
            match resolution[i] {
                0 => return Err(GridError::NoVoxels),
                1..=Self::MOST => {}
                _ => return Err(GridError::TooManyVoxels),
            }
            deviation[i] = S::check_planes(from[i], step[i], resolution[i])?;
            if S::HAS_PLACES {
                per_cell[i] = 1.0 / step[i].units();
                // The reciprocal of a subnormal cell overflows: floats know no places.
                if per_cell[i] > f64::MAX {
                    deviation[i] = f64::INFINITY;
                }
            }
        }
        Ok(Self { origin, cell, first: [0; 3], resolution, per_cell, deviation })
    }

    /// Makes a grid of cubes around a box. The longest side of the box spans `resolution` voxels:
    /// one more where floats round planes, fewer where fixed point rounds the cell up, and more or
    /// fewer if the cell is subnormal. On each side of the box, the grid has `margin` more layers of
    /// voxels.
    ///
    /// The cells have the longest side over `resolution` as their size, rounded up in fixed point.
    /// The grid begins with the least corner of [`Aabb::min_max`], less the margin, and ends with
    /// the first plane at or beyond the greatest corner, plus the margin. In fixed point the box is
    /// first clamped to the range of the scalar.
    ///
    /// # Errors
    /// As for [`new`](Self::new): [`GridError::NoVoxels`] if `resolution` is zero,
    /// [`GridError::CellNotPositive`] if the box is a point, or too small for the scalar,
    /// [`GridError::OutOfRange`] also if a corner of the box, its length or the cell is no number of the
    /// scalar, or the least corner less the margin is not.
    ///
    /// *Panics*: never.
    ///
    /// ```
    /// use septum::Aabb;
    /// use septum::voxel::{Grid, GridError};
    ///
    /// let table = Aabb::from_min_max([0.0, 0.0, 0.0], [2.0, 1.0, 0.75])?;
    /// let grid = Grid::around(&table, 64, 1)?;
    /// assert_eq!(grid.resolution(), [66, 34, 26]);
    /// assert_eq!((grid.cell().x, grid.origin().x), (0.03125, -0.03125));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn around(aabb: &Aabb<S>, resolution: u32, margin: u32) -> Result<Self, GridError> {
        let (min, max) = aabb.min_max().ok_or(GridError::OutOfRange)?;
        let (from, to) = (min.to_array(), max.to_array());
        let mut cell = S::ZERO;
        for i in 0..3 {
            let step = match S::step(from[i], to[i], resolution) {
                Some(step) => step,
                None if resolution == 0 => return Err(GridError::NoVoxels),
                None => return Err(GridError::OutOfRange),
            };
            cell = greatest(cell, step);
        }
        if cell <= S::ZERO {
            return Err(GridError::CellNotPositive);
        }
        let (mut origin, mut count) = (from, [0; 3]);
        for i in 0..3 {
            origin[i] = S::origin_before(from[i], cell, margin).ok_or(GridError::OutOfRange)?;
            let end = S::first_plane_above(origin[i], cell, to[i]);
            let end = end.ok_or(GridError::OutOfRange)?;
            // At least one voxel, also where the box is flat.
            count[i] = end.max(margin.saturating_add(1)).saturating_add(margin);
        }
        Self::new(origin, [cell; 3], count)
    }

    /// Returns the part of the grid with the voxels in these ranges, numbered from zero; `None`
    /// if a range is empty or reaches beyond the grid.
    ///
    /// Use parts to work on a large grid slab by slab, each with all x and y and a range of z:
    /// a slab fits in little memory, and threads can share the slabs.
    #[must_use]
    pub fn part(&self, ranges: [Range<u32>; 3]) -> Option<Self> {
        let mut part = *self;
        for (i, Range { start, end }) in ranges.into_iter().enumerate() {
            if start >= end || end > self.resolution[i] {
                return None;
            }
            part.first[i] += start;
            part.resolution[i] = end - start;
        }
        Some(part)
    }

    /// Returns the box of a voxel, the set that every answer is about; `None` if the grid has no
    /// such voxel.
    #[must_use]
    pub fn voxel(&self, [i, j, k]: [u32; 3]) -> Option<Aabb<S>> {
        let [x, y, z] = self.resolution;
        if i >= x || j >= y || k >= z {
            return None;
        }
        let corner = |at: [u32; 3]| three(|axis| self.plane(axis, at[axis]));
        Aabb::from_min_max(corner([i, j, k]), corner([i + 1, j + 1, k + 1])).ok()
    }

    /// Returns plane k of an axis.
    #[inline]
    pub(super) fn plane(&self, axis: usize, k: u32) -> S {
        let (origin, cell) = (self.origin.to_array(), self.cell.to_array());
        S::plane(origin[axis], cell[axis], self.first[axis] + k)
    }

    /// Returns the two planes whose middle a level is.
    #[inline]
    pub(super) fn planes(&self, axis: usize, level: Level) -> [S; 2] {
        [self.plane(axis, level.from as u32), self.plane(axis, level.to as u32)]
    }

    /// Compares a level with a number, exactly.
    #[inline]
    pub(super) fn compare(&self, axis: usize, level: Level, x: S) -> Ordering {
        let [p, q] = self.planes(axis, level);
        if level.from != level.to {
            return middle(p, q, x, self.cell.x);
        }
        compare(p, x)
    }

    /// Returns to − from in cells, with a relative error of less than six roundoffs: a subnormal reciprocal
    /// errs by four.
    pub(super) fn length(&self, axis: usize, from: S, to: S) -> f64 {
        to.units_beyond(from) * self.per_cell[axis]
    }

    /// Returns the place of a number among the planes of an axis, in cells from the first plane,
    /// within [`place_error`](Self::place_error).
    #[inline(always)]
    pub(super) fn place(&self, axis: usize, x: S) -> f64 {
        let origin = self.origin.to_array()[axis];
        x.units_beyond(origin) * self.per_cell[axis] - f64::from(self.first[axis])
    }

    /// Bounds the error of a place up to `farthest` cells from the first plane, plus the error of
    /// a plane, on any axis.
    ///
    /// Planes are no farther from their places than `deviation`. The place of a number is
    /// computed by a difference, a reciprocal, a product and another difference. Each errs by one
    /// roundoff of `f64`, times at most `farthest + first`, and a subnormal reciprocal by four:
    /// less than 8 roundoffs in all.
    #[inline(always)]
    pub(super) fn place_error(&self, farthest: f64) -> f64 {
        let most = |[a, b, c]: [f64; 3]| greatest(greatest(a, b), c);
        4.0 * f64::EPSILON * (farthest + most(self.first.each(f64::from))) + most(self.deviation)
    }
}

impl<S: Copy> Grid<S> {
    /// Returns the least corner of voxel (0, 0, 0) of the whole grid.
    #[must_use]
    pub const fn origin(&self) -> Vec3<S> {
        self.origin
    }

    /// Returns the size of a voxel.
    #[must_use]
    pub const fn cell(&self) -> Vec3<S> {
        self.cell
    }

    /// Returns the number of voxels along each axis.
    #[must_use]
    pub const fn resolution(&self) -> [u32; 3] {
        self.resolution
    }

    /// Returns the index, in the whole grid, of voxel (0, 0, 0) of this part.
    #[must_use]
    pub const fn offset(&self) -> [u32; 3] {
        self.first
    }
}

/// The reason why [`Grid::new`] fails.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[non_exhaustive]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum GridError {
    /// A number is NaN or infinite.
    NotFinite,
    /// A size of a cell is zero or less.
    CellNotPositive,
    /// An axis has no voxels.
    NoVoxels,
    /// An axis has more voxels than [`Grid::MOST`].
    TooManyVoxels,
    /// The greatest corner is not a number of the scalar.
    OutOfRange,
    /// Cells are so small beside their distance from zero that planes might round to one.
    CellTooSmall,
}

impl From<PlanesError> for GridError {
    fn from(error: PlanesError) -> Self {
        match error {
            PlanesError::OutOfRange => Self::OutOfRange,
            PlanesError::TooClose => Self::CellTooSmall,
        }
    }
}

impl fmt::Display for GridError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::NotFinite => "a number of the grid is NaN or infinite",
            Self::CellNotPositive => "a cell's size is not above zero",
            Self::NoVoxels => "an axis of the grid has no voxels",
            Self::TooManyVoxels => "an axis of the grid has more voxels than 2^30",
            Self::OutOfRange => "the scalar does not hold the grid's greatest corner",
            Self::CellTooSmall => "cells are too small for their distance from zero",
        })
    }
}

impl core::error::Error for GridError {}
