//! A ray, an axis-aligned and an oriented box against a triangle, in I16F16 near the origin.

#![no_std]
#![no_main]

use fixed::types::I16F16;
use septum::near::Near;
use septum::{Aabb, Hit, Obb, Ray, Triangle};
use septum_size as _;

#[unsafe(no_mangle)]
pub fn _start(
    triangle: &Near<Triangle<I16F16>>,
    ray: &Near<Ray<I16F16>>,
    aabb: &Near<Aabb<I16F16>>,
    obb: &Near<Obb<I16F16>>,
) -> (Option<Hit<I16F16>>, [bool; 3]) {
    (ray.hit(triangle), [ray.is_hit(triangle), triangle.overlaps(aabb), triangle.overlaps(obb)])
}
