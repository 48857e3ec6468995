//! One way through the voxels that a triangle may mark: those of one kind of marks.
//!
//! A triangle and a box are disjoint exactly if one of 13 axes separates them: three are those
//! of the grid, nine are seen along them, and the last is the normal.

use core::cmp::Ordering;

use super::grid::Grid;
use super::marks::{AxisMarks, Line, Marks};
use super::place::Place;
use super::placed::{Near, Placed};
use super::plane::Plane;
use super::rows::Row;
use super::slabs::{BLOCK, Span, spans};
use crate::arithmetic::three;
use crate::scalar::Scalar;
use crate::shape::Triangle;

/// The voxels in question.
#[derive(Clone, Copy, Debug)]
pub(super) struct Bounds {
    /// On each axis; on none, if there are none.
    pub(super) bounds: [Span; 3],
    /// Whether all of them are marked.
    pub(super) is_full: bool,
    /// Whether the triangle ends where the grid ends, or before.
    pub(super) is_within: bool,
}

impl Bounds {
    #[cfg_attr(not(feature = "small"), inline(always))]
    #[cfg_attr(feature = "small", inline(never))]
    pub(super) fn new<S: Scalar, M: AxisMarks>(near: &Near<S>, grid: &Grid<S>, marks: M) -> Self {
        let size = grid.resolution();
        let mut bounds = [Span::EMPTY; 3];
        let (mut narrow, mut is_within) = (0, true);
        for i in 0..3 {
            let marks = marks.of(i);
            let [least, greatest] = near.ends(grid, i, marks);
            let Span { first, last } = marks.span(least, greatest);
            narrow += u32::from(first == last && marks.are_cells());
            let end = size[i] as i32 - 1;
            is_within &= first >= 0 && last <= end;
            bounds[i] = Span { first: first.max(0), last: last.min(end) };
        }
        if bounds.iter().any(|span| span.first > span.last) {
            bounds = [Span { first: 0, last: -1 }; 3];
        }
        // A triangle whose box is one voxel wide on two axes: all of it is in their row.
        Self { bounds, is_full: narrow >= 2, is_within }
    }
}

#[derive(Clone, Debug)]
pub(super) struct Pass<S, M> {
    placed: Placed<S, M>,
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

impl<S: Scalar, M: AxisMarks> Pass<S, M> {
    #[cfg_attr(not(feature = "small"), inline(always))]
    #[cfg_attr(feature = "small", inline(never))]
    pub(super) fn new(grid: &Grid<S>, triangle: &Triangle<S>, marks: M) -> Self {
        let near = Near::new(triangle, grid);
        Self::within(grid, &near, marks, Bounds::new(&near, grid, marks))
    }

    /// The voxels within the bounds of a triangle.
    #[inline(always)]
    pub(super) fn within(
        grid: &Grid<S>,
        near: &Near<S>,
        marks: M,
        Bounds { bounds, is_full, .. }: Bounds,
    ) -> Self {
        let placed = Placed::new(near, grid, marks);
        let [_, y, z] = bounds;
        let mut pass = Self {
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
            pass.plane = Plane::new(&pass.placed);
            pass.see_along_z(grid);
            pass.see_layers(grid);
        }
        pass
    }

    /// The next row that has any voxels.
    #[inline(always)]
    pub(super) fn next(&mut self, grid: &Grid<S>) -> Option<Row> {
        loop {
            while self.y < self.y_end {
                let y = self.y;
                self.y += 1;
                let Span { first, last } = self.row(grid, y);
                if first <= last {
                    let x = first as u32..last as u32 + 1;
                    return Some(Row { x, y: y as u32, z: self.z as u32 });
                }
            }
            if !self.next_layer(grid) {
                return None;
            }
        }
    }

    /// All rows at once: [`next`](Self::next) until there are no more.
    #[inline(always)]
    pub(super) fn each(mut self, grid: &Grid<S>, mut f: impl FnMut([i32; 2], Span)) {
        while self.next_layer(grid) {
            for y in self.y..self.y_end {
                let span = self.row(grid, y);
                if span.first <= span.last {
                    f([y, self.z], span);
                }
            }
        }
    }

    /// Works out the slabs of y of the present block.
    #[cfg_attr(not(feature = "small"), inline(always))]
    #[cfg_attr(feature = "small", inline(never))]
    fn see_along_z(&mut self, grid: &Grid<S>) {
        let [_, y, _] = self.bounds;
        let first = self.block[0];
        let slabs = slabs(&mut self.xy, first, y.last);
        spans(&self.placed, grid, [0, 1], first, slabs);
    }

    /// Works out the slabs of z of the present block.
    #[cfg_attr(not(feature = "small"), inline(always))]
    #[cfg_attr(feature = "small", inline(never))]
    fn see_layers(&mut self, grid: &Grid<S>) {
        let [_, _, z] = self.bounds;
        let first = self.block[1];
        let xz = slabs(&mut self.xz, first, z.last);
        spans(&self.placed, grid, [0, 2], first, xz);
        let yz = slabs(&mut self.yz, first, z.last);
        spans(&self.placed, grid, [1, 2], first, yz);
    }

    /// Goes on to the next layer of the block, or to the next block.
    #[inline(always)]
    fn next_layer(&mut self, grid: &Grid<S>) -> bool {
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
                    self.see_layers(grid);
                }
            }
            if !self.is_full {
                self.see_along_z(grid);
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
    fn row(&self, grid: &Grid<S>, y: i32) -> Span {
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
        // Of the row's lines along x, the ones nearest to where the normal comes from, and to
        // where it goes.
        let [along, of_y, of_z] = three(|i| self.placed.marks.of(i));
        let (ends_y, ends_z) = (of_y.ends(y), of_z.ends(self.z));
        let [mut near, mut far] = [0, 1].map(|k: usize| [ends_y[k], ends_z[k]]);
        // Half-open voxels have no point on the second of each pair.
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
        let place = |lines: [Line; 2], low: i32, high: i32| {
            let (low, high) = (Place::before(low), Place::before(high));
            plane.place(&self.placed, grid, lines, low, high)
        };
        let end = place(near, first, last + 1);
        let limit = i32::from(along.are_cells());
        let start = place(far, first + limit, last + 1 + limit);
        Span { first: along.first(start, lacks_far), last: along.last(end, lacks_near) }
    }
}

/// The slabs from `first` to `last`, as far as the block goes.
#[inline(always)]
fn slabs(block: &mut [Span; BLOCK], first: i32, last: i32) -> &mut [Span] {
    let count = (last - first + 1).clamp(0, BLOCK as i32);
    &mut block[..count as usize]
}
