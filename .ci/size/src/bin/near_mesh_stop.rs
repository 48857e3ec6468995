//! Where a box stops at a mesh, in I16F16 near the origin.

#![no_std]
#![no_main]

use fixed::types::I16F16;
use septum::mesh::Tree;
use septum::near::{Moving, Near};
use septum::{Aabb, Vec3};
use septum_size as _;

#[unsafe(no_mangle)]
pub fn _start(
    tree: &Near<Tree<'_, I16F16, u16>>,
    aabb: &Moving<Aabb<I16F16>, I16F16>,
) -> Option<(Vec3<I16F16>, Option<usize>)> {
    tree.last_free(aabb)
}
