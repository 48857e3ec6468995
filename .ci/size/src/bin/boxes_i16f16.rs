//! A tree over moving boxes in I16F16, built anew or refitted: all pairs, and the boxes that a box
//! overlaps.

#![no_std]
#![no_main]

use fixed::types::I16F16;
use septum::Aabb;
use septum::broad_phase::BoxTree;
use septum::mesh::Node;
use septum_size as _;

#[unsafe(no_mangle)]
pub fn _start(
    boxes: &[Aabb<I16F16>],
    nodes: &mut [Node],
    order: &mut [u16],
    is_new: bool,
    pairs: &mut [[u16; 2]],
    found: &mut [u16],
) -> Option<usize> {
    let tree = if is_new {
        BoxTree::build(boxes, nodes, order).ok()?
    } else {
        BoxTree::refit(boxes, nodes, order).ok()?
    };
    let pairs = tree.pairs(pairs).ok()?.len();
    Some(pairs + tree.overlapping(boxes.first()?, found).ok()?.len())
}
