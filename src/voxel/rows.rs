use core::ops::Range;

use super::Rule;
use super::grid::Grid;
use super::marks::Marks;
use super::pass::Pass;
use crate::scalar::Scalar;
use crate::shape::Triangle;

/// Voxels (x, y, z) of a grid, one beside the other along x.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Row {
    /// The first and the one after the last.
    pub x: Range<u32>,
    /// Where the row is.
    pub y: u32,
    /// Where the row is.
    pub z: u32,
}

/// The voxels that a triangle marks, row by row: what [`Grid::rows`] returns.
#[derive(Clone, Debug)]
pub struct Rows<S> {
    grid: Grid<S>,
    triangle: Triangle<S>,
    pass: Pass<S, [Marks; 3]>,
    /// What is asked after this pass.
    next: &'static [[Marks; 3]],
}

impl<S: Scalar> Grid<S> {
    /// The voxels that a triangle marks, as rows along x; each voxel once, but with
    /// [`Rule::Thin`] up to three times.
    ///
    /// *Geometry*: the part of the triangle outside the grid marks nothing.
    ///
    /// A triangle and a box are disjoint exactly if one of 13 axes separates them. Three of these
    /// are the axes of the grid. Nine are seen in the three views along an axis, where the
    /// triangle meets an interval of each slab. The last is the normal: the plane leaves an
    /// interval of each row. The voxels of a row are what all of these have in common.
    ///
    /// *Contact*: as the rule says.
    ///
    /// *Numerics*: exact for every triangle and grid, in every scalar. For [`Rule::Closed`] the
    /// voxels are those for which `triangle.overlaps(&grid.voxel(index))` holds.
    ///
    /// *Panics*: never.
    ///
    /// *Cost*: a row takes two multiplications and additions, an end of a slab one. Ends that
    /// come within rounding of a plane take an exact sign each. Fixed point on 32-bit cores has
    /// exact signs alone, and finds each end by bisection. With `Closed` and `HalfOpen` the work
    /// of a call of `next` is bounded, however large triangle and grid are: rows without voxels
    /// are passed over by bisection, after a few blocks of 64. With `Thin` the rows that `Closed`
    /// has are visited, up to three times each: a triangle that marks no voxel may pass through
    /// many of them between the middles of voxels.
    ///
    /// *Source*: the conditions are those of M. Schwarz and H.-P. Seidel, "Fast Parallel Surface
    /// and Solid Voxelization on GPUs", *ACM Transactions on Graphics* 29(6), 2010; here they
    /// give the ends of intervals, and exact ones.
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
        Rows::new(self, triangle, rule)
    }
}

impl<S: Scalar> Rows<S> {
    #[inline(always)]
    fn new(grid: &Grid<S>, triangle: &Triangle<S>, rule: Rule) -> Self {
        use Marks::{Center, Closed, HalfOpen};
        let (first, next): ([Marks; 3], &[[Marks; 3]]) = match rule {
            Rule::Closed => ([Closed; 3], &[]),
            Rule::HalfOpen => ([HalfOpen; 3], &[]),
            // The three arms of the cross.
            Rule::Thin => (
                [HalfOpen, Center, Center],
                &[[Center, HalfOpen, Center], [Center, Center, HalfOpen]],
            ),
        };
        let pass = Pass::new(grid, triangle, first);
        Self { grid: *grid, triangle: *triangle, pass, next }
    }
}

impl<S: Scalar> Iterator for Rows<S> {
    type Item = Row;

    #[inline]
    fn next(&mut self) -> Option<Row> {
        loop {
            if let Some(row) = self.pass.next(&self.grid) {
                return Some(row);
            }
            let (&marks, next) = self.next.split_first()?;
            self.next = next;
            self.pass = Pass::new(&self.grid, &self.triangle, marks);
        }
    }
}
