//! Whether a ray hits a mesh, in I16F16 near the origin.

#![no_std]
#![no_main]

use fixed::types::I16F16;
use septum::Ray;
use septum::mesh::Tree;
use septum::near::Near;
use septum_size as _;

#[unsafe(no_mangle)]
pub fn _start(tree: &Near<Tree<'_, I16F16, u16>>, ray: &Near<Ray<I16F16>>) -> bool {
    tree.is_hit(ray)
}
