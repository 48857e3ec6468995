//! One exact query in f32 near the origin.

#![no_std]
#![no_main]

use septum::near::Near;
use septum::{Aabb, Triangle};
use septum_size as _;

#[unsafe(no_mangle)]
pub fn _start(triangle: &Near<Triangle<f32>>, aabb: &Near<Aabb<f32>>) -> bool {
    triangle.overlaps(aabb)
}
