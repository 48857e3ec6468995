//! The start of a walk: the first point of the line in the grid, and the planes left on each axis.

use core::cmp::Ordering;

use super::{Axis, Walk};
use crate::arithmetic::Each;
use crate::scalar::Scalar;
use crate::voxel::Rule;
use crate::voxel::grid::Grid;
use crate::voxel::line::{Limit, Line};
use crate::voxel::place::Place;

impl<S: Scalar> Walk<S> {
    pub(super) fn new(
        grid: &Grid<S>,
        line: Line<S>,
        limits: [Option<Limit>; 2],
        rule: Rule,
    ) -> Self {
        let axis = Axis { at: 0, step: 1, plane: 0, left: 0 };
        let mut walk = Self {
            grid: *grid,
            line,
            rule,
            axes: [axis; 3],
            next: 0,
            around: 0,
            must: 0,
            is_over: true,
        };
        if let Some((start, is_entry)) = walk.start(limits[0]) {
            walk.is_over = false;
            for i in 0..3 {
                let end = limits[1].map(|limit| walk.line.at_limit(grid, i, limit));
                // The line may end before it comes to the grid.
                walk.is_over |= end.is_some_and(|end| match walk.line.way(i) {
                    Ordering::Greater => end.above < start[i].above,
                    Ordering::Less => end.at > start[i].at,
                    Ordering::Equal => false,
                });
                walk.set_out(i, start[i], end, is_entry);
            }
        }
        walk
    }

    /// Returns the first point of the line in the closed box of the grid, and whether the line
    /// enters the box there; `None` if it has no point in the box.
    fn start(&self, limit: Option<Limit>) -> Option<([Place; 3], bool)> {
        let (grid, line) = (&self.grid, &self.line);
        let last = grid.resolution().each(|n| n as i32);
        let mut places = [Place::before(0); 3];
        // The last plane that the line crosses on its way in.
        let mut entry: Option<(usize, i32)> = None;
        for i in 0..3 {
            let way = line.way(i);
            let limit = if way == Ordering::Equal { Some(Limit::Anchor) } else { limit };
            places[i] = match limit {
                Some(limit) => line.at_limit(grid, i, limit),
                None if way == Ordering::Greater => Place::before(0),
                None => Place::before(last[i] + 1),
            };
            let plane = match (way, is_outside(places[i], last[i])) {
                (_, false) => continue,
                (Ordering::Greater, _) if places[i].above == 0 => 0,
                (Ordering::Less, _) if places[i].above > 0 => last[i],
                _ => return None,
            };
            let is_later = |other| line.order(grid, (i, plane), other) == Ordering::Greater;
            if entry.is_none_or(is_later) {
                entry = Some((i, plane));
            }
        }
        if let Some((axis, plane)) = entry {
            for i in 0..3 {
                places[i] = if i == axis {
                    Place::on(plane)
                } else {
                    line.at_plane(grid, i, (axis, plane))
                };
                if is_outside(places[i], last[i]) {
                    return None;
                }
            }
        }
        Some((places, entry.is_some()))
    }

    /// Sets an axis to the start.
    fn set_out(&mut self, i: usize, start: Place, end: Option<Place>, is_entry: bool) {
        let last = self.grid.resolution()[i] as i32;
        let is_closed = self.rule == Rule::Closed;
        let is_on_plane = start.at != start.above;
        let bit = if is_closed && is_on_plane { 1 << i } else { 0 };
        let axis = &mut self.axes[i];
        match self.line.way(i) {
            Ordering::Equal => {
                axis.at = start.above - 1;
                // A line in the greatest plane lies in the layer beyond the grid, except for
                // closed voxels.
                self.is_over |= !is_closed && axis.at >= last;
            }
            Ordering::Greater => {
                // A thin walk crosses the planes of its entry one by one, and a step between them
                // may be in the grid.
                let crosses = self.rule == Rule::Thin && is_entry;
                let from = if crosses { start.at } else { start.above };
                *axis = Axis { at: from - 1, step: 1, plane: from, left: 0 };
                let end = end.map_or(last, |end| last.min(end.above - 1));
                axis.left = end - axis.plane + 1;
            }
            Ordering::Less => {
                let from = if is_closed { start.at } else { start.above };
                *axis = Axis { at: from - 1, step: -1, plane: from - 1, left: 0 };
                let end = end.map_or(0, |end| 0.max(if is_closed { end.at } else { end.above }));
                axis.left = axis.plane - end + 1;
            }
        }
        if bit != 0 {
            // The voxel before the plane comes first.
            axis.at -= axis.step;
            self.around |= bit;
        }
    }
}

/// Returns whether a place is outside the closed range of an axis.
fn is_outside(place: Place, last: i32) -> bool {
    place.above <= 0 || place.at > last
}
