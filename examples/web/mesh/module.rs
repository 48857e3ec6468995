//! The exports of the module for meshes: voxels, picking, and inside or outside.
//!
//! The mesh, its tree and the bits of its grids are in vectors. A page writes to the addresses that
//! the module returns, and nothing refers to them meanwhile.
#![allow(unsafe_code, reason = "exports")]

extern crate alloc;

use alloc::vec::Vec;
use core::sync::atomic::Ordering;

use septum::mesh::{MeshError, Node, OwnedTree, Scratch};
use septum::voxel::{Bits, Grid, GridError, Solid};
use septum::{Facing, Ray, Vec3};
use spin::{Mutex, MutexGuard};

use crate::numbers::{NUMBERS, ask};
use crate::voxels;

/// The most bytes of tables.
const MOST: usize = 92 << 20;

/// The mesh moves into the tree when that is built.
struct State {
    vertices: Vec<Vec3<f32>>,
    triangles: Vec<[u32; 3]>,
    tree: Option<OwnedTree<f32>>,
    grid: Option<Grid<f32>>,
    /// The bits of the grid, and then those of one triangle.
    words: Vec<u32>,
    /// A bit for each row, while there is a solid.
    lines: Vec<u32>,
}

impl State {
    const EMPTY: Self = Self {
        vertices: Vec::new(),
        triangles: Vec::new(),
        tree: None,
        grid: None,
        words: Vec::new(),
        lines: Vec::new(),
    };

    fn forget_grid(&mut self) {
        (self.grid, self.words, self.lines) = (None, Vec::new(), Vec::new());
    }
}

static STATE: Mutex<State> = Mutex::new(State::EMPTY);

/// There is one thread, and each export calls this once.
fn state() -> MutexGuard<'static, State> {
    STATE.lock()
}

/// The bytes that a mesh needs, and then those of its edges or of its grids: `rest`.
fn bytes([vertices, triangles]: [usize; 2], rest: usize) -> usize {
    vertices * size_of::<Vec3<f32>>()
        + triangles * (size_of::<[u32; 3]>() + size_of::<u32>())
        + Node::count_for(triangles) * size_of::<Node>()
        + rest.max(triangles * size_of::<Scratch>())
}

/// Whether there is memory for so many bytes at once. It stays with the module.
fn reaches(bytes: usize) -> bool {
    bytes <= MOST && Vec::<u8>::new().try_reserve_exact(bytes).is_ok()
}

/// A table of so many elements, or `None` if there is no memory.
fn table<T: Clone>(element: T, length: usize) -> Option<Vec<T>> {
    let mut table = Vec::new();
    table.try_reserve_exact(length).ok()?;
    table.resize(length, element);
    Some(table)
}

/// Writes an answer to the numbers from `first` on.
fn say(first: usize, answer: &[u32]) {
    for (number, &bits) in NUMBERS.iter().skip(first).zip(answer) {
        number.store(bits, Ordering::Relaxed);
    }
}

/// Makes room for a mesh, and forgets the previous one. Zero if there is not enough memory.
#[unsafe(export_name = "room")]
extern "C" fn room(vertices: u32, triangles: u32) -> u32 {
    let mut state = state();
    *state = State::EMPTY;
    let counts = [vertices as usize, triangles as usize];
    // More than this fits no memory, and sizes of fewer do not overflow.
    if counts.iter().any(|&n| n > MOST / 8) {
        return 0;
    }
    if !reaches(bytes(counts, 3 * counts[1] * size_of::<[u32; 2]>())) {
        return 0;
    }
    let tables = (table(Vec3::splat(0.0), counts[0]), table([0; 3], counts[1]));
    let (Some(vertices), Some(triangles)) = tables else { return 0 };
    (state.vertices, state.triangles) = (vertices, triangles);
    1
}

/// The address of the vertices, three `f32` each.
#[unsafe(export_name = "vertices")]
extern "C" fn vertices() -> *const Vec3<f32> {
    let state = state();
    state.tree.as_ref().map_or(&state.vertices[..], |tree| tree.mesh().vertices()).as_ptr()
}

/// The address of the triangles, three `u32` each.
#[unsafe(export_name = "triangles")]
extern "C" fn triangles() -> *const [u32; 3] {
    let state = state();
    state.tree.as_ref().map_or(&state.triangles[..], |tree| tree.mesh().triangles()).as_ptr()
}

/// Takes the mesh that was written, and builds the tree over it. Zero if the mesh is invalid.
#[unsafe(export_name = "build")]
extern "C" fn build() -> u32 {
    let mut state = state();
    let State { vertices, triangles, .. } = core::mem::replace(&mut *state, State::EMPTY);
    state.tree = OwnedTree::new(vertices, triangles).ok();
    state.tree.is_some().into()
}

/// One if the mesh is closed; otherwise zero, and numbers 0 and 1 are the vertices of an open edge.
/// The grid is lost, for edges need its memory.
#[unsafe(export_name = "closed")]
extern "C" fn closed() -> u32 {
    let mut state = state();
    state.forget_grid();
    let Some(tree) = &state.tree else { return 0 };
    let mesh = tree.mesh();
    let Some(mut edges) = table(Default::default(), 3 * mesh.triangles().len()) else { return 0 };
    match mesh.check_closed(&mut edges) {
        Err(MeshError::OpenEdge { vertices }) => {
            say(0, &vertices.map(|i| i as u32));
            0
        }
        closed => closed.is_ok().into(),
    }
}

/// Starts a new grid around the mesh, with all bits unset. Numbers 0 to 2 are its size, 3 to 5 its
/// least corner, 6 the size of a voxel. Returns 0, or the reason why there is no such grid.
#[unsafe(export_name = "grid")]
extern "C" fn grid(resolution: u32) -> u32 {
    let mut state = state();
    state.forget_grid();
    let Some(tree) = &state.tree else { return 1 };
    let mesh = tree.mesh();
    let grid = match voxels::grid_around(&mesh, resolution) {
        Ok(grid) => grid,
        Err(GridError::CellNotPositive) => return 2,
        Err(GridError::CellTooSmall) => return 3,
        Err(_) => return 4,
    };
    let (words, lines) = (grid.words::<u32>(), grid.line_words::<u32>());
    let counts = [mesh.vertices().len(), mesh.triangles().len()];
    if words > MOST / 8 || bytes(counts, (2 * words + lines) * size_of::<u32>()) > MOST {
        return 5;
    }
    let Some(table) = table(0, 2 * words) else { return 5 };
    say(0, &grid.resolution());
    say(3, &grid.origin().to_array().map(f32::to_bits));
    say(6, &[grid.cell().x.to_bits()]);
    (state.grid, state.words) = (Some(grid), table);
    0
}

/// Sets the voxels that triangles meet, and counts all set voxels if requested.
fn fill_in(which: usize, from: u32, to: u32, is_to_count: bool) -> u32 {
    let State { tree: Some(tree), grid: Some(grid), words, lines, .. } = &mut *state() else {
        return 0;
    };
    *lines = Vec::new();
    let (all, one) = words.split_at_mut(grid.words::<u32>());
    if which == 1 {
        one.fill(0);
    }
    let Ok(mut bits) = Bits::new(grid, if which == 1 { one } else { all }) else { return 0 };
    voxels::fill(&mut bits, &tree.mesh(), from as usize..to as usize);
    if is_to_count { bits.count() as u32 } else { 0 }
}

/// Sets the voxels that the triangles from one index to another meet.
#[unsafe(export_name = "fill")]
extern "C" fn fill(from: u32, to: u32) {
    fill_in(0, from, to, false);
}

/// The number of set voxels.
#[unsafe(export_name = "count")]
extern "C" fn count() -> u32 {
    fill_in(0, 0, 0, true)
}

/// Sets the voxels of one triangle in a grid of its own, whose words follow the words of the grid.
/// Returns the number of its voxels.
#[unsafe(export_name = "mark")]
extern "C" fn mark(triangle: u32) -> u32 {
    fill_in(1, triangle, triangle.saturating_add(1), true)
}

/// Marks where the triangles from one index to another cross the rows of a solid; triangle 0 begins
/// a new solid.
#[unsafe(export_name = "cross")]
extern "C" fn cross(from: u32, to: u32) {
    let State { tree: Some(tree), grid: Some(grid), words, lines, .. } = &mut *state() else {
        return;
    };
    let solid = if from == 0 {
        let Some(table) = table(0, grid.line_words::<u32>()) else { return };
        *lines = table;
        Solid::new(grid, words, lines)
    } else {
        Solid::resume(grid, words, lines)
    };
    if let Ok(mut solid) = solid {
        voxels::cross(&mut solid, &tree.mesh(), from as usize..to as usize);
    }
}

/// Sets the voxels of the solid whose centres are inside. Returns the number of rows without an
/// inside, where the mesh is open.
#[unsafe(export_name = "finish")]
extern "C" fn finish() -> u32 {
    let State { grid: Some(grid), words, lines, .. } = &mut *state() else { return 0 };
    let mut lines = core::mem::take(lines);
    let Ok(mut solid) = Solid::resume(grid, words, &mut lines) else { return 0 };
    solid.finish();
    solid.open_rows().count() as u32
}

/// The address of the grid's words.
#[unsafe(export_name = "words")]
extern "C" fn words() -> *const u32 {
    state().words.as_ptr()
}

fn vector(first: usize) -> [f32; 3] {
    [0, 1, 2].map(|i| f32::from_bits(ask(first + i)))
}

/// The index plus one of the first triangle on the ray from numbers 0 to 2 along 3 to 5, or zero.
/// Numbers 0 to 2 are then t, u and v, and number 3 is one if the ray hits the back face.
#[unsafe(export_name = "pick")]
extern "C" fn pick() -> u32 {
    let (Some(tree), Ok(ray)) = (&state().tree, Ray::new(vector(0), vector(3))) else { return 0 };
    tree.as_tree().first_hit(&ray).map_or(0, |(triangle, hit)| {
        say(0, &[hit.t, hit.u, hit.v].map(f32::to_bits));
        say(3, &[(hit.facing == Facing::Back).into()]);
        triangle as u32 + 1
    })
}

/// Whether the point of numbers 0 to 2 is outside (0), inside (1) or on a triangle (2).
#[unsafe(export_name = "inside")]
extern "C" fn inside() -> u32 {
    let Some(tree) = &state().tree else { return 0 };
    tree.as_tree().winding(vector(0)).map_or(2, |winding| (winding % 2 != 0).into())
}
