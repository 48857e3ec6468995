//! The voxels in the axes and the units of the meshes' files, for formats that keep them.

use crate::grid::Grid;
use crate::placement::Placed;
use septum_tools::mesh::Up;

/// A grid whose axes are those of the files.
pub(crate) struct Volume<'a> {
    grid: &'a Grid,
    up: Up,
    /// The least corner.
    pub(crate) origin: [f64; 3],
    /// The edge of a voxel.
    pub(crate) edge: f64,
}

impl<'a> Volume<'a> {
    pub(crate) fn new(grid: &'a Grid, placed: &Placed, up: Up) -> Self {
        let ([x, y, z], edge) = (placed.origin, placed.edge);
        let origin = match up {
            Up::Y => [x, y, z],
            Up::Z => [x, -(z + edge * grid.size()[2] as f64), y],
        };
        Self { grid, up, origin, edge }
    }

    /// Voxels along each axis.
    pub(crate) fn size(&self) -> [usize; 3] {
        let [x, y, z] = self.grid.size();
        if self.up == Up::Z { [x, z, y] } else { [x, y, z] }
    }

    /// The words of a row along x: the least bit of the first word is the first voxel.
    pub(crate) fn row(&self, y: usize, z: usize) -> &'a [u64] {
        match self.up {
            Up::Y => self.grid.row(y, z),
            Up::Z => self.grid.row(z, self.grid.size()[2] - 1 - y),
        }
    }

    /// All rows, in the order of y, then z.
    pub(crate) fn rows(&self) -> impl Iterator<Item = &'a [u64]> + '_ {
        let [_, ny, nz] = self.size();
        (0..nz).flat_map(move |z| (0..ny).map(move |y| self.row(y, z)))
    }

    /// Whether a voxel is set. Outside the grid none is.
    pub(crate) fn get(&self, at: [Option<usize>; 3]) -> bool {
        let size = self.size();
        match at {
            [Some(x), Some(y), Some(z)] if x < size[0] && y < size[1] && z < size[2] => {
                self.row(y, z)[x / 64] >> (x % 64) & 1 == 1
            }
            _ => false,
        }
    }
}
