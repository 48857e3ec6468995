//! How many triangles of a mesh an oriented box meets, in I16F16 near the origin.

#![no_std]
#![no_main]

use fixed::types::I16F16;
use septum::Obb;
use septum::mesh::Tree;
use septum::near::Near;
use septum_size as _;

#[unsafe(no_mangle)]
pub fn _start(tree: &Near<Tree<'_, I16F16, u16>>, obb: &Near<Obb<I16F16>>) -> usize {
    tree.overlapping(obb).count()
}
