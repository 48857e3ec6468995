//! A mesh in the voxels of a grid.

use alloc::vec::Vec;

use septum::voxel::{Bits, Grid, GridError, Rule, Solid};
use spin::Mutex;

use crate::memory::{Slots, lock, say, table};
use crate::mesh::with;

/// A grid whose bits are being set.
struct State {
    grid: Grid<f32>,
    words: Vec<u32>,
    lines: Vec<u32>,
}

static GRIDS: Mutex<Slots<State>> = Mutex::new(Slots::EMPTY);

/// The code of an error; positive.
fn code(error: GridError) -> u32 {
    match error {
        GridError::NotFinite => 1,
        GridError::CellNotPositive => 2,
        GridError::NoVoxels => 3,
        GridError::TooManyVoxels => 4,
        GridError::OutOfRange => 5,
        GridError::CellTooSmall => 6,
        _ => 7,
    }
}

/// Writes the origin, the size of a voxel and the size of the grid of cubes around a mesh, and
/// returns 0, or the code of an error; 8 for a mesh without triangles.
#[unsafe(export_name = "grid_around")]
extern "C" fn grid_around(mesh: usize, resolution: u32, margin: u32) -> u32 {
    with(mesh, 8, |tree| {
        let Some(aabb) = tree.mesh().aabb() else { return 8 };
        match Grid::around(&aabb, resolution, margin) {
            Ok(grid) => {
                say(0, &grid.origin().to_array().map(f32::to_bits));
                say(3, &[grid.cell().x.to_bits()]);
                say(4, &grid.resolution());
                0
            }
            Err(error) => code(error),
        }
    })
}

/// The handle of a grid with all bits unset, or the negative code of an error; -9 if there is no
/// memory.
#[unsafe(export_name = "grid")]
extern "C" fn grid(
    ox: f32,
    oy: f32,
    oz: f32,
    cx: f32,
    cy: f32,
    cz: f32,
    nx: u32,
    ny: u32,
    nz: u32,
    is_solid: u32,
) -> i32 {
    let grid = match Grid::new([ox, oy, oz], [cx, cy, cz], [nx, ny, nz]) {
        Ok(grid) => grid,
        Err(error) => return -(code(error) as i32),
    };
    // Before `words` multiplies what does not fit.
    let words = u64::from(nx.div_ceil(32)) * u64::from(ny);
    if words.checked_mul(nz.into()).is_none_or(|words| words > 1 << 29) {
        return -9;
    }
    let lines = if is_solid == 0 { 0 } else { grid.line_words::<u32>() };
    match (table(0, grid.words::<u32>()), table(0, lines)) {
        (Some(words), Some(lines)) => lock(&GRIDS).keep(State { grid, words, lines }),
        _ => -9,
    }
}

/// Sets the voxels that the triangles from one index to another meet.
#[unsafe(export_name = "fill")]
extern "C" fn fill(grid: usize, mesh: usize, from: usize, to: usize) {
    with(mesh, (), |tree| {
        let mut grids = lock(&GRIDS);
        let Some(State { grid, words, .. }) = grids.get_mut(grid) else { return };
        let Ok(mut bits) = Bits::new(grid, words) else { return };
        for triangle in (from..to).map_while(|i| tree.mesh().triangle(i)) {
            bits.fill(&triangle, Rule::Closed);
        }
    });
}

/// Marks where the triangles from one index to another cross the rows of a solid.
#[unsafe(export_name = "cross")]
extern "C" fn cross(grid: usize, mesh: usize, from: usize, to: usize) {
    with(mesh, (), |tree| {
        let mut grids = lock(&GRIDS);
        let Some(State { grid, words, lines }) = grids.get_mut(grid) else { return };
        let Ok(mut solid) = Solid::resume(grid, words, lines) else { return };
        for triangle in (from..to).map_while(|i| tree.mesh().triangle(i)) {
            solid.cross(&triangle);
        }
    });
}

/// Sets the voxels of the solid whose centres are inside. Returns the number of rows without an
/// inside, where the mesh is open.
#[unsafe(export_name = "finish")]
extern "C" fn finish(grid: usize) -> usize {
    let mut grids = lock(&GRIDS);
    let Some(State { grid, words, lines }) = grids.get_mut(grid) else { return 0 };
    let Ok(mut solid) = Solid::resume(grid, words, lines) else { return 0 };
    solid.finish();
    solid.open_rows().count()
}

/// The number of set voxels.
#[unsafe(export_name = "count")]
extern "C" fn count(grid: usize) -> f64 {
    let mut grids = lock(&GRIDS);
    let Some(State { grid, words, .. }) = grids.get_mut(grid) else { return 0.0 };
    Bits::new(grid, words).map_or(0.0, |bits| bits.count() as f64)
}

/// The address of the grid's words.
#[unsafe(export_name = "words")]
extern "C" fn words(grid: usize) -> *const u32 {
    lock(&GRIDS).get(grid).map_or(core::ptr::null(), |state| state.words.as_ptr())
}

/// Gives the memory of a grid back.
#[unsafe(export_name = "drop_grid")]
extern "C" fn drop_grid(grid: usize) {
    lock(&GRIDS).take(grid);
}
