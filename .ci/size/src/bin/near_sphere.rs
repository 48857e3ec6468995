//! Whether a sphere meets a triangle, in I16F16 near the origin.

#![no_std]
#![no_main]

use fixed::types::I16F16;
use septum::near::Near;
use septum::{Sphere, Triangle};
use septum_size as _;

#[unsafe(no_mangle)]
pub fn _start(sphere: &Near<Sphere<I16F16>>, triangle: &Near<Triangle<I16F16>>) -> bool {
    sphere.overlaps(triangle)
}
