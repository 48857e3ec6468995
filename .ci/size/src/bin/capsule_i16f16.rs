//! Whether a capsule meets a triangle, exactly, in I16F16.

#![no_std]
#![no_main]

use fixed::types::I16F16;
use septum::{Capsule, Triangle};
use septum_size as _;

#[unsafe(no_mangle)]
pub fn _start(capsule: &Capsule<I16F16>, triangle: &Triangle<I16F16>) -> bool {
    capsule.overlaps(triangle)
}
