use core::cmp::Ordering;
use core::ops::Range;

use super::Rule;
use super::grid::Grid;
use super::place::Place;
use super::placed::Placed;
use super::plane::{Line, Plane};
use super::slabs::{BLOCK, Span, spans};
use crate::scalar::Scalar;
use crate::shape::Triangle;

/// Voxels (x, y, z) of a grid, one beside the other along x.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
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
    rule: Rule,
    placed: Placed<S>,
    plane: Option<Plane>,
    /// The voxels in question on each axis.
    bounds: [Span; 3],
    /// Whether all of them are marked.
    is_full: bool,
    /// The slabs of a block: those of y seen along z, and those of z seen along y and x.
    xy: [Span; BLOCK],
    xz: [Span; BLOCK],
    yz: [Span; BLOCK],
    /// The first y and the first z of the block.
    block: [i32; 2],
    /// The next row of the present layer, the end of the layer, and the layer.
    y: i32,
    y_end: i32,
    z: i32,
}

impl<S: Scalar> Grid<S> {
    /// The voxels that a triangle marks, as rows along x, each voxel once.
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
    /// exact signs alone, and finds each end by bisection.
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
        let placed = Placed::new(triangle, grid);
        let size = grid.resolution();
        let mut bounds = [Span::EMPTY; 3];
        let mut narrow = 0;
        for i in 0..3 {
            let least = placed.least[i];
            let first = if rule == Rule::HalfOpen { least.above - 1 } else { least.at - 1 };
            let last = placed.greatest[i].above - 1;
            narrow += u32::from(first == last);
            bounds[i] = Span { first: first.max(0), last: last.min(size[i] as i32 - 1) };
        }
        if bounds.iter().any(|span| span.first > span.last) {
            bounds = [Span { first: 0, last: -1 }; 3];
        }
        // A triangle whose box is one voxel wide on two axes: all of it is in their row.
        let is_full = narrow >= 2;
        let [_, y, z] = bounds;
        let mut rows = Self {
            grid: *grid,
            rule,
            placed,
            plane: None,
            bounds,
            is_full,
            xy: [Span::EMPTY; BLOCK],
            xz: [Span::EMPTY; BLOCK],
            yz: [Span::EMPTY; BLOCK],
            block: [y.first, z.first],
            y: 0,
            y_end: 0,
            z: z.first - 1,
        };
        if !is_full {
            rows.plane = Plane::new(&rows.placed);
            rows.see_along_z();
            rows.see_layers();
        }
        rows
    }

    /// Works out the slabs of y of the present block.
    #[inline(always)]
    fn see_along_z(&mut self) {
        let [_, y, _] = self.bounds;
        let first = self.block[0];
        let slabs = slabs(&mut self.xy, first, y.last);
        spans(&self.placed, &self.grid, self.rule, [0, 1], first, slabs);
    }

    /// Works out the slabs of z of the present block.
    #[inline(always)]
    fn see_layers(&mut self) {
        let [_, _, z] = self.bounds;
        let first = self.block[1];
        let xz = slabs(&mut self.xz, first, z.last);
        spans(&self.placed, &self.grid, self.rule, [0, 2], first, xz);
        let yz = slabs(&mut self.yz, first, z.last);
        spans(&self.placed, &self.grid, self.rule, [1, 2], first, yz);
    }

    /// Goes on to the next layer of the block, or to the next block.
    #[inline(always)]
    fn next_layer(&mut self) -> bool {
        const STEP: i32 = BLOCK as i32;
        let [_, y, z] = self.bounds;
        self.z += 1;
        if self.z > z.last.min(self.block[1] + STEP - 1) {
            self.block[0] += STEP;
            if self.block[0] > y.last {
                if z.last - self.block[1] < STEP {
                    // The end, and still the end if asked again.
                    (self.block[0], self.z) = (y.last, z.last);
                    return false;
                }
                self.block = [y.first, self.block[1] + STEP];
                if !self.is_full {
                    self.see_layers();
                }
            }
            if !self.is_full {
                self.see_along_z();
            }
            self.z = self.block[1];
        }
        let span =
            if self.is_full { y } else { self.yz[(self.z - self.block[1]) as usize % BLOCK] };
        self.y = span.first.max(self.block[0]);
        self.y_end = span.last.min(y.last).min(self.block[0] + STEP - 1) + 1;
        true
    }

    /// The voxels of a row in the present block.
    #[inline(always)]
    fn row(&self, y: i32) -> Span {
        let Span { mut first, mut last } = self.bounds[0];
        if self.is_full {
            return Span { first, last };
        }
        let xy = self.xy[(y - self.block[0]) as usize % BLOCK];
        let xz = self.xz[(self.z - self.block[1]) as usize % BLOCK];
        first = first.max(xy.first).max(xz.first);
        last = last.min(xy.last).min(xz.last);
        let Some(plane) = &self.plane else { return Span { first, last } };
        if first > last {
            return Span::EMPTY;
        }
        // The corners of a row with the least and the greatest distance from the plane, seen
        // along its normal. Half-open voxels lack those that take a greatest plane.
        let falls = plane.signs.map(|sign| i32::from(sign == Ordering::Less));
        let half_open = self.rule == Rule::HalfOpen;
        let near = [Line::plane(y + falls[0]), Line::plane(self.z + falls[1])];
        let far = [Line::plane(y + 1 - falls[0]), Line::plane(self.z + 1 - falls[1])];
        let place = |lines: [Line; 2], low: i32, high: i32| {
            let (low, high) = (Place::before(low), Place::before(high));
            plane.place(&self.placed, &self.grid, lines, low, high)
        };
        let end = place(near, first, last + 1);
        let start = place(far, first + 1, last + 2);
        let lacks_near = half_open && falls != [0, 0];
        last = if lacks_near { end.at } else { end.above } - 1;
        first = if half_open { start.above } else { start.at } - 1;
        Span { first, last }
    }
}

/// The slabs from `first` to `last`, as far as the block goes.
#[inline(always)]
fn slabs(block: &mut [Span; BLOCK], first: i32, last: i32) -> &mut [Span] {
    let count = (last - first + 1).clamp(0, BLOCK as i32);
    &mut block[..count as usize]
}

impl<S: Scalar> Iterator for Rows<S> {
    type Item = Row;

    #[inline]
    fn next(&mut self) -> Option<Row> {
        loop {
            while self.y < self.y_end {
                let y = self.y;
                self.y += 1;
                let Span { first, last } = self.row(y);
                if first <= last {
                    let x = first as u32..last as u32 + 1;
                    return Some(Row { x, y: y as u32, z: self.z as u32 });
                }
            }
            if !self.next_layer() {
                return None;
            }
        }
    }
}
