//! Rays through the grid: from voxel to voxel, over empty blocks in one step.
//!
//! J. Amanatides and A. Woo, "A Fast Voxel Traversal Algorithm for Ray Tracing",
//! *Eurographics* 1987, on two levels.

use crate::grid::Grid;

/// Voxels along the edge of a block.
const BLOCK: i32 = 8;

/// A grid that rays can be sent through.
pub(crate) struct Scene<'a> {
    grid: &'a Grid,
    blocks: Grid,
    size: [i32; 3],
}

/// Where a ray first meets a voxel.
pub(crate) struct Hit {
    pub(crate) voxel: [i32; 3],
    /// The axis of the face that the ray came in by.
    pub(crate) axis: usize,
    /// How far along the ray, in units of its direction.
    pub(crate) t: f64,
}

impl<'a> Scene<'a> {
    /// Finds the blocks that hold anything.
    pub(crate) fn new(grid: &'a Grid) -> Self {
        let mut blocks = Grid::new(grid.size().map(|n| n.div_ceil(BLOCK as usize)));
        for voxel in grid.voxels() {
            blocks.set(voxel.map(|i| i / BLOCK as usize));
        }
        Self { grid, blocks, size: grid.size().map(|n| n as i32) }
    }

    /// Voxels along each axis.
    pub(crate) fn size(&self) -> [i32; 3] {
        self.size
    }

    /// Whether this voxel is set; outside the grid none is.
    pub(crate) fn is_set(&self, voxel: [i32; 3]) -> bool {
        (0..3).all(|i| (0..self.size[i]).contains(&voxel[i]))
            && self.grid.get(voxel.map(|i| i as usize))
    }

    /// The first voxel that a ray meets before it has gone `limit` times `dir`.
    pub(crate) fn march(&self, origin: [f64; 3], dir: [f64; 3], limit: f64) -> Option<Hit> {
        let inverse = dir.map(|d| 1.0 / d);
        let (mut t, mut axis, end) = self.clip(origin, dir, inverse, limit)?;
        let at = |t: f64, i: usize| (origin[i] + t * dir[i]).floor() as i32;
        let mut voxel = [0, 1, 2].map(|i| at(t, i).clamp(0, self.size[i] - 1));
        loop {
            let block_is_empty = !self.blocks.get(voxel.map(|i| (i / BLOCK) as usize));
            if !block_is_empty && self.grid.get(voxel.map(|i| i as usize)) {
                return Some(Hit { voxel, axis, t });
            }
            let stride = if block_is_empty { BLOCK } else { 1 };
            let corner = voxel.map(|i| i / stride * stride);
            // The plane by which the ray leaves.
            let exit = |i: usize| {
                let plane = if dir[i] > 0.0 { corner[i] + stride } else { corner[i] };
                if dir[i] == 0.0 { f64::INFINITY } else { (f64::from(plane) - origin[i]) * inverse[i] }
            };
            let exits = [exit(0), exit(1), exit(2)];
            axis = if exits[0] <= exits[1] { 0 } else { 1 };
            if exits[2] < exits[axis] {
                axis = 2;
            }
            t = exits[axis];
            if t >= end {
                return None;
            }
            if block_is_empty {
                for i in 0..3 {
                    voxel[i] = at(t, i).clamp(corner[i], corner[i] + stride - 1);
                }
            }
            voxel[axis] = if dir[axis] > 0.0 { corner[axis] + stride } else { corner[axis] - 1 };
            for i in 0..3 {
                voxel[i] = voxel[i].min(self.size[i] - 1 + i32::from(i == axis));
            }
            if !(0..self.size[axis]).contains(&voxel[axis]) {
                return None;
            }
        }
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
