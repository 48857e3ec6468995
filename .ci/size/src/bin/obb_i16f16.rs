//! One exact query about an oriented box in I16F16.

#![no_std]
#![no_main]

use fixed::types::I16F16;
use septum::{Obb, Triangle};
use septum_size as _;

#[unsafe(no_mangle)]
pub fn _start(triangle: &Triangle<I16F16>, obb: &Obb<I16F16>) -> bool {
    triangle.overlaps(obb)
}
