//! A tree that is built over a mesh in I16F16, and asked whether a box meets it.

#![no_std]
#![no_main]

use fixed::types::I16F16;
use septum::mesh::{Mesh, Node, Tree};
use septum::{Aabb, Vec3};
use septum_size as _;

#[unsafe(no_mangle)]
pub fn _start(
    vertices: &[Vec3<I16F16>],
    triangles: &[[u16; 3]],
    nodes: &mut [Node],
    order: &mut [u16],
    aabb: &Aabb<I16F16>,
) -> Option<usize> {
    let tree = Tree::build(Mesh::new(vertices, triangles).ok()?, nodes, order).ok()?;
    tree.overlapping(aabb).next()
}
