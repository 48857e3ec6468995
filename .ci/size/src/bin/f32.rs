//! One exact query in f32; `_start` is where the linker looks for what is used.

#![no_std]
#![no_main]

use septum::{Aabb, Triangle};
use septum_size as _;

#[unsafe(no_mangle)]
pub fn _start(triangle: &Triangle<f32>, aabb: &Aabb<f32>) -> bool {
    triangle.overlaps(aabb)
}
