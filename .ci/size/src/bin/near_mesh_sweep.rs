//! The triangle of a mesh that a box first meets on its way, in I16F16 near the origin.

#![no_std]
#![no_main]

use fixed::types::I16F16;
use septum::Aabb;
use septum::mesh::Tree;
use septum::near::{Moving, Near};
use septum::sweep::FirstContact;
use septum_size as _;

#[unsafe(no_mangle)]
pub fn _start(
    tree: &Near<Tree<'_, I16F16, u16>>,
    aabb: &Moving<Aabb<I16F16>, I16F16>,
) -> Option<(usize, FirstContact<I16F16>)> {
    tree.first_contact(aabb)
}
