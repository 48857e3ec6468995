//! The first triangle of a mesh that a ray hits, in I16F16 near the origin.

#![no_std]
#![no_main]

use fixed::types::I16F16;
use septum::mesh::Tree;
use septum::near::Near;
use septum::{Hit, Ray};
use septum_size as _;

#[unsafe(no_mangle)]
pub fn _start(
    tree: &Near<Tree<'_, I16F16, u16>>,
    ray: &Near<Ray<I16F16>>,
) -> Option<(usize, Hit<I16F16>)> {
    tree.first_hit(ray)
}
