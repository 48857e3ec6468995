//! Whether a ray hits a triangle, exactly, in I16F16.

#![no_std]
#![no_main]

use fixed::types::I16F16;
use septum::{Ray, Triangle};
use septum_size as _;

#[unsafe(no_mangle)]
pub fn _start(ray: &Ray<I16F16>, triangle: &Triangle<I16F16>) -> bool {
    ray.is_hit(triangle)
}
