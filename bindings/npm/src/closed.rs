//! Whether a mesh is closed, in steps. The edges are counted in a hash table; the answer is that of
//! [`septum::mesh::Mesh::check_closed`], which sorts them.

use alloc::vec::Vec;

use septum::Vec3;
use spin::Mutex;

use crate::memory::{Slots, lock, say};
use crate::mesh::with;

/// An edge as the indices of its ends, and whether an odd number of triangles so far has it. Ends
/// are in the order of positions, and of the edges at one place the least is kept.
#[derive(Clone, Copy)]
struct Edge {
    ends: [u32; 2],
    is_odd: bool,
}

const FREE: Edge = Edge { ends: [u32::MAX; 2], is_odd: false };

/// Edges by the hashes of their places, and the first open edge so far.
struct Count {
    table: Vec<Edge>,
    room: usize,
    first: Option<([[i32; 3]; 2], [u32; 2])>,
}

static COUNTS: Mutex<Slots<Count>> = Mutex::new(Slots::EMPTY);

/// A position in an order of integers. Both zeros are one.
#[inline(always)]
fn place(vertices: &[Vec3<f32>], i: u32) -> [i32; 3] {
    let place = vertices.get(i as usize).copied().unwrap_or(Vec3::splat(0.0));
    place.to_array().map(|x| {
        let bits = (x + 0.0).to_bits() as i32;
        if bits < 0 { !(bits & i32::MAX) } else { bits }
    })
}

#[inline(always)]
fn hash(ends: [[i32; 3]; 2]) -> usize {
    let mix = |hash: u32, x: i32| (hash.rotate_left(5) ^ x as u32).wrapping_mul(0x9e37_79b9);
    let hash = ends.into_iter().flatten().fold(0, mix);
    (hash ^ hash >> 15) as usize
}

/// The handle of a count of edges whose table is still to be made, or -1 if there is no memory.
#[unsafe(export_name = "edges")]
extern "C" fn edges(mesh: usize) -> i32 {
    with(mesh, -1, |tree| {
        // A quarter stays free.
        let room = (4 * tree.mesh().triangles().len() + 1).next_power_of_two();
        let mut table = Vec::new();
        if table.try_reserve_exact(room).is_err() {
            return -1;
        }
        lock(&COUNTS).keep(Count { table, room, first: None })
    })
}

/// Makes so many entries more of the table, and returns how many are missing.
#[unsafe(export_name = "more_edges")]
extern "C" fn more_edges(count: usize, entries: usize) -> usize {
    let mut counts = lock(&COUNTS);
    let Some(Count { table, room, .. }) = counts.get_mut(count) else { return 0 };
    let missing = *room - table.len();
    table.resize(table.len() + missing.min(entries), FREE);
    *room - table.len()
}

/// Counts the edges of the triangles from one index to another, in a whole table.
#[unsafe(export_name = "count_edges")]
extern "C" fn count_edges(count: usize, mesh: usize, from: usize, to: usize) {
    with(mesh, (), |tree| {
        let vertices = tree.mesh().vertices();
        let mut counts = lock(&COUNTS);
        let Some(Count { table, .. }) = counts.get_mut(count) else { return };
        for &[a, b, c] in tree.mesh().triangles().iter().take(to).skip(from) {
            for (from, to) in [(a, b), (b, c), (c, a)] {
                let (start, end) = (place(vertices, from), place(vertices, to));
                if start == end {
                    continue;
                }
                let (ends, places) = if start > end {
                    ([to, from], [end, start])
                } else {
                    ([from, to], [start, end])
                };
                let mut at = hash(places);
                loop {
                    at &= table.len() - 1;
                    let edge = &mut table[at];
                    if edge.ends == FREE.ends {
                        *edge = Edge { ends, is_odd: true };
                        break;
                    }
                    if edge.ends.map(|i| place(vertices, i)) == places {
                        *edge = Edge { ends: edge.ends.min(ends), is_odd: !edge.is_odd };
                        break;
                    }
                    at += 1;
                }
            }
        }
    });
}

/// Looks for open edges in the table from one entry to another. Writes the vertices of the first so
/// far, in the order of positions, and returns 1, or 0 if there is none.
#[unsafe(export_name = "open_edge")]
extern "C" fn open_edge(count: usize, mesh: usize, from: usize, to: usize) -> u32 {
    with(mesh, 0, |tree| {
        let vertices = tree.mesh().vertices();
        let mut counts = lock(&COUNTS);
        let Some(Count { table, first, .. }) = counts.get_mut(count) else { return 0 };
        for edge in table.iter().take(to).skip(from).filter(|edge| edge.is_odd) {
            let open = (edge.ends.map(|i| place(vertices, i)), edge.ends);
            if first.is_none_or(|least| open < least) {
                *first = Some(open);
            }
        }
        if let Some((_, ends)) = first {
            say(0, ends);
        }
        first.is_some().into()
    })
}

/// Gives the memory of a count back.
#[unsafe(export_name = "drop_edges")]
extern "C" fn drop_edges(count: usize) {
    lock(&COUNTS).take(count);
}
