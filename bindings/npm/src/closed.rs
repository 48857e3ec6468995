//! Whether a mesh is closed, in steps. The edges are counted in a hash table; the answer is that of
//! [`septum::mesh::Mesh::check_closed`], which sorts them.

use alloc::vec::Vec;

use septum::Vec3;
use spin::Mutex;

use crate::memory::{Slots, lock, say, table};
use crate::mesh::with;

/// An edge as the indices of its ends, and whether an odd number of triangles so far has it. Ends
/// are in the order of positions, and of the edges at one place the least is kept.
#[derive(Clone, Copy)]
struct Edge {
    ends: [u32; 2],
    is_odd: bool,
}

const FREE: Edge = Edge { ends: [u32::MAX; 2], is_odd: false };

static COUNTS: Mutex<Slots<Vec<Edge>>> = Mutex::new(Slots::EMPTY);

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

/// The handle of a count of edges, or -1 if there is no memory.
#[unsafe(export_name = "edges")]
extern "C" fn edges(mesh: usize) -> i32 {
    with(mesh, -1, |tree| {
        // A quarter stays free.
        let room = (4 * tree.mesh().triangles().len() + 1).next_power_of_two();
        table(FREE, room).map_or(-1, |table| lock(&COUNTS).keep(table))
    })
}

/// Counts the edges of the triangles from one index to another.
#[unsafe(export_name = "count_edges")]
extern "C" fn count_edges(count: usize, mesh: usize, from: usize, to: usize) {
    with(mesh, (), |tree| {
        let vertices = tree.mesh().vertices();
        let mut counts = lock(&COUNTS);
        let Some(table) = counts.get_mut(count) else { return };
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

/// Ends a count: writes the vertices of the first open edge, in the order of positions, and returns
/// 1, or 0 if there is none.
#[unsafe(export_name = "open_edge")]
extern "C" fn open_edge(count: usize, mesh: usize) -> u32 {
    let table = lock(&COUNTS).take(count);
    with(mesh, 0, |tree| {
        let vertices = tree.mesh().vertices();
        let open = table.iter().flatten().filter(|edge| edge.is_odd);
        let first = open.map(|edge| (edge.ends.map(|i| place(vertices, i)), edge.ends)).min();
        if let Some((_, ends)) = first {
            say(0, &ends);
        }
        first.is_some().into()
    })
}

/// Gives the memory of a count back.
#[unsafe(export_name = "drop_edges")]
extern "C" fn drop_edges(count: usize) {
    lock(&COUNTS).take(count);
}
