//! A built tree beside the plain description of it, by sorting.

use std::vec;
use std::vec::Vec;

use super::super::{Tree, TreeBuilder};
use super::cut::middle;
use super::*;
use crate::arithmetic::Each;
use crate::random::Random;
use crate::shape::Vec3;

extern crate std;

/// The order of the triangles: each node sorts its part along the axis of greatest spread, and
/// each half again.
fn sorted<S: Scalar>(mesh: &Mesh<'_, S, u16>) -> Vec<u16> {
    let (grid, layout) = (Grid::around(mesh), Layout::new(mesh.triangles().len()));
    let middles = |i: u16| middle(&grid.cell(mesh.known(i.into()).corners()));
    let sort = |part: &mut [u16]| {
        let spread = |axis: usize| {
            let all = || part.iter().map(|&i| middles(i)[axis]);
            grid.size(axis, all().max().unwrap_or(0) - all().min().unwrap_or(0))
        };
        let axis = (0..3).rev().max_by_key(|&axis| spread(axis)).unwrap();
        part.sort_by_key(|&i| (middles(i)[axis], i));
    };
    let mut order: Vec<u16> = (0..mesh.triangles().len() as u16).collect();
    for node in 0..layout.nodes {
        let all = layout.below(node);
        let ends: Vec<usize> = layout.children(node).map(|place| layout.below(place).end).collect();
        let half: usize = ends.get(1).copied().unwrap_or(all.end);
        if half < all.end {
            sort(&mut order[all.clone()]);
        }
        if ends[0] < half {
            sort(&mut order[all.start..half]);
        }
        if ends.get(2).is_some_and(|&end| end < all.end) {
            sort(&mut order[half..all.end]);
        }
    }
    order.chunks_mut(LEAF).for_each(|leaf| leaf.sort());
    order
}

/// Builds at once, with scratch memory, and in steps; the order is the same as by sorting, and so
/// are the nodes.
fn check<S: Scalar>(points: &[[i16; 3]], of: fn(i16) -> S, step: usize) {
    let vertices: Vec<Vec3<S>> = points.iter().map(|p| p.each(of).into()).collect();
    let faces: Vec<[u16; 3]> =
        (0..points.len() as u16 / 3).map(|i| [0, 1, 2].each(|k| 3 * i + k)).collect();
    let mesh = Mesh::new(&vertices, &faces).unwrap();
    let memory = || (vec![Node::EMPTY; Node::count_for(faces.len())], vec![0; faces.len()]);

    let (mut nodes, mut order) = memory();
    let tree = Tree::build(mesh, &mut nodes, &mut order).unwrap();
    let expected: Vec<_> = sorted(&mesh).into_iter().map(usize::from).collect();
    assert_eq!(tree.order().collect::<Vec<_>>(), expected, "{points:?}");

    let (mut nodes, mut order) = memory();
    let mut scratch = vec![Scratch::EMPTY; faces.len()];
    let mut builder = TreeBuilder::new(mesh, &mut nodes, &mut order, &mut scratch).unwrap();
    let mut progress = 0.0;
    while !builder.advance(step) {
        assert!(builder.progress() >= progress && builder.progress() <= 1.0);
        progress = builder.progress();
    }
    assert_eq!(builder.progress(), 1.0);
    let stepped = builder.finish();
    assert_eq!(stepped.order().collect::<Vec<_>>(), expected, "{points:?} in steps of {step}");
    assert_eq!(stepped.nodes(), tree.nodes());

    // The boxes enclose what is below them.
    let in_order: Vec<_> = expected.iter().map(|&i| faces[i]).collect();
    assert!(Tree::new(Mesh::new(&vertices, &in_order).unwrap(), tree.nodes()).is_ok());
}

/// A far vertex makes the grid so coarse that all other triangles have one middle.
#[test]
fn triangles_in_one_place_of_the_grid_take_no_more_looks() {
    let count = 4_000_u16;
    let at = |i: u16| Vec3::new(f32::from(i) / 4_000.0, 0.0, 0.0);
    let vertices: Vec<_> = (0..count).map(at).chain([Vec3::new(1e9, 1e9, 1e9)]).collect();
    let faces: Vec<_> = (0..count).map(|i| [i, i, if i == 0 { count } else { i }]).collect();
    let mesh = Mesh::new(&vertices, &faces).unwrap();
    let (mut nodes, mut order) = (vec![Node::EMPTY; Node::count_for(4_000)], vec![0; 4_000]);
    let mut scratch = vec![Scratch::EMPTY; 4_000];
    let mut builder = TreeBuilder::new(mesh, &mut nodes, &mut order, &mut scratch).unwrap();
    let mut looks = 0;
    while !builder.advance(4_000) {
        assert!(builder.progress() < 1.0);
        looks += 1;
    }
    assert!((40..=100).contains(&looks), "{looks}");
}

/// Five triangles, each a point on a grid of 3 by 3: all 59,049 meshes.
#[test]
fn small_trees_are_sorted() {
    for n in 0..9_u32.pow(5) {
        let points: Vec<_> = (0..15)
            .map(|k| {
                let place = (n / 9_u32.pow(k / 3) % 9) as i16;
                [place % 3, 0, place / 3]
            })
            .collect();
        check(&points, f32::from, n as usize % 50 + 1);
    }
}

/// Random triangles, evenly spread or close together, with many ties and with none.
fn trees_are_sorted<S: Scalar>(of: fn(i16) -> S) {
    let mut random = Random(31);
    for n in (0..70).chain([100, 300, 1000, 3001]) {
        for spread in [1, 3, 40, 127] {
            let mut near = [0; 3];
            let points: Vec<_> = (0..3 * n)
                .map(|k| {
                    let mut number = || (random.bits() % (2 * spread + 1)) as i16 - spread as i16;
                    let next = [number(), number(), number()];
                    if k % 3 == 0 || spread == 127 {
                        near = next;
                    }
                    // A cluster at one end, and a long tail.
                    if n % 3 == 0 { near.each(|x| x * x / 128) } else { near }
                })
                .collect();
            check(&points, of, [1, 7, 100, 5000][n % 4]);
        }
    }
}

#[test]
fn trees_in_floats_are_sorted() {
    trees_are_sorted::<f32>(f32::from);
    trees_are_sorted::<f64>(|i| f64::from(i) * 1e300);
}

#[cfg(feature = "fixed")]
#[test]
fn trees_in_fixed_point_are_sorted() {
    use fixed::types::*;
    trees_are_sorted::<I4F4>(|i| I4F4::from_bits(i as i8));
    trees_are_sorted::<I8F8>(|i| I8F8::from_bits(i * 256));
    trees_are_sorted::<I16F16>(|i| I16F16::from_bits(i32::from(i) << 24));
    trees_are_sorted::<I32F32>(|i| I32F32::from_bits(i64::from(i)));
}
