//! Whether a ray meets an oriented box, in I16F16 near the origin.

#![no_std]
#![no_main]

use fixed::types::I16F16;
use septum::near::Near;
use septum::{Obb, Ray};
use septum_size as _;

#[unsafe(no_mangle)]
pub fn _start(ray: &Near<Ray<I16F16>>, obb: &Near<Obb<I16F16>>) -> bool {
    ray.overlaps(obb)
}
