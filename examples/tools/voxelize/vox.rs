//! A MagicaVoxel model.

use std::error::Error;
use std::io::Write;

use dot_vox::{Color, DotVoxData, Model, Size, Voxel};

use crate::color;
use crate::grid::Grid;

/// The format keeps a coordinate in a byte.
const LONGEST_SIDE: usize = 256;

/// Refuses a grid that the format cannot hold.
pub(crate) fn check_size(size: [usize; 3]) -> Result<(), Box<dyn Error>> {
    if size.iter().any(|&n| n > LONGEST_SIDE) {
        let [x, y, z] = size;
        return Err(format!(
            "a .vox model has at most {LONGEST_SIDE} voxels a side, and the grid has \
             {x} × {y} × {z}; choose --resolution {LONGEST_SIDE} or less"
        )
        .into());
    }
    Ok(())
}

/// Writes the voxels, coloured by height. The format has z up and x to the
/// right, so y becomes z, and z becomes -y.
pub(crate) fn write(grid: &Grid, to: &mut impl Write) -> std::io::Result<()> {
    let [nx, ny, nz] = grid.size();
    let shades = 255.min(ny);
    let voxels = grid.voxels().map(|[x, y, z]| Voxel {
        x: x as u8,
        y: (nz - 1 - z) as u8,
        z: y as u8,
        i: (y * shades / ny) as u8,
    });
    let palette = (0..256).map(|i| {
        let height = (i as f64 + 0.5) / shades as f64;
        let [r, g, b] = color::to_srgb(color::glaze(height.min(1.0)));
        Color { r, g, b, a: 255 }
    });
    let size = Size { x: nx as u32, y: nz as u32, z: ny as u32 };
    DotVoxData {
        version: 150,
        index_map: Vec::new(),
        models: vec![Model { size, voxels: voxels.collect() }],
        palette: palette.collect(),
        materials: Vec::new(),
        scenes: Vec::new(),
        layers: Vec::new(),
    }
    .write_vox(to)
}
