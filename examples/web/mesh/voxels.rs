//! A mesh in the voxels of a grid around it.

use core::ops::Range;

use septum::voxel::{Bits, Grid, GridError, Rule, Solid};

pub(crate) type Mesh<'a> = septum::mesh::Mesh<'a, f32, u32>;

/// The grid of cubes around a mesh, with about `resolution` voxels along its longest side. It is as
/// small as rounding permits: its planes enclose every triangle.
pub(crate) fn grid_around(mesh: &Mesh<'_>, resolution: u32) -> Result<Grid<f32>, GridError> {
    let (mut least, mut greatest) = ([f32::INFINITY; 3], [f32::NEG_INFINITY; 3]);
    for triangle in mesh.iter() {
        for vertex in triangle.vertices() {
            let x = vertex.to_array();
            for i in 0..3 {
                // All coordinates are finite.
                least[i] = if x[i] < least[i] { x[i] } else { least[i] };
                greatest[i] = if x[i] > greatest[i] { x[i] } else { greatest[i] };
            }
        }
    }
    let (mut extent, mut middle, mut longest) = ([0.0; 3], [0.0; 3], 0.0);
    for i in 0..3 {
        let [least, greatest] = [least[i], greatest[i]].map(f64::from);
        (extent[i], middle[i]) = (greatest - least, 0.5 * (greatest + least));
        if extent[i] > longest {
            longest = extent[i];
        }
    }
    // Slightly larger, so that the planes enclose a mesh of exactly this size.
    let cell = (longest / f64::from(resolution) * (1.0 + 1.0 / f64::from(1 << 20))) as f32;
    // The planes are rounded, and rounding keeps the order: a plane not above a vertex stays not
    // above it. If rounding moves the origin, there is as much room on the opposite side.
    let (mut size, mut origin) = ([0; 3], [0.0; 3]);
    for i in 0..3 {
        size[i] = above(extent[i] / f64::from(cell)).max(1);
        origin[i] = (middle[i] - 0.5 * f64::from(size[i]) * f64::from(cell)) as f32;
    }
    Grid::new(origin, [cell; 3], size)
}

/// The least integer that is not below `x`.
fn above(x: f64) -> u32 {
    let whole = x as u32;
    if f64::from(whole) < x { whole + 1 } else { whole }
}

/// Sets the voxels that these triangles meet.
pub(crate) fn fill(bits: &mut Bits<'_, f32, u32>, mesh: &Mesh<'_>, triangles: Range<usize>) {
    for triangle in triangles.map_while(|i| mesh.triangle(i)) {
        bits.fill(&triangle, Rule::Closed);
    }
}

/// Marks where these triangles cross the rows of a solid.
pub(crate) fn cross(solid: &mut Solid<'_, f32, u32>, mesh: &Mesh<'_>, triangles: Range<usize>) {
    for triangle in triangles.map_while(|i| mesh.triangle(i)) {
        solid.cross(&triangle);
    }
}
