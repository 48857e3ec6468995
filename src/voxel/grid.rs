use core::cmp::Ordering;
use core::fmt;
use core::ops::Range;

use super::marks::Line;
use super::sign::middle;
use crate::arithmetic::{compare, three};
use crate::scalar::{PlanesError, Scalar};
use crate::shape::{Aabb, Vec3};

/// A grid of voxels, all of one size.
///
/// *Geometry*: the planes of the grid are numbers of the scalar. On each axis plane k is
/// `origin + k·cell`, where floats round the product and the sum, and fixed point rounds
/// nothing. Voxel (i, j, k) is the box between its planes i and i + 1, j and j + 1, k and
/// k + 1: what [`voxel`](Self::voxel) returns. Every answer of this module is about these
/// boxes.
///
/// A [`part`](Self::part) of a grid is a grid. Its planes are those of the whole.
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
    /// What places numbers among the planes: one over the cell, and how far a plane may be
    /// from its place.
    per_cell: [f64; 3],
    deviation: [f64; 3],
}

impl<S: Scalar> Grid<S> {
    /// The most voxels along an axis.
    pub const MOST: u32 = 1 << 30;

    /// The grid with its least corner at `origin`, voxels of size `cell`, and `resolution`
    /// of them along each axis.
    ///
    /// # Errors
    /// [`GridError::NotFinite`] where a number is NaN or infinite,
    /// [`GridError::CellNotPositive`], [`GridError::NoVoxels`] where an axis has none,
    /// [`GridError::TooManyVoxels`] where it has more than [`MOST`](Self::MOST),
    /// [`GridError::OutOfRange`] where the scalar does not hold the greatest corner, and in
    /// floats [`GridError::CellTooSmall`] where a cell is less than 8 roundoffs of the
    /// distance |origin| + resolution·cell: two planes might round to one.
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
                per_cell[i] = step[i].reciprocal_in_double();
                // Of cells so small floats know no places.
                if per_cell[i] > f64::MAX {
                    deviation[i] = f64::INFINITY;
                }
            }
        }
        Ok(Self { origin, cell, first: [0; 3], resolution, per_cell, deviation })
    }

    /// The part of the grid with the voxels in these ranges, numbered from zero; `None` where
    /// a range is empty or reaches beyond the grid.
    ///
    /// Work on a large grid goes slab by slab this way: parts that hold all x and y, and a
    /// range of z. Each fits in little memory, and threads can share them out.
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

    /// The box of a voxel, the set that every answer is about; `None` where there is no such
    /// voxel.
    #[must_use]
    pub fn voxel(&self, [i, j, k]: [u32; 3]) -> Option<Aabb<S>> {
        let [x, y, z] = self.resolution;
        if i >= x || j >= y || k >= z {
            return None;
        }
        let corner = |at: [u32; 3]| three(|axis| self.plane(axis, at[axis]));
        Aabb::from_min_max(corner([i, j, k]), corner([i + 1, j + 1, k + 1])).ok()
    }

    /// Plane k of the grid on an axis.
    #[inline]
    pub(super) fn plane(&self, axis: usize, k: u32) -> S {
        let (origin, cell) = (self.origin.to_array(), self.cell.to_array());
        S::plane(origin[axis], cell[axis], self.first[axis] + k)
    }

    /// The two planes that a line is the middle of.
    #[inline]
    pub(super) fn planes(&self, axis: usize, line: Line) -> [S; 2] {
        [self.plane(axis, line.from as u32), self.plane(axis, line.to as u32)]
    }

    /// How a line of the grid compares with a number.
    #[inline]
    pub(super) fn compare(&self, axis: usize, line: Line, x: S) -> Ordering {
        let [p, q] = self.planes(axis, line);
        if line.from != line.to {
            return middle(p, q, x, self.cell.x);
        }
        compare(p, x)
    }

    /// The way from one number to another, in cells, with an error of less than four roundoffs
    /// of itself.
    pub(super) fn length(&self, axis: usize, from: S, to: S) -> f64 {
        to.less_in_double(from) * self.per_cell[axis]
    }

    /// A number's place among the planes on an axis, up to the error that
    /// [`place_error`](Self::place_error) says.
    #[inline(always)]
    pub(super) fn place(&self, axis: usize, x: S) -> f64 {
        let origin = self.origin.to_array()[axis];
        x.less_in_double(origin) * self.per_cell[axis] - f64::from(self.first[axis])
    }

    /// How far places up to `farthest` from the first plane may be from the truth, for
    /// numbers and planes together, on any axis.
    ///
    /// Planes are no farther from their places than `deviation`, wherever they are. Of numbers a
    /// difference, a reciprocal, their product and one more difference err by a roundoff of f64
    /// each, of what is at most `farthest + first`, and a subnormal reciprocal by four: less than
    /// 8 in all.
    #[inline(always)]
    pub(super) fn place_error(&self, farthest: f64) -> f64 {
        let [a, b, c] = self.first.map(f64::from);
        let [d, e, f] = self.deviation;
        let most = |a: f64, b: f64, c: f64| {
            let ab = if a > b { a } else { b };
            if ab > c { ab } else { c }
        };
        4.0 * f64::EPSILON * (farthest + most(a, b, c)) + most(d, e, f)
    }
}

impl<S: Copy> Grid<S> {
    /// The least corner of the voxel (0, 0, 0) of the grid that this one is a part of.
    #[must_use]
    pub const fn origin(&self) -> Vec3<S> {
        self.origin
    }

    /// The size of a voxel.
    #[must_use]
    pub const fn cell(&self) -> Vec3<S> {
        self.cell
    }

    /// How many voxels there are along each axis.
    #[must_use]
    pub const fn resolution(&self) -> [u32; 3] {
        self.resolution
    }

    /// Where in the whole grid the voxel (0, 0, 0) of this part is.
    #[must_use]
    pub const fn offset(&self) -> [u32; 3] {
        self.first
    }
}

/// Why there is no such grid.
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
