use core::ops::Range;

use super::Rule;
use super::grid::Grid;
use super::pass::Pass;
use super::place::{Marks, Span};
use crate::scalar::Scalar;
use crate::shape::Triangle;

/// A run of voxels along x.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Row {
    /// The x of its voxels.
    pub x: Range<u32>,
    /// The y of the row.
    pub y: u32,
    /// The z of the row.
    pub z: u32,
}

/// Iterator over the voxels that a triangle marks, row by row; [`Grid::rows`] makes it.
#[derive(Clone, Debug)]
pub struct Rows<S> {
    grid: Grid<S>,
    triangle: Triangle<S>,
    pass: Pass<S, [Marks; 3]>,
    /// The marks of the passes after this one.
    next: &'static [[Marks; 3]],
}

impl<S: Scalar> Grid<S> {
    /// Which voxels does a triangle mark? Returns them as rows along x (surface voxelization).
    ///
    /// Each voxel comes once; with [`Rule::Thin`] it may come up to three times. The order of
    /// rows is not promised.
    ///
    /// *Geometry*: the part of the triangle outside the grid marks nothing.
    ///
    /// A triangle and a box are disjoint exactly if one of 13 axes separates them. Three of them
    /// are the axes of the grid. Nine appear in the three views along an axis, in which the
    /// triangle meets an interval of each slab. The last axis is the normal: the plane meets an
    /// interval of each row. A row has the voxels that lie in all of these intervals.
    ///
    /// *Contact*: see [`Rule`].
    ///
    /// *Numerics*: exact for every triangle and grid, in every scalar. For [`Rule::Closed`] a
    /// voxel is marked exactly if `triangle.overlaps(&grid.voxel(index))` holds.
    ///
    /// *Panics*: never.
    ///
    /// *Cost*: a row takes two multiplications and two additions, an end of a slab one each. An
    /// end that comes within rounding of a plane takes an exact sign. Fixed point on 32-bit cores
    /// takes exact signs only, and finds each end by bisection.
    ///
    /// With `Closed` and `HalfOpen` the work of a call of `next` is bounded, however large the
    /// triangle and the grid are: after a block of 64 empty rows, bisection finds the next row.
    /// With `Thin` the iterator visits the rows of `Closed`, up to three times each, and a call
    /// may visit many rows of a triangle that passes between the centres of voxels.
    ///
    /// *Source*: M. Schwarz and H.-P. Seidel, "Fast Parallel Surface and Solid Voxelization on
    /// GPUs", *ACM Transactions on Graphics* 29(6), 2010. Here their conditions give the ends of
    /// intervals, and are exact.
    ///
    /// ```
    /// use septum::voxel::{Grid, Rule};
    /// use septum::Triangle;
    ///
    /// let grid = Grid::new([0.0; 3], [1.0; 3], [8, 8, 8])?;
    /// let triangle = Triangle::new([0.5, 0.5, 0.5], [6.5, 0.5, 0.5], [0.5, 2.5, 0.5])?;
    /// let rows: Vec<_> = grid.rows(&triangle, Rule::Closed).map(|row| (row.y, row.x)).collect();
    /// assert_eq!(rows, [(0, 0..7), (1, 0..6), (2, 0..3)]);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    #[must_use]
    pub fn rows(&self, triangle: &Triangle<S>, rule: Rule) -> Rows<S> {
        let (first, next) = passes(rule);
        let pass = Pass::new(self, triangle, first);
        Rows { grid: *self, triangle: *triangle, pass, next }
    }
}

/// The marks of the first pass for a rule, and of the passes after it.
pub(super) const fn passes(rule: Rule) -> ([Marks; 3], &'static [[Marks; 3]]) {
    use Marks::{Center, Closed, HalfOpen};
    match rule {
        Rule::Closed => ([Closed; 3], &[]),
        Rule::HalfOpen => ([HalfOpen; 3], &[]),
        // The three arms of the cross.
        Rule::Thin => {
            ([HalfOpen, Center, Center], &[[Center, HalfOpen, Center], [Center, Center, HalfOpen]])
        }
    }
}

impl<S: Scalar> Iterator for Rows<S> {
    type Item = Row;

    #[inline]
    fn next(&mut self) -> Option<Row> {
        loop {
            if let Some(([y, z], Span { first, last })) = self.pass.next(&self.grid) {
                let x = first as u32..last as u32 + 1;
                return Some(Row { x, y: y as u32, z: z as u32 });
            }
            let (&marks, next) = self.next.split_first()?;
            self.next = next;
            self.pass = Pass::new(&self.grid, &self.triangle, marks);
        }
    }
}
