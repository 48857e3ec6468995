//! One exact query in I16F16; `_start` is where the linker looks for what is used.

#![no_std]
#![no_main]

use fixed::types::I16F16;
use septum::{Aabb, Triangle};
use septum_size as _;

#[unsafe(no_mangle)]
pub fn _start(triangle: &Triangle<I16F16>, aabb: &Aabb<I16F16>) -> bool {
    triangle.overlaps(aabb)
}
