//! A mesh and its tree from flash in I16F16: checked, and asked for the first hit of a ray and for a
//! point inside.

#![no_std]
#![no_main]

use fixed::types::I16F16;
use septum::mesh::{Mesh, Node, Tree};
use septum::{Hit, Ray, Vec3};
use septum_size as _;

#[unsafe(no_mangle)]
pub fn _start(
    vertices: &[Vec3<I16F16>],
    triangles: &[[u16; 3]],
    nodes: &[Node],
    ray: &Ray<I16F16>,
) -> Option<(usize, Hit<I16F16>)> {
    let tree = Tree::new(Mesh::new(vertices, triangles).ok()?, nodes).ok()?;
    if tree.contains(ray.origin()) {
        return None;
    }
    tree.first_hit(ray)
}
