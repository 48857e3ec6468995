//! One exact query in I8F8; `_start` is where the linker looks for what is used.

#![no_std]
#![no_main]

use fixed::types::I8F8;
use septum::{Aabb, Triangle};
use septum_size as _;

#[unsafe(no_mangle)]
pub fn _start(triangle: &Triangle<I8F8>, aabb: &Aabb<I8F8>) -> bool {
    triangle.overlaps(aabb)
}
