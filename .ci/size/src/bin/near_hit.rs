//! Where a ray hits a triangle, in I16F16 near the origin.

#![no_std]
#![no_main]

use fixed::types::I16F16;
use septum::near::Near;
use septum::{Hit, Ray, Triangle};
use septum_size as _;

#[unsafe(no_mangle)]
pub fn _start(ray: &Near<Ray<I16F16>>, triangle: &Near<Triangle<I16F16>>) -> Option<Hit<I16F16>> {
    ray.hit(triangle)
}
