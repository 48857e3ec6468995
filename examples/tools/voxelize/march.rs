//! Rays through the grid. They step from voxel to voxel, and cross an empty block, or an empty
//! block of blocks, in one step.
//!
//! J. Amanatides and A. Woo, "A Fast Voxel Traversal Algorithm for Ray Tracing",
//! *Eurographics* 1987, on three levels.

use crate::grid::Grid;

/// Voxels along the edge of a block, and of a block of blocks.
const BLOCKS: [i32; 2] = [8, 64];

/// A grid that rays can be sent through.
pub(crate) struct Scene<'a> {
    grid: &'a Grid,
    blocks: [Grid; 2],
    size: [i32; 3],
}

/// The first voxel on a ray.
pub(crate) struct Hit {
    pub(crate) voxel: [i32; 3],
    /// The axis of the face through which the ray entered.
    pub(crate) axis: usize,
    /// The distance along the ray, in units of its direction.
    pub(crate) t: f64,
}

impl Hit {
    /// The voxel and the axis of the face that was hit.
    pub(crate) fn face(&self) -> ([i32; 3], usize) {
        (self.voxel, self.axis)
    }
}

impl<'a> Scene<'a> {
    /// Finds the blocks that are not empty.
    pub(crate) fn new(grid: &'a Grid) -> Self {
        let mut blocks = BLOCKS.map(|n| Grid::new(grid.size().map(|m| m.div_ceil(n as usize))));
        for voxel in grid.voxels() {
            for (blocks, n) in blocks.iter_mut().zip(BLOCKS) {
                blocks.set(voxel.map(|i| i / n as usize));
            }
        }
        Self { grid, blocks, size: grid.size().map(|n| n as i32) }
    }

    /// The first voxel that a ray meets before it has gone `limit` times `dir`.
    pub(crate) fn march(&self, origin: [f64; 3], dir: [f64; 3], limit: f64) -> Option<Hit> {
        let inverse = each(|i| 1.0 / dir[i]);
        let (mut t, mut axis, end) = self.clip(origin, dir, inverse, limit)?;
        // Coordinates inside the grid are not negative: truncation rounds down.
        let at = |t: f64, i: usize| (origin[i] + t * dir[i]) as i32;
        // The t at which the ray meets a plane.
        let meets = |i: usize, plane: i32| {
            if dir[i] == 0.0 { f64::INFINITY } else { (f64::from(plane) - origin[i]) * inverse[i] }
        };
        let step = each(|i| if dir[i] > 0.0 { 1 } else { -1 });
        let pace = each(|i| inverse[i].abs());
        let mut voxel = each(|i| at(t, i).clamp(0, self.size[i] - 1));
        while t < end && self.holds(voxel, axis) {
            let is_empty = |level: usize| {
                !self.blocks[level].get(each(|i| (voxel[i] / BLOCKS[level]) as usize))
            };
            // The largest empty block here, or a block that is not empty.
            let (is_empty, n) =
                if is_empty(1) { (true, BLOCKS[1]) } else { (is_empty(0), BLOCKS[0]) };
            let first = each(|i| voxel[i] & -n);
            let last = each(|i| (first[i] + n).min(self.size[i]) - 1);
            if is_empty {
                let leaves = |i: usize| meets(i, if step[i] > 0 { last[i] + 1 } else { first[i] });
                (axis, t) = least([leaves(0), leaves(1), leaves(2)]);
                voxel = each(|i| at(t, i).clamp(first[i], last[i]));
                voxel[axis] = if step[axis] > 0 { last[axis] + 1 } else { first[axis] - 1 };
                continue;
            }
            let mut next = each(|i| meets(i, voxel[i] + (step[i] + 1) / 2));
            while voxel[axis] >= first[axis] && voxel[axis] <= last[axis] && t < end {
                if self.grid.get(each(|i| voxel[i] as usize)) {
                    return Some(Hit { voxel, axis, t });
                }
                (axis, t) = least(next);
                voxel[axis] += step[axis];
                next[axis] += pace[axis];
            }
        }
        None
    }

    /// Whether a voxel is still in the grid, after a step along `axis`.
    fn holds(&self, voxel: [i32; 3], axis: usize) -> bool {
        (0..self.size[axis]).contains(&voxel[axis])
    }

    /// The part of the ray inside the grid, and the axis of the face where it
    /// enters.
    fn clip(
        &self,
        origin: [f64; 3],
        dir: [f64; 3],
        inverse: [f64; 3],
        limit: f64,
    ) -> Option<(f64, usize, f64)> {
        let (mut start, mut axis, mut end) = (0.0, 1, limit);
        for i in 0..3 {
            let far = f64::from(self.size[i]);
            if dir[i] == 0.0 {
                if !(0.0..=far).contains(&origin[i]) {
                    return None;
                }
                continue;
            }
            let (a, b) = ((0.0 - origin[i]) * inverse[i], (far - origin[i]) * inverse[i]);
            if a.min(b) > start {
                (start, axis) = (a.min(b), i);
            }
            end = end.min(a.max(b));
        }
        (start <= end).then_some((start, axis, end))
    }
}

/// For each axis. `array::map` stays out of line, and takes longer than all the rest.
#[inline(always)]
fn each<T>(f: impl Fn(usize) -> T) -> [T; 3] {
    [f(0), f(1), f(2)]
}

/// The index and the value of the least of three.
fn least(t: [f64; 3]) -> (usize, f64) {
    let i = if t[0] <= t[1] { 0 } else { 1 };
    if t[2] < t[i] { (2, t[2]) } else { (i, t[i]) }
}
