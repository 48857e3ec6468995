//! One pass over the voxels of a triangle's bounding box, for one kind of marks on each axis.
//!
//! A triangle and a box are disjoint exactly if one of 13 axes separates them: the three axes of
//! the grid, nine that appear in the views along them, and the normal.
//!
//! # Work
//!
//! The marked rows of a layer are consecutive, and so are the layers, for the triangle is convex
//! and cells side by side make a box. If the grid cuts the triangle, rows within its outline may
//! be empty. After a block of 64 rows without voxels, `first_met` finds the next row by
//! bisection: it tests the triangle against the box of many rows with the same 13 axes. Middles
//! side by side make no box. The test then takes all numbers between them and may pass for rows
//! without voxels.

use core::cmp::Ordering;

use super::grid::Grid;
use super::place::{AxisMarks, Level, Marks, Place, Span};
use super::placed::{Bounds, Near, Placed, Plane};
use super::slabs::{BLOCK, span, spans};
use crate::arithmetic::{Each, three};
use crate::scalar::Scalar;
use crate::shape::Triangle;

#[derive(Clone, Debug)]
pub(super) struct Pass<S, M> {
    placed: Placed<S, M>,
    plane: Option<Plane>,
    /// The range of voxels on each axis.
    bounds: [Span; 3],
    /// Whether every voxel in range is marked.
    is_full: bool,
    /// Whether rows within the view along x may be empty: the grid cuts the triangle, or some
    /// marks are middles.
    has_gaps: bool,
    /// The intervals of the slabs of a block: x by y, x by z, y by z.
    xy: [Span; BLOCK],
    xz: [Span; BLOCK],
    yz: [Span; BLOCK],
    /// The first y and the first z of the block.
    block: [i32; 2],
    /// The last y of the blocks at this z.
    y_last: i32,
    /// Whether the block had a row, and whether any block at its z had one.
    had_rows: [bool; 2],
    /// The next row of the present layer, the end of the layer, and the layer.
    y: i32,
    y_end: i32,
    z: i32,
}

const STEP: i32 = BLOCK as i32;

impl<S: Scalar, M: AxisMarks> Pass<S, M> {
    #[cfg_attr(not(feature = "small"), inline(always))]
    #[cfg_attr(feature = "small", inline(never))]
    pub(super) fn new(grid: &Grid<S>, triangle: &Triangle<S>, marks: M) -> Self {
        let near = Near::new(triangle, grid);
        Self::within(grid, &near, marks, Bounds::new(&near, grid, marks))
    }

    /// A pass within the bounds of a triangle.
    #[inline(always)]
    pub(super) fn within(
        grid: &Grid<S>,
        near: &Near<S>,
        marks: M,
        Bounds { bounds, is_full, is_within }: Bounds,
    ) -> Self {
        let placed = Placed::new(near, grid, marks);
        let [_, y, z] = bounds;
        let mut pass = Self {
            plane: None,
            placed,
            bounds,
            is_full,
            has_gaps: !is_within || (0..3).any(|i| !marks.of(i).are_cells()),
            xy: [Span::EMPTY; BLOCK],
            xz: [Span::EMPTY; BLOCK],
            yz: [Span::EMPTY; BLOCK],
            block: [y.first, z.first],
            y_last: y.last,
            had_rows: [false; 2],
            y: 0,
            y_end: 0,
            z: z.first - 1,
        };
        if !is_full {
            // A plane across x separates only what the bounds on x do.
            let is_across = |plane: &Plane| plane.signs == [Ordering::Equal; 2];
            pass.plane = Plane::new(&pass.placed).filter(|plane| !is_across(plane));
            pass.see_layers(grid);
            pass.see_along_z(grid);
        }
        pass
    }

    /// Returns the next row that has voxels.
    #[inline(always)]
    pub(super) fn next(&mut self, grid: &Grid<S>) -> Option<([i32; 2], Span)> {
        loop {
            while self.y < self.y_end {
                let y = self.y;
                self.y += 1;
                let span = self.row(grid, y);
                if !span.is_empty() {
                    self.had_rows = [true; 2];
                    return Some(([y, self.z], span));
                }
            }
            if !self.next_layer(grid) {
                return None;
            }
        }
    }

    /// Calls `f` with every row that has voxels.
    #[inline(always)]
    pub(super) fn each(mut self, grid: &Grid<S>, mut f: impl FnMut([i32; 2], Span)) {
        while self.next_layer(grid) {
            for y in self.y..self.y_end {
                let span = self.row(grid, y);
                if !span.is_empty() {
                    self.had_rows = [true; 2];
                    f([y, self.z], span);
                }
            }
        }
    }

    /// Computes the slabs of y of the present block.
    #[cfg_attr(not(feature = "small"), inline(always))]
    #[cfg_attr(feature = "small", inline(never))]
    fn see_along_z(&mut self, grid: &Grid<S>) {
        let first = self.block[0];
        let slabs = slabs(&mut self.xy, first, self.y_last);
        spans(&self.placed, grid, [0, 1], first, slabs);
    }

    /// Computes the slabs of z of the present block and their range of y.
    #[cfg_attr(not(feature = "small"), inline(always))]
    #[cfg_attr(feature = "small", inline(never))]
    fn see_layers(&mut self, grid: &Grid<S>) {
        let [_, y, z] = self.bounds;
        let first = self.block[1];
        let xz = slabs(&mut self.xz, first, z.last);
        spans(&self.placed, grid, [0, 2], first, xz);
        let yz = slabs(&mut self.yz, first, z.last);
        spans(&self.placed, grid, [1, 2], first, yz);
        (self.block[0], self.y_last) = (y.first, y.last);
        // The layers of a single block cover all of y.
        if z.last - z.first >= STEP {
            let all = yz.iter().fold(Span::EMPTY, |all, span| all.joined(*span));
            self.y_last = all.last.clamp(y.first - 1, y.last);
            self.block[0] = all.first.clamp(y.first, y.last + 1);
        }
    }

    /// Advances to the next layer of the block, or to the next block.
    #[inline(always)]
    fn next_layer(&mut self, grid: &Grid<S>) -> bool {
        let [_, y, z] = self.bounds;
        self.z += 1;
        if self.z > z.last.min(self.block[1] + STEP - 1) {
            let is_last = self.block[0] + STEP > self.y_last && z.last - self.block[1] < STEP;
            if is_last || !self.next_block(grid) {
                // A further call ends here again.
                (self.block, self.z) = ([self.y_last, z.last], z.last);
                return false;
            }
        }
        let span =
            if self.is_full { y } else { self.yz[(self.z - self.block[1]) as usize % BLOCK] };
        self.y = span.first.max(self.block[0]);
        self.y_end = span.last.min(self.y_last).min(self.block[0] + STEP - 1) + 1;
        true
    }

    /// Advances to the next block along y, or to the first block at the next z. After a block
    /// without rows it skips to the next block with rows.
    #[inline(never)]
    fn next_block(&mut self, grid: &Grid<S>) -> bool {
        let [_, y, z] = self.bounds;
        self.block[0] += STEP;
        if self.has_gaps && !self.had_rows[0] && self.block[0] <= self.y_last {
            let layers = Span { first: self.block[1], last: z.last.min(self.block[1] + STEP - 1) };
            let rest = Span { first: self.block[0], last: self.y_last };
            self.block[0] = self.first_met(grid, rest, |y| [y, layers]);
        }
        while self.block[0] > self.y_last {
            self.block[1] += STEP;
            if self.has_gaps && !self.had_rows[1] && self.block[1] <= z.last {
                let rest = Span { first: self.block[1], last: z.last };
                self.block[1] = self.first_met(grid, rest, |z| [y, z]);
            }
            if self.block[1] > z.last {
                return false;
            }
            (self.block[0], self.y_last) = (y.first, y.last);
            if !self.is_full {
                self.see_layers(grid);
            }
            self.had_rows[1] = false;
        }
        if !self.is_full {
            self.see_along_z(grid);
        }
        self.had_rows[0] = false;
        self.z = self.block[1];
        true
    }

    /// Finds the first slab of `rest` that has a row, by bisection; `rest.last + 1` if none has.
    /// `rows` makes rows of slabs.
    #[cold]
    #[inline(never)]
    fn first_met(&self, grid: &Grid<S>, rest: Span, rows: impl Fn(Span) -> [Span; 2]) -> i32 {
        let meets_up_to = |last: i32| self.meets(grid, rows(Span { first: rest.first, last }));
        if !meets_up_to(rest.last) {
            return rest.last + 1;
        }
        let Span { mut first, mut last } = rest;
        while first < last {
            let middle = first + (last - first) / 2;
            if meets_up_to(middle) { last = middle } else { first = middle + 1 }
        }
        first
    }

    /// Whether the triangle meets the box of many rows.
    fn meets(&self, grid: &Grid<S>, [y, z]: [Span; 2]) -> bool {
        let seen = |axes, slab| span(&self.placed, grid, axes, slab);
        if seen([1, 2], z).common(y).is_empty() {
            return false;
        }
        let x = self.bounds[0].common(seen([0, 1], y)).common(seen([0, 2], z));
        !self.beside_plane(grid, x, [y, z]).is_empty()
    }

    /// Returns the voxels of a row in the present block.
    #[inline(always)]
    fn row(&self, grid: &Grid<S>, y: i32) -> Span {
        if self.is_full {
            return self.bounds[0];
        }
        let xy = self.xy[(y - self.block[0]) as usize % BLOCK];
        let xz = self.xz[(self.z - self.block[1]) as usize % BLOCK];
        let x = self.bounds[0].common(xy).common(xz);
        self.beside_plane(grid, x, [y, self.z].each(Span::one))
    }

    /// Restricts a range of x to the voxels that the plane does not separate, in the box of some
    /// rows.
    #[inline(always)]
    fn beside_plane(&self, grid: &Grid<S>, x: Span, [y, z]: [Span; 2]) -> Span {
        if x.is_empty() {
            return Span::EMPTY;
        }
        let Some(plane) = &self.plane else { return x };
        // `near` and `far`: the edges of the rows along x that come first and last along the normal.
        let [along, of_y, of_z] = three(|i| self.placed.marks.of(i));
        let (ends_y, ends_z) = (of_y.ends(y), of_z.ends(z));
        let [mut near, mut far] = [0, 1].each(|k: usize| [ends_y[k], ends_z[k]]);
        // Half-open voxels do not have the second line of each pair.
        let (mut lacks_near, mut lacks_far) = (false, false);
        for i in 0..2 {
            let is_half_open = [of_y, of_z][i] == Marks::HalfOpen;
            match plane.signs[i] {
                Ordering::Less => {
                    core::mem::swap(&mut near[i], &mut far[i]);
                    lacks_near |= is_half_open;
                }
                Ordering::Greater => lacks_far |= is_half_open,
                Ordering::Equal => {}
            }
        }
        let place = |lines: [Level; 2], low: i32, high: i32| {
            let (low, high) = (Place::before(low), Place::before(high));
            plane.place(&self.placed, grid, lines, low, high)
        };
        let end = place(near, x.first, x.last + 1);
        let limit = i32::from(along.are_cells());
        let start = place(far, x.first + limit, x.last + 1 + limit);
        Span { first: along.first(start, lacks_far), last: along.last(end, lacks_near) }
    }
}

/// The slabs from `first` to `last`, as far as the block goes.
#[inline(always)]
fn slabs(block: &mut [Span; BLOCK], first: i32, last: i32) -> &mut [Span] {
    let count = (last - first + 1).clamp(0, BLOCK as i32);
    &mut block[..count as usize]
}
