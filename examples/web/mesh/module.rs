//! The exports of the module for meshes: voxels, picking, and inside or outside.
//!
//! The memory behind the module's own is a row of tables: vertices, triangles, the tree's order and
//! its nodes, and then either edges to be sorted, or the bits of two grids. It grows as a mesh
//! needs it, up to [`MOST`] bytes.
#![allow(unsafe_code, reason = "memory of its own, and exports")]

use core::arch::wasm32::{memory_grow, memory_size};
use core::cell::UnsafeCell;
use core::ptr::with_exposed_provenance_mut;
use core::sync::atomic::Ordering;

use septum::mesh::{MeshError, Node};
use septum::voxel::{Bits, Grid, GridError, Solid};
use septum::{Facing, Ray, Vec3};

use crate::numbers::{NUMBERS, ask};
use crate::voxels::{self, Mesh};

type Tree = septum::mesh::Tree<'static, f32, u32>;

/// The most bytes of memory.
const MOST: usize = 96 << 20;
const PAGE: usize = 1 << 16;

struct State {
    /// The numbers of vertices and triangles that there is room for.
    room: [usize; 2],
    /// The address of each table: vertices, triangles, order, nodes, and the rest.
    places: [usize; 5],
    tree: Option<Tree>,
    grid: Option<Grid<f32>>,
    solid: Option<Solid<'static, f32, u32>>,
}

impl State {
    const EMPTY: Self = Self { room: [0; 2], places: [0; 5], tree: None, grid: None, solid: None };
}

/// A cell for a single thread; no export calls another.
struct OneThread(UnsafeCell<State>);
unsafe impl Sync for OneThread {}
static STATE: OneThread = OneThread(UnsafeCell::new(State::EMPTY));

fn state() -> &'static mut State {
    // SAFETY: there is one thread, and each export calls this once.
    unsafe { &mut *STATE.0.get() }
}

/// The address of the first table: the end of the module's own memory.
fn start() -> usize {
    unsafe extern "C" {
        static __heap_base: u8;
    }
    (&raw const __heap_base).addr().next_multiple_of(16)
}

/// The address of each table: vertices, triangles, order, nodes, and the rest.
fn places([vertices, triangles]: [usize; 2]) -> [usize; 5] {
    let sizes = [
        vertices * size_of::<Vec3<f32>>(),
        triangles * size_of::<[u32; 3]>(),
        triangles * size_of::<u32>(),
        Node::count_for(triangles) * size_of::<Node>(),
    ];
    let mut places = [start(); 5];
    for k in 0..4 {
        places[k + 1] = places[k] + sizes[k];
    }
    places
}

/// Whether there is memory up to `end`; requests more if needed.
fn reaches(end: usize) -> bool {
    let more = end.div_ceil(PAGE).saturating_sub(memory_size(0));
    end <= MOST && (more == 0 || memory_grow(0, more) != usize::MAX)
}

/// # Safety
/// There is memory for the table, aligned, of valid numbers, and no other reference to it.
unsafe fn table<T>(place: usize, length: usize) -> &'static mut [T] {
    unsafe { core::slice::from_raw_parts_mut(with_exposed_provenance_mut(place), length) }
}

/// Writes an answer to the numbers from `first` on.
fn say(first: usize, answer: &[u32]) {
    for (number, &bits) in NUMBERS.iter().skip(first).zip(answer) {
        number.store(bits, Ordering::Relaxed);
    }
}

/// Makes room for a mesh, and forgets the previous one. The caller writes its vertices at the
/// address returned, three `f32` each, and behind them its triangles, three `u32` each. Zero if
/// there is not enough memory.
#[unsafe(export_name = "room")]
extern "C" fn room(vertices: u32, triangles: u32) -> usize {
    let state = state();
    *state = State::EMPTY;
    let counts = [vertices as usize, triangles as usize];
    // More than this fits no memory, and sizes of fewer do not overflow.
    if counts.iter().any(|&n| n > MOST / 8) {
        return 0;
    }
    let places = places(counts);
    let [place, .., rest] = places;
    let edges = 3 * counts[1] * size_of::<[u32; 2]>();
    if !reaches(rest + edges) {
        return 0;
    }
    (state.room, state.places) = (counts, places);
    place
}

/// Takes the mesh that was written, and builds the tree over it. Zero if the mesh is invalid.
#[unsafe(export_name = "build")]
extern "C" fn build() -> u32 {
    let state = state();
    (state.tree, state.grid, state.solid) = (None, None, None);
    let [vertices, triangles] = state.room;
    let [a, b, c, d, _] = state.places;
    // No room was made.
    if a == 0 {
        return 0;
    }
    // SAFETY: `room` has reserved the memory, all bits are valid numbers, and all references ended
    // with the previous tree.
    let tree = unsafe {
        Mesh::new(table(a, vertices), table(b, triangles)).and_then(|mesh| {
            Tree::build(mesh, table(d, Node::count_for(triangles)), table(c, triangles))
        })
    };
    state.tree = tree.ok();
    state.tree.is_some().into()
}

/// One if the mesh is closed; otherwise zero, and numbers 0 and 1 are the vertices of an open edge.
/// The grid is lost, because its memory is used for sorting edges.
#[unsafe(export_name = "closed")]
extern "C" fn closed() -> u32 {
    let state = state();
    (state.grid, state.solid) = (None, None);
    let Some(tree) = &state.tree else { return 0 };
    let [.., rest] = state.places;
    // SAFETY: `room` has reserved the memory, and nothing refers to it.
    let edges = unsafe { table(rest, 3 * state.room[1]) };
    match tree.mesh().check_closed(edges) {
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
    let state = state();
    (state.grid, state.solid) = (None, None);
    let Some(tree) = &state.tree else { return 1 };
    let grid = match voxels::grid_around(tree.mesh(), resolution) {
        Ok(grid) => grid,
        Err(GridError::CellNotPositive) => return 2,
        Err(GridError::CellTooSmall) => return 3,
        Err(_) => return 4,
    };
    let [.., rest] = state.places;
    let (words, lines) = (grid.words::<u32>(), grid.line_words::<u32>());
    if words > MOST / 8 || !reaches(rest + (2 * words + lines) * size_of::<u32>()) {
        return 5;
    }
    // SAFETY: the memory has been reserved, and nothing refers to it.
    unsafe { table::<u32>(rest, words) }.fill(0);
    say(0, &grid.resolution());
    say(3, &grid.origin().to_array().map(f32::to_bits));
    say(6, &[grid.cell().x.to_bits()]);
    state.grid = Some(grid);
    0
}

/// The words of the grid's bits (0), of the bits of one triangle (1), or of a bit for each row (2).
///
/// # Safety
/// No reference to them may be alive.
unsafe fn words(state: &State, which: usize) -> &'static mut [u32] {
    let Some(grid) = &state.grid else { return &mut [] };
    let (words, lines) = (grid.words::<u32>(), grid.line_words::<u32>());
    let [.., rest] = state.places;
    let count = if which == 2 { lines } else { words };
    // SAFETY: `grid` has reserved the memory.
    unsafe { table(rest + which * words * size_of::<u32>(), count) }
}

/// Sets the voxels that triangles meet, and counts all set voxels if requested.
fn fill_in(which: usize, from: u32, to: u32, is_to_count: bool) -> u32 {
    let state = state();
    state.solid = None;
    let (Some(tree), Some(grid)) = (&state.tree, &state.grid) else { return 0 };
    // SAFETY: the solid has been dropped, and no other reference is kept.
    let words = unsafe { words(state, which) };
    if which == 1 {
        words.fill(0);
    }
    let Ok(mut bits) = Bits::new(grid, words) else { return 0 };
    voxels::fill(&mut bits, tree.mesh(), from as usize..to as usize);
    if is_to_count { bits.count() as u32 } else { 0 }
}

/// Sets the voxels that the triangles from one index to another meet. It first finishes a solid.
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
    let state = state();
    let (Some(tree), Some(grid)) = (&state.tree, &state.grid) else { return };
    if from == 0 {
        state.solid = None;
        // SAFETY: the previous solid has been dropped, and no other reference is kept.
        let (bits, lines) = unsafe { (words(state, 0), words(state, 2)) };
        state.solid = Solid::new(grid, bits, lines).ok();
    }
    if let Some(solid) = &mut state.solid {
        voxels::cross(solid, tree.mesh(), from as usize..to as usize);
    }
}

/// Sets the voxels of the solid whose centres are inside. Returns the number of rows without an
/// inside, where the mesh is open.
#[unsafe(export_name = "finish")]
extern "C" fn finish() -> u32 {
    let state = state();
    let Some(solid) = &mut state.solid else { return 0 };
    solid.finish();
    let open = solid.open_rows().count() as u32;
    state.solid = None;
    open
}

/// The address of the grid's words.
#[unsafe(export_name = "words")]
extern "C" fn words_at() -> *const u32 {
    let state = state();
    state.solid = None;
    // SAFETY: the solid has been dropped, and no other reference is kept.
    unsafe { words(state, 0) }.as_ptr()
}

fn vector(first: usize) -> [f32; 3] {
    [0, 1, 2].map(|i| f32::from_bits(ask(first + i)))
}

/// The index plus one of the first triangle on the ray from numbers 0 to 2 along 3 to 5, or zero.
/// Numbers 0 to 2 are then t, u and v, and number 3 is one if the ray hits the back face.
#[unsafe(export_name = "pick")]
extern "C" fn pick() -> u32 {
    let (Some(tree), Ok(ray)) = (&state().tree, Ray::new(vector(0), vector(3))) else { return 0 };
    tree.first_hit(&ray).map_or(0, |(triangle, hit)| {
        say(0, &[hit.t, hit.u, hit.v].map(f32::to_bits));
        say(3, &[(hit.facing == Facing::Back).into()]);
        triangle as u32 + 1
    })
}

/// Whether the point of numbers 0 to 2 is outside (0), inside (1) or on a triangle (2).
#[unsafe(export_name = "inside")]
extern "C" fn inside() -> u32 {
    let Some(tree) = &state().tree else { return 0 };
    tree.winding(vector(0)).map_or(2, |winding| (winding % 2 != 0).into())
}
